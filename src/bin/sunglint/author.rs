//! Whose code is measured and counted, by the names of the table of counts.

use sunglint::trial::chip::peers::{self, Peer};

/// This crate's own, in the way that a format always calls it.
pub const OURS: &str = "sunglint";

/// f32 in integers: `sunglint::soft`.
pub const SOFT: &str = "sunglint soft";

/// The generic code of a format that has code of its own.
pub const FORMULA: &str = "formula";

/// A whole pixel with code of its own: `sunglint::raw::PixelQ14`.
pub const PIXEL_Q14: &str = "PixelQ14";

/// Whether it is what a format always runs.
pub fn is_ours(by: &str) -> bool {
    by == OURS
}

/// Whether it is somebody else's.
pub fn is_peer(by: &str) -> bool {
    !by.starts_with(OURS) && ![FORMULA, PIXEL_Q14].contains(&by)
}

/// How the code of a peer fails, by what `tests/peers` has noted, if it does.
pub fn failure_of_peer(function: &str, format: &str, by: &str) -> Option<&'static str> {
    let same = |peer: &Peer| [peer.function, peer.format, peer.by] == [function, format, by];
    let note = peers::rows().find(same)?.note;
    ["never returns", "wraps"].into_iter().find(|failure| note.contains(failure))
}

/// What is written beside a mark.
pub fn label(format: &str, by: &str) -> String {
    match by {
        OURS => format.to_owned(),
        SOFT => format!("{format} soft"),
        PIXEL_Q14 => by.to_owned(),
        _ => format!("{format} {by}"),
    }
}

/// The same in full.
pub fn said(format: &str, by: &str) -> String {
    if is_ours(by) { format.to_owned() } else { format!("{format} by {by}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peers_are_those_who_are_not_of_this_crate() {
        assert!([OURS, SOFT, FORMULA, PIXEL_Q14].iter().all(|by| !is_peer(by)));
        assert!(is_peer("libm 0.2.16") && is_peer("fixed 1.31.0"));
    }

    #[test]
    fn peers_that_answer_wrongly_or_never_fail() {
        let failure = |function, format, by| failure_of_peer(function, format, by);
        assert_eq!(failure("root", "I16F16", "cordic 0.1.5"), Some("never returns"));
        assert_eq!(failure("normalize", "I2F30", "fixed 1.31.0"), Some("wraps"));
        assert_eq!(failure("normalize", "f32", "libm 0.2.16"), None);
        assert_eq!(failure("normalize", "I2F30", OURS), None);
    }

    #[test]
    fn labels_tell_all_of_a_format_apart() {
        let labels = [OURS, SOFT, FORMULA, PIXEL_Q14, "libm 0.2.16"].map(|by| label("f32", by));
        assert_eq!(labels, ["f32", "f32 soft", "f32 formula", "PixelQ14", "f32 libm 0.2.16"]);
    }
}
