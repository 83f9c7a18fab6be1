//! What fails: in this run, in reports that name the method, and by its nature.

use super::figure as shown;
use super::measurement::Measurement;
use super::subject::Subject;
use crate::page::cells::escape;
use crate::presets::PresetRow;
use crate::result::Study;

/// The list of failures, which may be none.
pub fn part(study: &Study, subject: Subject, measured: &[Measurement]) -> String {
    let about = subject.about();
    let mut lines = of_rows(measured);
    lines.extend(of_reports(study, &names(subject)));
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

/// What a report may call it: its name, its path in the crate, and the type that it belongs to.
fn names(subject: Subject) -> Vec<&'static str> {
    let path = subject.about().function.trim_start_matches("sunglint::");
    let types = path.split("::").filter(|part| part.starts_with(char::is_uppercase));
    [subject.name(), path].into_iter().chain(types).collect()
}

/// A line for each form of a reported failure that begins with one of `names`, with all that was measured of it.
fn of_reports(study: &Study, names: &[&str]) -> Vec<String> {
    let named = |row: &&PresetRow| {
        ROLES.iter().any(|(role, _)| *role == row.role) && names.iter().any(|name| is_named(&row.form, name))
    };
    let mut forms: Vec<Vec<&PresetRow>> = Vec::new();
    for row in study.presets.iter().filter(named) {
        match forms.iter_mut().find(|form| (form[0].preset, &form[0].form) == (row.preset, &row.form)) {
            Some(form) => form.push(row),
            None => forms.push(vec![row]),
        }
    }
    forms.iter().map(|form| reported(form)).collect()
}

/// Whether `form` begins with the whole of `name`.
fn is_named(form: &str, name: &str) -> bool {
    let goes_on = |rest: &str| rest.starts_with(|next: char| next.is_alphanumeric() || "_/:".contains(next));
    form.strip_prefix(name).is_some_and(|rest| !goes_on(rest))
}

/// The roles of forms, and how a line begins that has one. Points of a preset's chart have another role.
const ROLES: [(&str, &str); 3] = [("fails", "Fails in"), ("cure", "The cure in"), ("truth", "The truth in")];

fn reported(rows: &[&PresetRow]) -> String {
    let Some(first) = rows.first() else { return String::new() };
    let role = ROLES.iter().find(|(role, _)| *role == first.role).map_or("", |(_, said)| said);
    let figure = |row: &&PresetRow| format!("{} {}", escape(&row.measure), shown(row.value));
    let figures: Vec<_> = rows.iter().map(figure).collect();
    let (preset, form) = (escape(first.preset), escape(&first.form));
    format!("{role} the reported failure <a href=\"#preset-{preset}\">{preset}</a>: {form}; {}.", figures.join(", "))
}

#[cfg(test)]
mod tests {
    use sunglint::trial::{Method, Shading};

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
    fn a_report_is_found_by_the_whole_name_at_the_head_of_a_form() {
        assert!(is_named("disc, f16", "disc") && is_named("PointGgx::karis in f16", "PointGgx::karis"));
        assert!(!is_named("disc_ggx, f16", "disc") && !is_named("the disc, f16", "disc"));
        assert!(!is_named("PointGgx::karis_third", "PointGgx::karis") && !is_named("karis/3, f16", "karis"));
        let names = names(Subject::Highlight(Shading::Karis));
        assert_eq!(names, ["karis", "highlight::PointGgx::karis", "PointGgx"]);
    }

    #[test]
    fn the_figures_of_a_form_stand_together_and_points_of_charts_do_not() {
        let mut study = sample::methods_study();
        let row = study.presets[0].clone();
        study.presets.extend([PresetRow { value: 2.0, ..row.clone() }, PresetRow { role: "curve", value: 3.0, ..row }]);
        let cap = Subject::Direction(Method::Cap);
        let html = part(&study, cap, &cap.measurements(&study));
        let [none, two] = [0.0, 2.0].map(shown);
        let said = format!("#preset-tiny-sun\">tiny-sun</a>: cap, f16; lost {none}, lost {two}.</li>");
        assert!(html.contains(&said) && html.contains("<li>The cure in the reported failure"), "{html}");
        assert_eq!(html.matches(">tiny-sun<").count(), 1, "{html}");
    }
}
