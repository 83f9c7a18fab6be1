// The box that says what a mark stands for.
const tip = document.createElement('div');
tip.id = 'tip';
tip.setAttribute('role', 'tooltip');
tip.hidden = true;
document.body.append(tip);
let pointed = null;

// The lines that a mark says; the browser's own tooltip is taken away.
function words(mark) {
  const title = mark.querySelector('title');
  if (title) {
    mark.setAttribute('aria-label', title.textContent);
    title.remove();
  }
  return mark.getAttribute('aria-label').split('\n');
}

function point(mark, hint) {
  if (pointed === mark) return;
  pointed = mark;
  const [name, ...lines] = words(mark);
  const strong = document.createElement('strong');
  strong.textContent = name;
  tip.replaceChildren(strong, ...lines.map(line => Object.assign(document.createElement('div'), {textContent: line})));
  if (mark.tagName === 'a') tip.append(Object.assign(document.createElement('em'), {textContent: hint}));
  tip.hidden = false;
  place(mark);
}

// Puts the box beside a mark, within the window.
function place(mark) {
  const at = mark.getBoundingClientRect();
  const {width, height} = tip.getBoundingClientRect();
  const room = document.documentElement.clientWidth - width - 8;
  const below = at.bottom + 8 + height < innerHeight;
  tip.style.left = `${Math.max(8, Math.min(at.left + at.width / 2 - width / 2, room))}px`;
  tip.style.top = `${below ? at.bottom + 8 : Math.max(8, at.top - height - 8)}px`;
}

function unpoint() {
  pointed = null;
  tip.hidden = true;
}

// The mark that an event is about.
function marked(event) {
  return event.target instanceof Element ? event.target.closest('.mark') : null;
}

// Whether a finger touched a mark that was not pointed at: then the first tap points, and the second follows.
let tapped = false;
document.addEventListener('pointerover', event => {
  if (event.pointerType === 'touch') return;
  const mark = marked(event);
  if (mark) point(mark, 'Click: its method’s page');
  // Scrolling to what has the focus moves the page under a pointer that rests.
  else if (pointed !== document.activeElement) unpoint();
});
document.addEventListener('pointerdown', event => {
  const mark = marked(event);
  tapped = event.pointerType === 'touch' && mark !== null && mark !== pointed;
  if (!mark) unpoint();
});
document.addEventListener('click', event => {
  const mark = marked(event);
  if (!mark || !tapped) return;
  event.preventDefault();
  point(mark, 'Tap again: its method’s page');
}, true);
document.addEventListener('focusin', event => {
  const mark = marked(event);
  if (mark && mark.matches(':focus-visible')) point(mark, 'Enter: its method’s page');
});
document.addEventListener('focusout', unpoint);
document.addEventListener('scroll', () => pointed && place(pointed), {capture: true, passive: true});
document.addEventListener('keydown', event => {
  if (event.key === 'Escape') unpoint();
});
