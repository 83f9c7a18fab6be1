'use strict';

// Shows the chart that is chosen, and the rows of its light.
function show() {
  const light = document.getElementById('light').value;
  const kind = document.querySelector('input[name="kind"]:checked').value;
  const all = document.getElementById('all').checked;
  for (const figure of document.querySelectorAll('figure')) {
    figure.hidden = figure.dataset.light !== light || figure.dataset.kind !== kind;
  }
  document.getElementById('measurements').classList.toggle('one-light', !all);
  for (const row of document.querySelectorAll('#measurements tbody tr')) {
    row.hidden = !all && row.dataset.light !== light;
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
if (document.querySelector('figure')) {
  for (const form of document.querySelectorAll('.choice')) {
    form.hidden = false;
    form.addEventListener('change', show);
    form.addEventListener('submit', event => event.preventDefault());
  }
  document.querySelector('.choice').reset();
  show();
}
