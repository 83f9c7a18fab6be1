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

// Shows the groups of columns whose boxes are ticked.
function fold(section) {
  const boxes = [...section.querySelectorAll('input[name="columns"]')];
  const hidden = boxes.filter(box => !box.checked).map(box => box.value);
  for (const table of section.querySelectorAll('table')) {
    [...table.tHead?.rows[0].cells ?? []].forEach((head, place) => {
      const fold = hidden.includes(head.dataset.group);
      if (head.hidden === fold) return;
      for (const row of table.rows) row.cells[place].hidden = fold;
    });
  }
}

// Copies the code that a button names, or the command beside it; where the clipboard is refused, it is selected.
async function copy(button) {
  const named = button.dataset.copyFrom;
  const code = named ? document.getElementById(named) : button.parentNode.querySelector('code');
  const said = button.textContent;
  try {
    await navigator.clipboard.writeText(code.textContent);
    button.textContent = 'copied';
  } catch {
    getSelection().selectAllChildren(code);
    button.textContent = 'selected';
  }
  setTimeout(() => { button.textContent = said; }, 1500);
}
