//! How wrong the peers are whose instructions are counted, as `tests/peers` has measured them.

/// A line for each function, format and peer.
pub const TABLE: &str = include_str!("peers.csv");

/// A line of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peer {
    /// What is computed, by the names of the table of counts.
    pub function: &'static str,
    /// The format, by the same names.
    pub format: &'static str,
    /// Whose, with its version.
    pub by: &'static str,
    /// Worst error: of directions against the exact value of the same formula, under the Sun from Earth.
    pub error: f64,
    /// What that is in.
    pub unit: &'static str,
    /// On which inputs.
    pub how: &'static str,
    /// Where it fails.
    pub note: &'static str,
}

/// All lines. One that says nothing is left out, which `tests/chip.rs` notices.
pub fn rows() -> impl Iterator<Item = Peer> {
    TABLE.lines().skip(1).filter_map(row)
}

fn row(line: &'static str) -> Option<Peer> {
    let mut columns = line.split(',');
    let mut next = || columns.next();
    let (function, format, by) = (next()?, next()?, next()?);
    let error = next()?.parse().ok()?;
    Some(Peer { function, format, by, error, unit: next()?, how: next()?, note: next()? })
}
