//! What fails: in this run, in reports that name the method, and by its nature.

use super::measurement::Measurement;
use super::subject::Subject;
use crate::number;
use crate::page::cells::escape;
use crate::presets::PresetRow;
use crate::result::Study;

/// The list of failures, which may be none.
pub fn part(study: &Study, subject: Subject, measured: &[Measurement]) -> String {
    let about = subject.about();
    let mut lines = of_rows(measured);
    let names = [subject.name(), about.function.trim_start_matches("sunglint::")];
    lines.extend(study.presets.iter().filter(|row| names.iter().any(|name| is_named(&row.form, name))).map(reported));
    if !measured.is_empty() && measured.iter().all(|one| one.failure.is_none()) {
        lines.insert(0, "Nothing failed in this run.".to_owned());
    }
    let limit = Some(about.limit).filter(|limit| !limit.is_empty()).map(|limit| format!("Known limit: {limit}"));
    let lines: String = lines.into_iter().chain(limit).map(|line| format!("<li>{line}</li>")).collect();
    format!("<h5>Failures and limits</h5>\n<ul>{lines}</ul>\n")
}

/// A line for each format and each way in which it fails.
fn of_rows(measured: &[Measurement]) -> Vec<String> {
    let mut ways: Vec<(String, &str, Vec<&str>)> = Vec::new();
    for (one, failure) in measured.iter().filter_map(|one| one.failure.map(|failure| (one, failure))) {
        let format = one.said();
        match ways.iter_mut().find(|(known, way, _)| *known == format && *way == failure) {
            Some((.., under)) => under.push(one.under),
            None => ways.push((format, failure, vec![one.under])),
        }
    }
    let line = |(format, way, under): &(String, &str, Vec<&str>)| {
        let under = escape(&under.join(", "));
        let under = if under.is_empty() { under } else { format!(" ({under})") };
        format!("<strong>{}: {}</strong>{under}", escape(format), escape(way))
    };
    ways.iter().map(line).collect()
}

/// Whether `form` begins with the whole name `name`, or has it as a path of the crate.
fn is_named(form: &str, name: &str) -> bool {
    let ends = |rest: &str| !rest.starts_with(|next: char| next.is_alphanumeric() || "_/:".contains(next));
    let starts = form.strip_prefix(name).is_some_and(ends);
    let within = form.match_indices(name).any(|(at, _)| ends(&form[at + name.len()..]));
    starts || name.contains("::") && within
}

fn reported(row: &PresetRow) -> String {
    let role = match row.role {
        "cure" => "as the cure of",
        "truth" => "as the truth of",
        _ => "in",
    };
    format!(
        "{role} the reported failure <a href=\"#presets\">{}</a>: {}, {} {}",
        escape(row.preset),
        escape(&row.form),
        escape(&row.measure),
        number::scientific(row.value)
    )
}

#[cfg(test)]
mod tests {
    use sunglint::trial::Method;

    use super::*;
    use crate::sample;

    #[test]
    fn failures_of_one_kind_share_a_line() {
        let study = sample::methods_study();
        let epic = Subject::Direction(Method::Epic);
        let row = &epic.measurements(&study)[0];
        let twice = [row.clone(), Measurement { under: "<Mars>", ..row.clone() }];
        let html = part(&study, epic, &twice);
        assert!(html.contains("<strong>f16: NaN</strong> (Sun from Earth, &lt;Mars&gt;)"), "{html}");
        assert!(!html.contains("Nothing failed"));
        let cap = Subject::Direction(Method::Cap);
        assert!(part(&study, cap, &cap.measurements(&study)).contains("Nothing failed in this run."));
    }

    #[test]
    fn a_report_is_found_by_the_whole_name_of_a_form() {
        assert!(is_named("disc, f16", "disc") && is_named("1 / PointGgx::karis in f16", "PointGgx::karis"));
        assert!(!is_named("disc_ggx, f16", "disc") && !is_named("the disc, f16", "disc"));
        assert!(!is_named("PointGgx::karis_third", "PointGgx::karis") && !is_named("karis/3, f16", "karis"));
        let study = sample::methods_study();
        let cap = Subject::Direction(Method::Cap);
        let html = part(&study, cap, &cap.measurements(&study));
        assert!(html.contains("as the cure of the reported failure <a href=\"#presets\">tiny-sun</a>"), "{html}");
    }
}
