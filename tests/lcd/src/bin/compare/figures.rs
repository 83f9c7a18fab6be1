//! What the ball costs, a figure a line.

use std::fmt;

const HEADER: &str = "ball,core,measure,value";

/// Of a counted line, in its order.
const MEASURES: [&str; 5] = ["pixels", "pixel", "worst pixel", "frame", "stack"];

/// How much of which ball costs on which core: instructions of a pixel of the ball and of a whole frame, bytes of stack
/// and of flash.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    pub ball: String,
    pub core: String,
    pub measure: &'static str,
    pub value: u32,
}

impl fmt::Display for Figure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{},{},{}", self.ball, self.core, self.measure, self.value)
    }
}

/// The figures of a line that the firmware prints.
pub fn counted(core: &str, line: &str) -> Vec<Figure> {
    let mut cells = line.split(',');
    let ball = cells.next().unwrap_or_default();
    let values: Vec<u32> = cells.filter_map(|cell| cell.parse().ok()).collect();
    assert_eq!(values.len(), MEASURES.len(), "{core}: not a count: {line}");
    let figure = |(measure, value)| Figure { ball: ball.to_owned(), core: core.to_owned(), measure, value };
    MEASURES.into_iter().zip(values).map(figure).collect()
}

/// As committed.
pub fn text(figures: &[Figure]) -> String {
    let lines: String = figures.iter().map(|figure| format!("{figure}\n")).collect();
    format!("{HEADER}\n{lines}")
}

/// A committed figure.
pub fn value(table: &str, ball: &str, core: &str, measure: &str) -> Option<u32> {
    let key = format!("{ball},{core},{measure},");
    table.lines().find_map(|line| line.strip_prefix(&key)?.parse().ok())
}

/// What is missing, new, or off by more than 2 % and by more than 1.
pub fn compare(figures: &[Figure], table: &str) -> Vec<String> {
    let off = |figure: &Figure| {
        let before = value(table, &figure.ball, &figure.core, figure.measure);
        let near = |before: u32| figure.value.abs_diff(before) <= (before / 50).max(1);
        (!before.is_some_and(near)).then(|| format!("{figure}, committed is {before:?}"))
    };
    let mut complaints: Vec<String> = figures.iter().filter_map(off).collect();
    if table.lines().next() != Some(HEADER) || table.lines().count() != figures.len() + 1 {
        complaints.push("the table has other columns or other lines".to_owned());
    }
    complaints
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_figure_that_is_off_is_told() {
        let figures = counted("M3", "ball,100,200,300,4000,0");
        let table = text(&figures);
        assert!(compare(&figures, &table).is_empty());
        for (before, after, complaints) in
            [("200", "204", 0), ("200", "205", 1), ("4000", "3930", 0), ("4000", "3900", 1), ("stack,0", "stack,2", 1)]
        {
            assert_eq!(compare(&figures, &table.replace(before, after)).len(), complaints, "{before} {after}");
        }
        assert_eq!(compare(&figures, &table.replace("ball,M3,stack,0\n", "")).len(), 2);
        assert_eq!(compare(&figures[1..], &table).len(), 1);
    }
}
