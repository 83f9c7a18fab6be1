//! The groups of a drawing that make up a mark, so that a page can point at it and lead to its method's page.

use kuva::render::render::{Primitive, Scene};

use crate::page;

/// Stands between the name of the method whose page a mark leads to and what the mark says.
const SEPARATOR: char = '\u{1f}';

/// The title of all parts of a mark that leads to the page of `method`.
pub fn title(method: &str, tooltip: &str) -> String {
    format!("{method}{SEPARATOR}{tooltip}")
}

/// Joins the parts of each mark, which kuva draws one by one and gives a title each, to one group with attributes that
/// [`crate::page`] reads.
pub fn join(scene: &mut Scene) {
    let mut joined = Joined::default();
    scene.elements.drain(..).for_each(|primitive| joined.add(primitive));
    joined.close();
    scene.elements = joined.elements;
}

#[derive(Default)]
struct Joined {
    elements: Vec<Primitive>,
    /// Title of the mark that is being drawn.
    mark: Option<String>,
    /// Whether its part is still open.
    inside: bool,
}

impl Joined {
    fn add(&mut self, primitive: Primitive) {
        match primitive {
            Primitive::GroupStart { title: Some(title), transform, .. } => {
                if self.mark.as_ref() != Some(&title) {
                    self.close();
                    self.elements.push(start(transform, &title));
                    self.mark = Some(title);
                }
                self.inside = true;
            }
            Primitive::GroupEnd if self.inside => self.inside = false,
            other => {
                if !self.inside {
                    self.close();
                }
                self.elements.push(other);
            }
        }
    }

    fn close(&mut self) {
        if self.mark.take().is_some() {
            self.elements.push(Primitive::GroupEnd);
        }
    }
}

fn start(transform: Option<String>, title: &str) -> Primitive {
    let (method, tooltip) = title.split_once(SEPARATOR).unwrap_or(("", title));
    let class = "class=\"mark\"".to_owned();
    let attributes = if method.is_empty() { class } else { format!("{class} data-to=\"{}\"", page::slug(method)) };
    Primitive::GroupStart { transform, title: Some(tooltip.to_owned()), extra_attrs: Some(attributes) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(title: &str) -> [Primitive; 3] {
        let start = Primitive::GroupStart { transform: None, title: Some(title.to_owned()), extra_attrs: None };
        [start, line(), Primitive::GroupEnd]
    }

    fn line() -> Primitive {
        let stroke = "#000000".into();
        Primitive::Line { x1: 0.0, y1: 0.0, x2: 1.0, y2: 1.0, stroke, stroke_width: 1.0, stroke_dasharray: None }
    }

    #[test]
    fn the_parts_of_a_mark_are_one_group_within_other_groups() {
        let outer = Primitive::GroupStart { transform: Some("scale(1)".to_owned()), title: None, extra_attrs: None };
        let [a, b] = ["a b", ""].map(|method| title(method, "said"));
        let parts = [part(&a), part(&a), part(&b)].concat();
        let mut scene = Scene::new(1.0, 1.0);
        scene.elements = [vec![outer], parts, vec![line(), Primitive::GroupEnd]].concat();
        join(&mut scene);
        let shape = |primitive: &Primitive| match primitive {
            Primitive::GroupStart { title, extra_attrs, .. } => format!("{title:?} {extra_attrs:?}"),
            Primitive::GroupEnd => "end".to_owned(),
            _ => "line".to_owned(),
        };
        let shapes: Vec<_> = scene.elements.iter().map(shape).collect();
        let expected = [
            "None None",
            "Some(\"said\") Some(\"class=\\\"mark\\\" data-to=\\\"a-b\\\"\")",
            "line",
            "line",
            "end",
            "Some(\"said\") Some(\"class=\\\"mark\\\"\")",
            "line",
            "end",
            "line",
            "end",
        ];
        assert_eq!(shapes, expected);
    }
}
