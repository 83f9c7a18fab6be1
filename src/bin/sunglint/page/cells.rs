//! The cells of the page's tables, and what is around them.

use crate::number;

/// `text` with the characters replaced that mean something in HTML.
pub fn escape(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.replace('"', "&quot;").replace('\'', "&#39;")
}

/// `name` as a part of an address within the page: in lower case, with a hyphen for every run of other characters than
/// letters and digits.
pub fn slug(name: &str) -> String {
    let name = name.to_lowercase();
    let words = name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("-")
}

/// A table that the script sorts by any column.
pub fn sortable(id: &str, columns: &[&str], lines: &str) -> String {
    let head = |name: &&str| format!("<th scope=\"col\"><button type=\"button\">{}</button></th>", escape(name));
    let heads: String = columns.iter().map(head).collect();
    format!(
        "<div class=\"wide\" tabindex=\"0\"><table id=\"{id}\">\n<thead><tr>{heads}</tr></thead>\n\
         <tbody>\n{lines}</tbody>\n</table></div>"
    )
}

/// A form whose choice the script heeds; it is hidden without one.
pub fn form(controls: &str) -> String {
    format!("<form class=\"choice\" hidden>{controls}</form>\n")
}

/// What chooses all names of a list.
pub const ALL: &str = "all";

/// A list to choose one of `names` from, at first the first; [`ALL`] among them hides nothing.
pub fn select(label: &str, name: &str, names: &[String]) -> String {
    let option = |name: &String| format!("<option>{}</option>", escape(name));
    let options: String = names.iter().map(option).collect();
    format!("<label>{label} <select name=\"{name}\">{options}</select></label>")
}

/// Buttons to choose one of `names` with, at first the first.
pub fn radio(label: &str, name: &str, names: &[&str]) -> String {
    let button = |(place, value): (usize, &&str)| {
        let checked = if place == 0 { " checked" } else { "" };
        format!("<label><input type=\"radio\" name=\"{name}\" value=\"{value}\"{checked}> {value}</label>")
    };
    let buttons: String = names.iter().enumerate().map(button).collect();
    format!("<fieldset><legend>{label}</legend>{buttons}</fieldset>")
}

/// A figure that stands for a choice: names of choices and what is chosen.
pub fn figure(choices: &[(&str, &str)], caption: &str, svg: &str) -> String {
    format!(
        "<figure{}>\n<figcaption>{}</figcaption>\n<div class=\"wide\" tabindex=\"0\">{svg}</div>\n</figure>\n",
        data(choices),
        escape(caption)
    )
}

/// Choices as attributes.
pub fn data(choices: &[(&str, &str)]) -> String {
    choices.iter().map(|(name, chosen)| format!(" data-{name}=\"{}\"", escape(chosen))).collect()
}

/// A cell of words.
pub fn text(value: &str) -> String {
    format!("<td>{}</td>", escape(value))
}

/// A cell of raw bits.
pub fn bits(value: &str) -> String {
    format!("<td><code>{}</code></td>", escape(value))
}

/// A cell of two figures and a power of ten.
pub fn scientific(value: f64) -> String {
    cell(value, &number::scientific(value))
}

/// A cell of a part in per cent of the whole.
pub fn percent(part: f64, whole: f64) -> String {
    cell(part / whole, &number::percent(part, whole))
}

/// A cell of a whole number.
pub fn count(value: u64) -> String {
    format!("<td class=\"figure\" data-value=\"{value}\">{}</td>", number::count(value))
}

/// A number that is shown as `shown` and sorted by its full value.
pub fn cell(value: f64, shown: &str) -> String {
    format!("<td class=\"figure\" data-value=\"{value:e}\">{shown}</td>")
}
