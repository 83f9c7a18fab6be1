//! What calls cost on microcontrollers: instructions, stack and bytes, as `tests/firmware/run` has counted them.

mod inputs;
pub mod peers;

pub use inputs::{Case, INPUTS, Pixel, WIDTHS, numbers, pairs, pixels};

/// The compiler that has made what is counted: another one may count otherwise.
pub const RUSTC: &str = include_str!("chip/rustc.txt").trim_ascii();

/// A line for each function, format, author and case.
pub const TABLE: &str = include_str!("chip/counts.csv");

/// The three cores that are counted on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Core {
    /// Cortex-M0+: thumbv6m, neither a product of 64 bits nor a count of leading zeros.
    M0,
    /// Cortex-M3: thumbv7m.
    M3,
    /// Cortex-M4F: thumbv7em with hardware for f32.
    M4,
}

impl Core {
    /// All of them, in the order of the table's columns.
    pub const ALL: [Self; 3] = [Self::M0, Self::M3, Self::M4];

    /// Name, as tables and charts print it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::M0 => "M0+",
            Self::M3 => "M3",
            Self::M4 => "M4F",
        }
    }
}

/// What a call costs on a core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    /// Instructions from the call to the return: half of the inputs take no more.
    pub median: u32,
    /// The most that any input takes.
    pub worst: u32,
    /// Bytes of stack at the deepest.
    pub stack: u32,
    /// Bytes of code, with all that it calls, at `opt-level = "s"`.
    pub text: u32,
    /// Bytes of tables and constants.
    pub rodata: u32,
}

/// A line of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// What is computed: a direction method, a building block, a highlight method, `pixel` and a highlight method.
    pub function: &'static str,
    /// The format, by the names of [`Format`](super::Format), or a peer's own.
    pub format: &'static str,
    /// Whose: `sunglint`, `formula` where a format has code of its own beside that, or a peer with its version.
    pub by: &'static str,
    /// Which inputs: `inside` or `outside` the disc, or `any`.
    pub case: &'static str,
    /// How many inputs.
    pub inputs: u32,
    /// On each of [`Core::ALL`]; none where it fails or does not build, as the note says.
    pub costs: [Option<Cost>; 3],
    /// What else there is to say.
    pub note: &'static str,
}

impl Row {
    /// On one core.
    pub fn on(&self, core: Core) -> Option<Cost> {
        self.costs[core as usize]
    }
}

/// All lines. One that says nothing is left out, which `tests/chip.rs` notices.
pub fn rows() -> impl Iterator<Item = Row> {
    TABLE.lines().skip(1).filter_map(row)
}

fn row(line: &'static str) -> Option<Row> {
    let mut columns = line.split(',');
    let mut next = || columns.next();
    let (function, format, by, case) = (next()?, next()?, next()?, next()?);
    let inputs = next()?.parse().ok()?;
    let mut costs = [None; 3];
    for cost in &mut costs {
        let mut figures = [None; 5];
        for figure in &mut figures {
            *figure = next()?.parse().ok();
        }
        let [median, worst, stack, text, rodata] = figures;
        *cost = median
            .zip(worst)
            .zip(stack)
            .zip(text)
            .zip(rodata)
            .map(|((((median, worst), stack), text), rodata)| Cost { median, worst, stack, text, rodata });
    }
    Some(Row { function, format, by, case, inputs, costs, note: next()? })
}
