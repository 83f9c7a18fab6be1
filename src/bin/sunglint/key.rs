//! The key of the charts: a shape for each method, a colour for each number format.

use kuva::plot::MarkerShape;
use sunglint::trial::{Format, Method, Shading};

/// Colours of Okabe and Ito, but brown in place of their yellow, which is too pale on white. Two kinds of red-green
/// blindness and blue-yellow blindness can tell the first seven apart.
const COLOURS: [&str; 8] = ["#000000", "#0072b2", "#56b4e9", "#d55e00", "#e69f00", "#009e73", "#cc79a7", "#7f5a3a"];

const SHAPES: [MarkerShape; 8] = [
    MarkerShape::Triangle,
    MarkerShape::Square,
    MarkerShape::Diamond,
    MarkerShape::Circle,
    MarkerShape::Pentagon,
    MarkerShape::TriangleDown,
    MarkerShape::Star,
    MarkerShape::Plus,
];

/// Methods and formats in the order in which the study names them.
#[derive(Clone, Debug, Default)]
pub struct Key {
    /// Names of the methods.
    pub methods: Vec<String>,
    /// Names of the number formats.
    pub formats: Vec<String>,
}

impl Key {
    /// Key to all `names`, each of a method and of a format.
    pub fn new<'a>(names: impl Iterator<Item = [&'a String; 2]> + Clone) -> Self {
        Self {
            methods: in_order(names.clone().map(|[method, _]| method)),
            formats: in_order(names.map(|[_, format]| format)),
        }
    }

    /// Shape of the marks of `method`.
    pub fn shape(&self, method: &str) -> MarkerShape {
        SHAPES[place(&self.methods, method) % SHAPES.len()]
    }

    /// Colour of the marks of `format`.
    pub fn colour(&self, format: &str) -> &'static str {
        COLOURS[place(&self.formats, format) % COLOURS.len()]
    }
}

/// Each of `names` once, in the order of their first appearance.
pub fn in_order<'a>(names: impl Iterator<Item = &'a String>) -> Vec<String> {
    let mut once: Vec<String> = Vec::new();
    for name in names {
        if !once.contains(name) {
            once.push(name.clone());
        }
    }
    once
}

/// The place of `name` among all formats or methods of the study, so that a filter changes no colour and no shape; of any
/// other name its place in `names`.
fn place(names: &[String], name: &str) -> usize {
    let format = Format::ALL.iter().position(|format| format.name() == name);
    let method = || Method::ALL.iter().position(|method| method.name() == name);
    let shading = || Shading::ALL.iter().position(|shading| shading.name() == name);
    let listed = || names.iter().position(|known| known == name);
    format.or_else(method).or_else(shading).or_else(listed).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_filter_changes_no_colour_and_no_shape() {
        let [cap, f32, other] = ["cap", "f32", "other"].map(str::to_owned);
        let key = Key::new([[&cap, &f32], [&cap, &other]].into_iter());
        assert_eq!([key.colour("f32"), key.colour("other")], [COLOURS[1]; 2]);
        assert!(matches!(key.shape("cap"), MarkerShape::Circle));
    }
}
