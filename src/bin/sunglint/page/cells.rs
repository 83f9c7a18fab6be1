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
    let columns: Vec<_> = columns.iter().map(|name| ("", *name)).collect();
    foldable(id, &columns, lines)
}

/// The same with columns in groups, each given with its column's name, that [`columns`] folds; no group's are always
/// shown.
pub fn foldable(id: &str, columns: &[(&str, &str)], lines: &str) -> String {
    let head = |(group, name): &(&str, &str)| {
        let group = if group.is_empty() { String::new() } else { data(&[("group", group)]) };
        format!("<th scope=\"col\"{group}><button type=\"button\">{}</button></th>", escape(name))
    };
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

/// What folds the groups of columns; those in `open` are shown at first.
pub fn columns(groups: &[&str], open: &[&str]) -> String {
    let button = |name: &&str| {
        let checked = if open.contains(name) { " checked" } else { "" };
        format!("<label><input type=\"checkbox\" name=\"columns\" value=\"{name}\"{checked}> {name}</label>")
    };
    let buttons: String = groups.iter().map(button).collect();
    format!("<fieldset class=\"columns\"><legend>Columns</legend>{buttons}</fieldset>")
}

/// A field for words that the rows that are shown hold.
pub const FIND: &str = "<label>Find <input type=\"search\" name=\"text\" placeholder=\"any words\"></label>";

/// Choices as attributes.
pub fn data(choices: &[(&str, &str)]) -> String {
    choices.iter().map(|(name, chosen)| format!(" data-{name}=\"{}\"", escape(chosen))).collect()
}

/// A cell of words.
pub fn text(value: &str) -> String {
    format!("<td>{}</td>", escape(value))
}

/// A cell of a method's name, which leads to its page.
pub fn method(name: &str) -> String {
    format!("<td><a href=\"#method-{}\">{}</a></td>", slug(name), escape(name))
}

/// A cell without a figure, which comes last in any order.
pub fn missing() -> String {
    cell(f64::NAN, "")
}

/// A cell of raw bits.
pub fn bits(value: &str) -> String {
    format!("<td><code>{}</code></td>", escape(value))
}

/// A cell of a command, with a button that copies it; empty where there is none.
pub fn command(value: &str) -> String {
    match value {
        "" => "<td></td>".to_owned(),
        value => format!(
            "<td class=\"command\"><button type=\"button\" class=\"copy\">copy</button> <code>{}</code></td>",
            escape(value)
        ),
    }
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

/// A number that is shown as `shown` and sorted by its first five digits.
pub fn cell(value: f64, shown: &str) -> String {
    format!("<td class=\"figure\" data-value=\"{value:.4e}\">{shown}</td>")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slugs_are_plain_words() {
        let names = ["cap", "cone_ggx shifted", "karis/3", "PixelQ14", "Cone::direction", "<b>"];
        assert_eq!(names.map(slug), ["cap", "cone-ggx-shifted", "karis-3", "pixelq14", "cone-direction", "b"]);
    }

    #[test]
    fn groups_of_columns_are_named_in_the_heads_and_in_what_folds_them() {
        let html = foldable("t", &[("", "method"), ("bits", "raw bits")], "") + &columns(&["bits"], &[]);
        assert!(html.contains("<th scope=\"col\"><button") && html.contains("<th scope=\"col\" data-group=\"bits\">"));
        assert!(html.contains("name=\"columns\" value=\"bits\"> bits"), "{html}");
    }

    #[test]
    fn a_command_is_escaped() {
        assert!(command("a 'b' <c>").contains("<code>a &#39;b&#39; &lt;c&gt;</code>"));
        assert_eq!(command(""), "<td></td>");
    }
}
