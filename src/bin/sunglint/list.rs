//! What can be asked for: methods, formats, lights, cases, presets, snippets.

/// All of it, as `sunglint list` prints it.
pub fn text() -> String {
    String::new()
}
