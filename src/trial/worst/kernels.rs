//! The kernels of which every input has been tried, by `tests/exhaustive`, and the worst input of each.

/// One line for each kernel and format: how many inputs, the raw bits of the worst and its error, the bound that is
/// asserted, the unit of both, the day.
pub const TABLE: &str = include_str!("kernels.csv");

/// What was found when all inputs were tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proof {
    /// Name of the kernel.
    pub kernel: &'static str,
    /// Name of the number format, or of the integers.
    pub format: &'static str,
    /// How many inputs there are.
    pub inputs: u64,
    /// Raw bits of the worst.
    pub bits: u64,
    /// Its error, to six digits behind the point.
    pub error: f64,
    /// What is asserted of all errors.
    pub bound: f64,
    /// What errors are counted in; a `step` is that between the format's numbers just below 1.
    pub unit: &'static str,
}

/// All proofs. A line that says nothing is left out, which `tests/exhaustive` notices.
pub fn proofs() -> impl Iterator<Item = Proof> {
    TABLE.lines().skip(1).filter_map(proof)
}

fn proof(line: &'static str) -> Option<Proof> {
    let mut columns = line.split(';');
    let mut next = || columns.next();
    Some(Proof {
        kernel: next()?,
        format: next()?,
        inputs: next()?.parse().ok()?,
        bits: u64::from_str_radix(next()?.strip_prefix("0x")?, 16).ok()?,
        error: next()?.parse().ok()?,
        bound: next()?.parse().ok()?,
        unit: next()?,
    })
}
