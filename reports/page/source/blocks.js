// SPDX-License-Identifier: GPL-3.0-or-later
// The page's data blocks and the few ways in which elements are made.

/** What the block <script type="application/json" id="..."> holds; undefined if there is none. */
export function json(id) {
  const block = document.querySelector(`script[id="${CSS.escape(id)}"]`);  // headings have ids, too: runs' names
  return block ? JSON.parse(block.textContent) : undefined;
}

/** Numbers of a list, or of a block of little-endian 16-bit integers with origin and step. */
export function numbers(packed) {
  if (Array.isArray(packed)) return Float32Array.from(packed);
  const bytes = Uint8Array.from(atob(packed.int16), (c) => c.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  return Float32Array.from({ length: bytes.length / 2 }, (_, i) =>
    packed.origin[i % packed.origin.length] + packed.step * view.getInt16(2 * i, true));
}

/** <name properties>children</name>; a property that is no DOM property is an attribute. */
export function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties))
    if (key in made) made[key] = value;
    else made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/** A button that is pressed or not; `changed` is told which. */
export function toggle(text, pressed, changed, title = '') {
  const button = element('button', { type: 'button', title }, text);
  const set = (on) => button.setAttribute('aria-pressed', on);
  set(pressed);
  button.addEventListener('click', () => {
    const on = button.getAttribute('aria-pressed') !== 'true';
    set(on);
    changed(on);
  });
  return button;
}

export function push(text, label, clicked) {
  const button = element('button', { type: 'button', title: label, 'aria-label': label }, text);
  button.addEventListener('click', clicked);
  return button;
}

/** A number as text, six digits. */
export function digits(value) {
  return Number.isFinite(value) ? String(Number(value.toPrecision(6))).replace('-', '\u2212') : '\u2013';
}
