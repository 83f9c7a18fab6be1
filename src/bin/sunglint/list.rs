//! What can be asked for: methods, formats, lights, cases, presets, snippets.

use sunglint::trial::gloss::CASES;
use sunglint::trial::quantity::Quantity;
use sunglint::trial::{Format, Method, Shading, lights};

use crate::filter::quoted;
use crate::kernel::Kernel;
use crate::{presets, snippets};

/// All of it, as `sunglint list` prints it.
pub fn text() -> String {
    let before = |text: &'static str, end: &str| text.split_once(end).map_or(text, |(before, _)| before);
    let first = |sentences| before(before(sentences, ". The error"), ", with its");
    let lights = lights::STUDY.map(|light| (light.name, format!("ratio {}", light.light.sin())));
    let cases = CASES.map(|case| (case.name, format!("ratio {}", case.light.sin())));
    let snippets = snippets::ALL.iter().map(|snippet| (snippet.method, snippet.language.name().to_owned()));
    [
        part("Direction methods", "worst --method cap", Method::ALL.map(|method| (method.name(), direction(method)))),
        part("Highlight methods", "--method karis", Shading::ALL.map(|method| (method.name(), highlight(method)))),
        part(
            "Building blocks",
            "worst --method tint",
            Kernel::ALL.map(|kernel| (kernel.name(), first(kernel.about()))),
        ),
        part("Light quantities", "--method size_factor", Quantity::ALL.map(|one| (one.name(), quantity(one)))),
        part(
            "Number formats",
            "--format I2F14 --format f16",
            Format::ALL.map(|format| (format.name(), number(format))),
        ),
        part("Lights of directions", "--light mars", lights),
        part("Cases of lit pixels: light and roughness", "worst --light 'alpha 0.001'", cases),
        part("Reported failures", "preset", presets::names()),
        part("Source code to take away", "snippet cap --language glsl", snippets),
    ]
    .concat()
}

/// A heading with a command, and a line for each name; nothing for no names.
fn part<S: AsRef<str>>(title: &str, command: &str, names: impl IntoIterator<Item = (&'static str, S)>) -> String {
    let names: Vec<_> = names.into_iter().map(|(name, about)| (quoted(name), about)).collect();
    let width = names.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    let line = |(name, about): &(String, S)| format!("  {name:width$}  {}\n", about.as_ref());
    let lines: String = names.iter().map(line).collect();
    if lines.is_empty() { lines } else { format!("{title} (sunglint {command})\n{lines}\n") }
}

fn direction(method: Method) -> &'static str {
    match method {
        Method::Epic => "Epic's representative point as published, with the light's distance",
        Method::Factored => "the same with the distance divided out",
        Method::Disc => "the nearest direction of the disc, told by the cosine",
        Method::Cap => "the nearest direction of the disc, told by the sine; the one to take",
    }
}

fn highlight(method: Shading) -> &'static str {
    match method {
        Shading::None => "GGX at the disc's point nearest to the mirror ray, too bright",
        Shading::Karis => "the same times (alpha / (alpha + x/2))^2, x being the light's ratio",
        Shading::KarisThird => "the same with x/3",
        Shading::ExactRp => "the same with the energy that the shape has for small angles",
        Shading::DiscGgx => "GGX averaged over the disc, taken as a circle",
        Shading::Directional => "the same with the disc as an ellipse",
        Shading::ConeGgx => "GGX integrated over the exact cone of half vectors; the one to take",
        Shading::Shifted => "the same for lamps of any size",
    }
}

fn quantity(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Versine => "1 - cos of the angular radius",
        Quantity::SolidAngle => "solid angle of the disc",
        Quantity::SizeFactor => "UsdLux's sizeFactor, illuminance over radiance",
        Quantity::InverseSizeFactor => "one over it, radiance over illuminance",
        Quantity::WhiteRadiance => "radiance of a light under which a white surface is white",
    }
}

fn number(format: Format) -> &'static str {
    match format {
        Format::F64 => "64-bit float",
        Format::F32 => "32-bit float",
        Format::Micromath => "32-bit float with micromath's roots and reciprocals",
        Format::F16 => "16-bit float",
        Format::I2F14 => "fixed point, 14 fraction bits in 16",
        Format::I2F30 => "fixed point, 30 fraction bits in 32",
        Format::I16F16 => "fixed point, 16 fraction bits in 32",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::filter;

    #[test]
    fn every_name_has_a_line_that_says_something() {
        let text = text();
        let names = filter::methods().into_iter().chain(Format::ALL.map(Format::name));
        let names = names.chain(lights::STUDY.map(|light| light.name)).chain(CASES.map(|case| case.name));
        for name in names.chain(presets::names().into_iter().map(|(name, _)| name)) {
            let about = |line: &str| line.trim_start().strip_prefix(&quoted(name)).is_some_and(|about| about.len() > 8);
            assert!(text.lines().any(about), "{name}\n{text}");
        }
        assert!(text.lines().all(|line| line.chars().count() <= 120), "{text}");
    }
}
