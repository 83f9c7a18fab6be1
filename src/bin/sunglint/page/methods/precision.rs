//! The errors of a building block beside what graphics standards ask for.

use sunglint::trial::Format;

use super::figure;
use super::measurement::Measurement;
use crate::author::is_ours;
use crate::kernel::{Kernel, ULP};
use crate::page::cells::escape;

/// GLES: the relative error that a single operation in mediump may have.
const MEDIUMP: f64 = 1.0 / 1024.0;

/// Vulkan: the absolute error that a sine or a cosine may have in f32 and in f16.
const VULKAN: [f64; 2] = [1.0 / 2048.0, 1.0 / 128.0];

/// A sentence or two on `kernel`.
pub fn paragraph(kernel: Kernel, measured: &[Measurement]) -> String {
    let ours: Vec<_> = measured.iter().filter(|one| is_ours(one.by) && one.failure.is_none()).collect();
    let sentences = [places(kernel, &ours), vulkan(kernel, &ours), mediump(&ours)];
    let sentences: Vec<_> = sentences.into_iter().filter(|sentence| !sentence.is_empty()).collect();
    format!("<p><strong>Required elsewhere.</strong> {}</p>\n", sentences.join(" "))
}

/// The worst errors in units of the last place. Numbers of fixed point have 31 bits and an exponent, whatever the
/// format of vectors; so of those only directions count.
fn places(kernel: Kernel, ours: &[&Measurement]) -> String {
    let of_vectors = kernel.unit() == "rad";
    let place = |one: &&&Measurement| {
        let format = Format::named(one.format)?;
        let is_float = [Format::F64, Format::F32, Format::Micromath, Format::F16].contains(&format);
        let size = if kernel.unit() == ULP { 1.0 } else { format.step() };
        (of_vectors || is_float).then(|| format!("{} {}", escape(one.format), figure(one.max / size)))
    };
    let places: Vec<_> = ours.iter().filter_map(|one| place(&one)).collect();
    let unit = if kernel.unit() == ULP { "ULP" } else { "last places of numbers just below 1" };
    if places.is_empty() { String::new() } else { format!("Worst errors in {unit}: {}.", places.join(", ")) }
}

/// What Vulkan asks of the same function, or of what it is made of.
fn vulkan(kernel: Kernel, ours: &[&Measurement]) -> String {
    match kernel {
        Kernel::SinCos => {
            let of =
                |format: Format| ours.iter().find(|one| one.format == format.name()).map_or(f64::NAN, |one| one.max);
            format!(
                "Vulkan asks for 2⁻¹¹ ({}) absolute of f32 and 2⁻⁷ ({}) of f16; here they are {} and {}.",
                figure(VULKAN[0]),
                figure(VULKAN[1]),
                figure(of(Format::F32)),
                figure(of(Format::F16))
            )
        }
        Kernel::Normalize => {
            "Vulkan allows an inverse square root 2 ULP, before anything is multiplied by it.".to_owned()
        }
        Kernel::Irradiance | Kernel::Flux | Kernel::SphereLight | Kernel::RelativeToPeak | Kernel::Tint => {
            "Vulkan allows a single division 2.5 ULP.".to_owned()
        }
        _ => String::new(),
    }
}

/// Which formats keep the whole function within what GLES allows one operation.
fn mediump(ours: &[&Measurement]) -> String {
    if ours.first().is_none_or(|one| one.unit == ULP) {
        return String::new();
    }
    let within: Vec<_> = ours.iter().filter(|one| one.max <= MEDIUMP).map(|one| escape(one.format)).collect();
    let within = if within.is_empty() { "none".to_owned() } else { within.join(", ") };
    let most = figure(MEDIUMP);
    format!(
        "GLES allows one operation in mediump 2⁻¹⁰ of its result ({most}); off by no more than that figure is the whole \
         function in: {within}."
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::methods::subject::Subject;
    use crate::sample;

    #[test]
    fn errors_are_said_in_last_places_and_what_fails_is_left_out() {
        let mut study = sample::methods_study();
        study.kernels[0].error_max = 1.5 * Format::F32.step();
        let measured = Subject::Block(Kernel::Normalize).measurements(&study);
        let html = paragraph(Kernel::Normalize, &measured);
        assert!(
            html.contains(
                "just below 1: f32 <span class=\"number\">1.5</span>. Vulkan allows an inverse square root 2 ULP"
            ),
            "{html}"
        );
        assert!(html.contains("whole function in: f32.</p>"), "f16 is infinite in the sample: {html}");
    }
}
