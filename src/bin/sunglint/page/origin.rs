//! Where the numbers come from: the summary on top of the page, and the section at its end.

use super::cells::escape;
use super::{chip, pixels};
use crate::number;
use crate::result::Study;

/// Version, seed, extent and command of the run.
pub fn summary(study: &Study) -> String {
    let counts = [
        (study.all_directions().count(), "directions"),
        (study.all_pixels().count(), "lit pixels"),
        (study.lobes.len(), "whole highlights"),
        (study.all_kernels().count(), "building blocks"),
        (study.chip.len(), "counts on Cortex-M"),
    ];
    let counts = counts.into_iter().filter(|(count, _)| *count > 0);
    let counts: Vec<_> = counts.map(|(count, what)| format!("{} {what}", number::count(count as u64))).collect();
    format!(
        "<p>Version {}, seed {}, {} run: {}. To do it again: <code>{}</code></p>",
        escape(&study.version),
        study.seed,
        if study.quick { "quick" } else { "full" },
        counts.join(", "),
        escape(&study.command)
    )
}

/// Seed, size and command of the run.
pub fn section(study: &Study) -> String {
    let tried = study.rows.iter().map(|row| row.samples);
    let (least, most) = (tried.clone().min().unwrap_or(0), tried.max().unwrap_or(0));
    let tried = match least == most {
        true => number::count(most),
        false => format!("{} to {}", number::count(least), number::count(most)),
    };
    format!(
        "<p>sunglint {} tried {tried} directions for each measurement of a direction, at random from seed {} and the hard ones \
         that have broken a method, and {} (by the integral over the disc), also random. \
         To do it again: <code>{}</code>. The same seed gives the same errors.</p>\n\
         <p>Costs are times of this machine in this run, less that of an empty call: the median over the rounds, as a multiple of \
         the time of f32 <code>factored</code> in the same round, with the quartiles beside it. Directions are timed on the pixels \
         of a ball in scan order.</p>\n\
         <p>Every worst case is given with the raw bits of its input (the first input, where no answer is a direction), or in \
         exact decimals for building blocks, so that it can be computed again (of soft_shadow the scene without the direction to \
         its light).</p>\n<p>The same numbers lie in files next to this page: see <a href=\"#take-away\">Take it away</a>.</p>\n{}",
        escape(&study.version),
        study.seed,
        pixels::tried(study),
        escape(&study.command),
        chip::origin()
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn the_summary_counts_what_there_is() {
        let html = summary(&sample::whole_study(vec![sample::row("cap", "f32", 1.0, 1e-7)]));
        for part in
            ["Version 0.1.0, seed 1, quick run: 3 directions, 4 lit pixels", "3 building blocks", "sunglint --quick"]
        {
            assert!(html.contains(part), "{part}: {html}");
        }
        assert!(!summary(&sample::study(Vec::new())).contains(" directions"));
    }
}
