//! The precision that standards of graphics ask for, as lines to compare with.

use crate::field::{Line, Sort};
use crate::kernel::ULP;

/// Relative error of GLSL ES `mediump`: ten bits.
const MEDIUMP: f64 = 1.0 / 1024.0;

/// Absolute error of GLSL ES `lowp`: eight bits.
const LOWP: f64 = 1.0 / 256.0;

/// Absolute error of Vulkan's `sin` and `cos` in 32 bits.
const SINE_32: f64 = 1.0 / 2048.0;

/// The same in 16 bits.
const SINE_16: f64 = 1.0 / 128.0;

/// Error of Vulkan's `inversesqrt`, in units in the last place.
const ROOT: f64 = 2.0;

/// What the page says of them.
pub const SAID: &str = "GLES <em>mediump</em> is a relative error of 2<sup>−10</sup>, <em>lowp</em> an absolute one of \
2<sup>−8</sup>, both of one number: no standard bounds a whole direction or a lit pixel, so that these lines give a scale and \
are no test to pass. A unit vector whose three lanes are each as far off as mediump allows has turned by up to 2<sup>−10</sup> \
rad, which is the line; as lowp allows, by up to √3 times its line. Of a pixel, lowp’s line is that of one as bright as white. \
Vulkan (VK) allows sin and cos an absolute error of 2<sup>−11</sup> (32 bits) or 2<sup>−7</sup> (16 bits) from −π to π, and \
inversesqrt 2 ULP.";

/// What a line is at the height of `error`.
fn line(error: f64, name: &str) -> Line {
    Line { error, name: name.to_owned(), sort: Sort::Required }
}

/// Lines for unit vectors and for parts of a pixel.
pub fn of_shading() -> [Line; 2] {
    [line(LOWP, "GLES lowp"), line(MEDIUMP, "GLES mediump")]
}

/// Lines for the building block `name`, whose error is in `unit`.
pub fn of_kernel(name: &str, unit: &str) -> Vec<Line> {
    match (name, unit) {
        ("sin_cos", _) => vec![line(SINE_16, "VK f16"), line(SINE_32, "VK f32")],
        (name, ULP) if name.contains("root") => vec![line(ROOT, "VK")],
        (_, ULP) => Vec::new(),
        _ => vec![line(MEDIUMP, "mediump")],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_building_block_has_the_lines_of_its_unit() {
        let errors = |name, unit| -> Vec<_> { of_kernel(name, unit).iter().map(|line| line.error.log2()).collect() };
        assert_eq!(errors("sin_cos", "absolute"), [-7.0, -11.0]);
        assert_eq!(errors("reciprocal root", ULP), [1.0]);
        assert!(errors("lambert", ULP).is_empty());
        assert_eq!(errors("normalize", "rad"), [-10.0]);
        assert_eq!(of_shading().map(|line| line.error.log2()), [-8.0, -10.0]);
    }
}
