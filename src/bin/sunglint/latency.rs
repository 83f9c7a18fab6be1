//! What a direction or a lit pixel takes where the next one waits for it: the latency of a call.

use indicatif::ProgressBar;
use sunglint::trial::{Format, Light, Method, Shading};

use crate::clock::{self, Contender, Pace};
use crate::options::Options;
use crate::result::Study;
use crate::{directions, pixel_q14, pixels};

/// Steps of the progress bar.
pub fn steps(options: &Options) -> usize {
    (directions::wanted(options).count() + 2 * pixels::wanted(options).len()) * rounds(options)
}

/// How often every contender has its turn: fewer than for throughput, since a chain has no slack to vary in.
fn rounds(options: &Options) -> usize {
    if options.quick { 3 } else { 15 }
}

/// Adds the latencies to the rows of directions and of lit pixels.
pub fn add(study: &mut Study, options: &Options, progress: &ProgressBar) {
    for light in directions::wanted(options) {
        let rows = study.rows.iter_mut().filter(|row| row.light == light.name);
        let (latencies, contenders): (Vec<_>, Vec<_>) = rows
            .filter_map(|row| {
                let (method, format) = (Method::named(&row.method)?, Format::named(&row.format)?);
                Some((&mut row.latency, directions::contender(method, format, &light, Pace::Waiting)))
            })
            .unzip();
        set(latencies, &contenders, &light, options, progress);
    }
    for case in pixels::wanted(options) {
        let light = Light { name: case.name, light: case.light };
        let rows = study.pixels.iter_mut().filter(|row| row.case == case.name);
        let (latencies, contenders): (Vec<_>, Vec<_>) = rows
            .filter_map(|row| {
                let (method, format) = (Shading::named(&row.method)?, Format::named(&row.format)?);
                Some((&mut row.latency, pixels::contender(method, format, &case, Pace::Waiting)))
            })
            .unzip();
        set(latencies, &contenders, &light, options, progress);
        let rival = study.rivals.pixels.iter_mut().filter(|row| row.case == case.name);
        let latencies: Vec<_> = rival.map(|row| &mut row.latency).collect();
        let contenders: Vec<_> = latencies.iter().map(|_| pixel_q14::waiting(&case)).collect();
        set(latencies, &contenders, &light, options, progress);
    }
}

fn set(latencies: Vec<&mut f64>, contenders: &[Contender], light: &Light, options: &Options, progress: &ProgressBar) {
    progress.set_message(format!("timing, one waits for the other, {}", light.name));
    let costs = clock::costs(contenders, &directions::baseline(light), rounds(options), progress);
    for (latency, cost) in latencies.into_iter().zip(costs) {
        *latency = cost.median;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::author::PIXEL_Q14;
    use crate::result::{PixelRow, Row};
    use crate::rivals::Rivals;
    use crate::sample;

    #[test]
    fn every_row_of_a_light_has_its_latency() {
        let options = Options::parse_from(["sunglint", "--quick", "--light", "sun"]);
        let pixel = |method: &str, format| PixelRow { latency: f64::NAN, ..sample::pixel(method, format, 1.0, 1e-3) };
        let mut study = Study {
            rows: Format::ALL
                .map(|format| Row { latency: f64::NAN, ..sample::row("cap", format.name(), 1.0, 1e-3) })
                .into(),
            pixels: vec![pixel("cone_ggx", "f32"), pixel("none", "f16")],
            rivals: Rivals {
                pixels: vec![PixelRow { by: PIXEL_Q14, ..pixel("disc_ggx", "I2F14") }],
                ..Rivals::default()
            },
            ..Study::default()
        };
        let progress = ProgressBar::hidden();
        add(&mut study, &options, &progress);
        assert_eq!(progress.position(), steps(&options) as u64);
        let latencies = study.rows.iter().map(|row| row.latency).chain(study.all_pixels().map(|row| row.latency));
        let latencies: Vec<_> = latencies.collect();
        assert!(latencies.len() == 10 && latencies.iter().all(|&latency| latency.is_finite()));
    }
}
