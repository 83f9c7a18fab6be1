//! How to read the charts.

use crate::required;

const INTRODUCTION: &str = "<p>Each mark is a method, told by its shape, in a number format, \
told by its colour and its label. Further <strong>left is cheaper</strong> (in time on the machine of this run, or in instructions on a \
microcontroller), further <strong>down is more exact</strong>; both axes are logarithmic. The grey stairs are the Pareto frontier: \
for every mark off them there is another that is neither dearer nor more wrong.</p><p>Point at a mark, or reach it by the Tab key, for all of its \
figures; click it for its method’s page. Marks that coincide are drawn inside each other, the outer ones larger.</p>";

/// A drawing of a sign and what it means.
const SIGNS: [(&str, &str); 9] = [
    (
        "<circle cx=\"12\" cy=\"9\" r=\"7.6\" fill=\"#1c1c1c\"/><circle cx=\"12\" cy=\"9\" r=\"6\" fill=\"#0072b2\"/>",
        "<strong>dark rim</strong>: the worst known of it, which the box tells, is exhaustive: every input was tried",
    ),
    (
        "<circle cx=\"12\" cy=\"9\" r=\"6\" fill=\"#0072b2\"/>",
        "<strong>plain</strong>: that is searched, by climbing from random and from hard inputs, half a million or more. The mark \
         stands at this run’s errors all the same",
    ),
    (
        "<circle cx=\"12\" cy=\"9\" r=\"6\" fill=\"#0072b2\"/><circle cx=\"12\" cy=\"9\" r=\"1.8\" fill=\"#ffffff\"/>",
        "<strong>dot in the middle</strong>: that is sampled, the random inputs of this run and hard ones",
    ),
    (
        "<circle cx=\"12\" cy=\"9\" r=\"6\" fill=\"#0072b2\"/><circle cx=\"12\" cy=\"9\" r=\"4\" fill=\"#ffffff\"/>\
         <path d=\"M5 2L19 16M19 2L5 16\" stroke=\"#0072b2\" stroke-width=\"1.6\"/>",
        "<strong>hollow and crossed out</strong>: fails, and its label says how; <em>disc lost</em> is off by half of the radius \
         or more within ten radii of the light. In the grey strip on top stands what gave no number at all",
    ),
    (
        "<path d=\"M12 4.5L15.9 6.75V11.25L12 13.5L8.1 11.25V6.75Z\" fill=\"#0072b2\"/>\
         <path d=\"M12 6.5L14.2 7.75V10.25L12 11.5L9.8 10.25V7.75Z\" fill=\"#ffffff\"/>",
        "<strong>small and hollow, ideal</strong>: the true answer rounded into the format, at the cost of an empty call (at the \
         left edge where that is not known, or far off): a method without an error of its own",
    ),
    (
        "<circle cx=\"12\" cy=\"9\" r=\"6\" fill=\"#9a9a9a\"/>",
        "<strong>grey</strong>: a peer, another library with its version",
    ),
    (
        "<path d=\"M0 9H24\" stroke=\"#a06a00\" stroke-width=\"1.6\" stroke-dasharray=\"5 3\"/>",
        "<strong>model error</strong> of a method: what its formula is wrong by, in any format",
    ),
    (
        "<path d=\"M0 9H24\" stroke=\"#8a3c00\" stroke-width=\"1.6\" stroke-dasharray=\"9 3\"/>",
        "<strong>size</strong>: the light’s angular radius and a hundredth of it, or half a step of a display",
    ),
    (
        "<path d=\"M0 9H24\" stroke=\"#6a4fb0\" stroke-width=\"1.6\" stroke-dasharray=\"2 3\"/>",
        "<strong>standard</strong>: the precision that a standard of graphics asks of one number or one operation",
    ),
];

/// The whole section.
pub fn all() -> String {
    let item = |(drawing, meaning): &(&str, &str)| {
        format!(
            "<li><svg viewBox=\"0 0 24 18\" width=\"24\" height=\"18\" aria-hidden=\"true\">{drawing}</svg><span>{meaning}.</span></li>\n"
        )
    };
    let items: String = SIGNS.iter().map(item).collect();
    format!("{INTRODUCTION}\n<ul class=\"signs\">\n{items}</ul>\n<p>{}</p>", required::SAID)
}
