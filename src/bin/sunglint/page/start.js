// Unfolds what an address within the page names, and what it lies in.
function unfold(address) {
  const target = address.length > 1 ? document.getElementById(decodeURIComponent(address.slice(1))) : null;
  if (!target) return;
  const own = target.matches('details') ? target : target.querySelector(':scope > details');
  if (own) own.open = true;
  for (let part = target.closest('details'); part; part = part.parentElement.closest('details')) part.open = true;
  target.scrollIntoView();
}

document.addEventListener('click', event => {
  if (!(event.target instanceof Element) || event.defaultPrevented) return;
  const head = event.target.closest('th button');
  const button = event.target.closest('button.copy');
  const link = event.target.closest('a[href^="#"]');
  if (head) sort(head.parentNode);
  if (button) copy(button);
  if (link) unfold(link.getAttribute('href'));
});
addEventListener('hashchange', () => unfold(location.hash));
document.addEventListener('toggle', event => {
  if (event.target instanceof HTMLDetailsElement) fill(event.target);
}, true);
for (const form of document.querySelectorAll('.choice')) {
  const section = form.closest('section');
  form.hidden = false;
  form.reset();
  form.addEventListener('submit', event => event.preventDefault());
  form.addEventListener('input', () => heed(section));
}
for (const section of document.querySelectorAll('section')) heed(section);
for (const details of document.querySelectorAll('details[open]')) fill(details);
if (location.hash) unfold(location.hash);
