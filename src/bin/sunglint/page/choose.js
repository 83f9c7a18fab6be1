'use strict';

// What the forms of a section choose, by name.
function choice(section) {
  const forms = [...section.querySelectorAll('.choice')];
  return forms.flatMap(form => [...new FormData(form)]).filter(([name]) => name !== 'columns');
}

// Whether a figure or a row is among what is chosen.
function fits(part, chosen) {
  const data = part.dataset;
  return chosen.every(([name, value]) => {
    if (name !== 'text') return value === 'all' || !(name in data) || data[name] === value;
    const words = value.toLowerCase().split(/\s+/).filter(word => word);
    const text = part.tagName === 'TR' && words.length ? part.textContent.toLowerCase() : '';
    return part.tagName !== 'TR' || words.every(word => text.includes(word));
  });
}

// The HTML of a pack.
async function unpack(pack) {
  const bytes = Uint8Array.from(atob(pack.textContent), letter => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  const [titles, html] = (await new Response(stream).text()).split('\u001d');
  const known = titles.split('\u001e');
  return html.replace(/\u001f(\d+);/g, (_, place) => known[place]);
}

// The elements of a pack, unpacked once; none where the browser cannot.
function unpacked(pack) {
  pack.elements ??= unpack(pack).then(html => {
    const template = document.createElement('template');
    template.innerHTML = html;
    return [...template.content.children];
  }).catch(() => {
    pack.parentNode.querySelector(':scope > .no-unpack').hidden = false;
    return [];
  });
  return pack.elements;
}

// Shows the figures of a box that are chosen, from its pack where they are there.
async function draw(box, chosen) {
  const turn = box.turn = {};
  const pack = box.querySelector(':scope > .packed');
  box.figures ??= [...box.querySelectorAll(':scope > figure')];
  let shown = box.figures.filter(figure => fits(figure, chosen));
  if (!shown.length && pack) shown = (await unpacked(pack)).filter(figure => fits(figure, chosen));
  // Another choice may have come in between.
  if (box.turn !== turn) return;
  for (const figure of box.querySelectorAll(':scope > figure')) {
    if (!shown.includes(figure)) figure.remove();
  }
  box.prepend(...shown);
}

// Shows the charts and the rows of what is chosen.
function show(section) {
  const chosen = choice(section);
  for (const row of section.querySelectorAll('tbody tr')) row.hidden = !fits(row, chosen);
  for (const part of section.querySelectorAll('figure')) {
    if (!part.closest('.figures')) part.hidden = !fits(part, chosen);
  }
  for (const box of section.querySelectorAll('.figures')) draw(box, chosen);
}

// Fills what was packed in a folded part once it is opened.
async function fill(details) {
  const pack = details.querySelector(':scope > .packed');
  if (!pack || !details.open || pack.filled) return;
  pack.filled = true;
  pack.before(...await unpacked(pack));
  heed(details.closest('section'));
}

// Shows of a section what its controls choose.
function heed(section) {
  fold(section);
  if (section.querySelector('.choice')) show(section);
}
