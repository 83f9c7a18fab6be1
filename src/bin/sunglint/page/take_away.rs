//! What to take away: the files and their columns, and source code of the recommended methods.

use super::cells::{escape, sortable, text};
use crate::columns::{self, Column};
use crate::snippets::{self, Snippet};

/// The files, each with what it is, in the order in which they are worth a look.
const FILES: [(&str, &str); 16] = [
    ("measurements.csv", "Long form: one row a figure, to filter and to pivot."),
    ("results.csv", "One row a light, direction method and number format."),
    ("pixels.csv", "One row a lit surface, highlight method and number format."),
    ("lobes.csv", "One row a highlight method and a whole highlight: its energy, peak and model error."),
    ("kernels.csv", "One row a building block and number format."),
    ("quantities.csv", "One row a quantity of a light and number format."),
    ("chip.csv", "One row a function counted on microcontrollers: instructions, stack, bytes."),
    ("anchors.csv", "What costs and errors can be compared with: the empty call and the rounded truth."),
    ("curves.csv", "Errors along the angle from the light and along its size."),
    ("sweep.csv", "Errors of every method in words of every length."),
    ("presets.csv", "Failures that were reported elsewhere, and their cures."),
    ("columns.csv", "The schema: every column of these files with its unit, range and meaning."),
    ("results.json", "All tables in one file, and the schema; what is no number is null there."),
    ("chart.svg", "Error against cost of directions, on the machine of this run."),
    ("chips.svg", "Error against instructions on three microcontrollers."),
    ("pixels.svg", "Error against cost of a lit pixel."),
];

const INTRODUCTION: &str = "<p>The recommended methods as source code, to paste: <code>cap</code> turns the light to \
the point of its disc that the mirror ray sees, <code>cap_half</code> does so in f16, <code>disc_ggx dir</code> is the \
whole highlight, and <code>karis</code> the cheap one. Tests parse and validate each and run it in f32 \
(<code>cap_half</code> in f16) against the oracle; the HLSL is the GLSL in other words. Copy them here, take them from \
the folder <code>snippets</code> next to this page, or print one by <code>sunglint snippet cap --language wgsl</code>. \
Licence: MIT or Apache-2.0, as you like.</p>\n";

const TABLES: &str = "<p>Pictures lie in the folder <code>pictures</code>. Numbers are decimals of f64, empty where \
there is no figure, <code>NaN</code> or <code>inf</code> where a method gave no number. The same seed gives the same \
files byte for byte, but for times.</p>\n";

/// The section; empty where there is nothing.
pub fn all() -> String {
    let snippets: String = snippets::ALL.iter().map(block).collect();
    format!(
        "<h3>Source code</h3>\n{INTRODUCTION}{snippets}<h3>Files</h3>\n{}\n{TABLES}{}",
        files(),
        fold("Columns of all files", &schema())
    )
}

/// Something that is shown when asked for.
fn fold(title: &str, content: &str) -> String {
    format!("<details><summary>{title}</summary>\n{content}</details>\n")
}

/// A snippet, with a button that copies it and a link to its file.
fn block(snippet: &Snippet) -> String {
    let Snippet { method, language, file, source } = snippet;
    let id = format!("snippet-{}", file.replace('.', "-"));
    let title = format!("<code>{}</code> in {}", escape(method), language.name());
    let content = format!(
        "<p><button type=\"button\" class=\"copy\" data-copy-from=\"{id}\">Copy</button> \
         <a href=\"snippets/{file}\">{file}</a></p>\n\
         <pre class=\"wide\" tabindex=\"0\"><code id=\"{id}\">{}</code></pre>\n",
        escape(source.trim_end())
    );
    fold(&title, &content)
}

/// The list of files, each a link.
fn files() -> String {
    let line = |&(name, said): &(&str, &str)| format!("<li><a href=\"{name}\">{name}</a> {}</li>\n", escape(said));
    let lines: String = FILES.iter().map(line).collect();
    format!("<ul>\n{lines}</ul>")
}

/// Every column of every file, to be sorted.
fn schema() -> String {
    const NAMES: [&str; 6] = ["file", "column", "kind", "unit", "range", "meaning"];
    let line = |column: &Column| {
        let Column { file, column, kind, unit, range, meaning } = column;
        let cells: String = [file, column, kind, unit, range, meaning].into_iter().map(|cell| text(cell)).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let lines: String = columns::all().iter().map(line).collect();
    sortable("schema", &NAMES, &lines)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output;
    use crate::sample;
    use std::collections::HashSet;

    fn links(html: &str) -> HashSet<String> {
        let ends = html.split("href=\"").skip(1).filter_map(|rest| rest.split_once('"'));
        ends.map(|(link, _)| link.to_owned()).collect()
    }

    #[test]
    fn every_link_is_a_file_that_is_written_and_every_table_has_a_link() {
        let folder = tempfile::tempdir().expect("a folder");
        output::write(&sample::study(Vec::new()), folder.path()).expect("files");
        let links = links(&all());
        for link in &links {
            assert!(folder.path().join(link).is_file(), "{link}");
        }
        assert!(output::TABLES.iter().all(|name| links.contains(*name)));
        assert_eq!(links.len(), FILES.len() + snippets::ALL.len());
    }

    #[test]
    fn sources_and_columns_are_escaped() {
        let html = all();
        for line in ["if (!(square &gt; 1e-30)) {", "(&lt;= 0 x 1)", "the light&#39;s centre"] {
            assert!(html.contains(line), "{line}");
        }
        let tags = ["<h3>", "<p>", "<code", "<a ", "<details>", "<summary>", "<button ", "<pre ", "<ul>", "<li>"];
        let tables = ["<div ", "<table ", "<thead>", "<tbody>", "<tr>", "<th ", "<td>"];
        let opened = html.matches('<').count() - html.matches("</").count();
        let known: usize = tags.iter().chain(&tables).map(|tag| html.matches(tag).count()).sum();
        assert_eq!(opened, known, "something that is no tag of this section is not escaped");
    }

    #[test]
    fn every_button_copies_a_snippet_that_is_there() {
        let html = all();
        let sources = html.split("data-copy-from=\"").skip(1).filter_map(|rest| rest.split_once('"'));
        let ids: HashSet<_> = sources.map(|(id, _)| id).collect();
        assert_eq!(ids.len(), snippets::ALL.len());
        assert!(ids.iter().all(|id| html.matches(&format!("id=\"{id}\"")).count() == 1));
    }
}
