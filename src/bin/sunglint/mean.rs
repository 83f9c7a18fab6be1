//! The two means of an error.

/// Whether the worst error is meant, or the root of the mean square.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mean {
    /// Root mean square.
    Rms,
    /// The worst.
    Max,
}

impl Mean {
    /// Both of them, in the order in which they are shown.
    pub const ALL: [Self; 2] = [Self::Rms, Self::Max];

    /// Short name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rms => "rms",
            Self::Max => "max",
        }
    }

    /// Name in front of a noun.
    pub fn adjective(self) -> &'static str {
        match self {
            Self::Rms => "Root mean square",
            Self::Max => "Worst",
        }
    }
}
