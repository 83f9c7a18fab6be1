//! The whole measurement: errors on all cores, then costs on a quiet machine.

use indicatif::ProgressBar;
use sunglint::trial::Format;

use crate::options::Options;
use crate::result::Study;
use crate::rivals::{self, Rivals};
use crate::{
    anchors, chip, curves, directions, kernels, lobes, pictures, pixel_q14, pixels, presets, quantities, sweep,
};

/// Names of the lights that can be asked for: of directions, of lit pixels and of whole highlights.
pub fn light_names() -> Vec<&'static str> {
    directions::names().chain(pixels::names()).chain(lobes::names()).collect()
}

/// Measures what `options` asks for.
pub fn run(options: &Options, progress: &ProgressBar) -> Study {
    let steps =
        [directions::steps(options), quantities::steps(options), pixels::steps(options), kernels::steps(options)];
    let rivals = rivals::steps(options) + pixel_q14::steps(options) + rivals::kernels::steps(options);
    let beside = [
        lobes::steps(options),
        anchors::steps(options),
        curves::steps(options),
        sweep::steps(options),
        presets::steps(options),
        pictures::steps(options),
    ];
    progress.set_length((steps.into_iter().chain(beside).sum::<usize>() + rivals) as u64);
    let mut study = Study {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        seed: options.seed,
        light: options.filter.light.clone(),
        command: options.command(),
        quick: options.quick,
        rows: directions::errors(options, progress),
        quantities: quantities::measure(options, progress),
        pixels: pixels::errors(options, progress),
        lobes: lobes::measure(options, progress),
        kernels: kernels::errors(options, progress),
        curves: curves::measure(options, progress),
        sweep: sweep::measure(options, progress),
        presets: presets::measure(options, progress),
        pictures: pictures::draw(options, progress),
        ..Study::default()
    };
    study.rivals = Rivals {
        directions: rivals::directions(&study.rows, options, progress),
        pixels: pixel_q14::errors(&study.pixels, options, progress),
        kernels: rivals::kernels::errors(&study.kernels, options, progress),
    };
    // From here on one thing at a time: these are times.
    study.anchors = anchors::measure(options, progress);
    directions::add_costs(&mut study.rows, options, progress);
    pixels::add_costs(&mut study.pixels, options, progress);
    pixel_q14::add_costs(&mut study.rivals.pixels, options, progress);
    kernels::add_costs(&mut study.kernels, options, progress);
    study.chip = chip::rows(&study);
    study.chip.retain(|row| options.filter.wants_count(&row.count));
    study
}

/// The raw bits of the lanes in hexadecimal.
pub fn bits(format: Format, lanes: &[f64]) -> String {
    let digits = format.width() / 4;
    let lanes: Vec<_> = lanes.iter().map(|&lane| format!("{:0digits$x}", format.bits(lane))).collect();
    lanes.join(" ")
}
