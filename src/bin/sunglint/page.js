'use strict';

// What the forms of a section choose, by name.
function choice(section) {
  const forms = [...section.querySelectorAll('.choice')];
  return forms.flatMap(form => [...new FormData(form)]);
}

// Shows the charts and the rows of what is chosen.
function show(section) {
  const chosen = choice(section);
  for (const part of section.querySelectorAll('figure, tbody tr')) {
    const data = part.dataset;
    part.hidden = chosen.some(([name, value]) => value !== 'all' && name in data && data[name] !== value);
  }
}

// Compares two cells; what is no number comes last in either direction.
function compare(a, b, sign) {
  if (a.dataset.value === undefined) return sign * a.textContent.localeCompare(b.textContent);
  const [x, y] = [a, b].map(cell => parseFloat(cell.dataset.value.replace('inf', 'Infinity')));
  if (isNaN(x) || isNaN(y)) return isNaN(x) - isNaN(y);
  return x === y ? 0 : sign * (x < y ? -1 : 1);
}

function sort(head) {
  const place = head.cellIndex;
  const body = head.closest('table').tBodies[0];
  const direction = head.getAttribute('aria-sort') === 'ascending' ? 'descending' : 'ascending';
  for (const other of head.parentNode.cells) other.removeAttribute('aria-sort');
  head.setAttribute('aria-sort', direction);
  const sign = direction === 'ascending' ? 1 : -1;
  const rows = [...body.rows];
  rows.sort((a, b) => compare(a.cells[place], b.cells[place], sign));
  body.append(...rows);
}

for (const button of document.querySelectorAll('th button')) {
  button.addEventListener('click', () => sort(button.parentNode));
}
for (const form of document.querySelectorAll('.choice')) {
  const section = form.closest('section');
  form.hidden = false;
  form.addEventListener('change', () => show(section));
  form.addEventListener('submit', event => event.preventDefault());
  form.reset();
  show(section);
}
