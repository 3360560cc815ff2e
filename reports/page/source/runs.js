// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of the page: which are shown and which one is pointed at, the same for all figures and tables.
import { colour } from './colours.js';

const order = new Map();  // name -> index
const hidden = new Set();
const events = new EventTarget();
let pointed = null;

export function noteRuns(names) {
  for (const name of names) if (!order.has(name)) order.set(name, order.size);
}

export const runNames = () => [...order.keys()];
export const isRun = (name) => order.has(name);
export const isShown = (run) => !hidden.has(run);
export const pointedRun = () => pointed;

export function runColour(run) {
  noteRuns([run]);
  return colour(order.get(run));
}

function changed() {
  for (const section of document.querySelectorAll('[data-run]')) {
    section.classList.toggle('off', hidden.has(section.dataset.run));
    section.classList.toggle('pointed', section.dataset.run === pointed);
  }
  events.dispatchEvent(new Event('change'));
}

/** Shows or hides runs. */
export function showRuns(names, shown) {
  for (const name of names) shown ? hidden.delete(name) : hidden.add(name);
  changed();
}

/** Points at a run; null: at none. */
export function pointAt(run) {
  if (run === pointed) return;
  pointed = run;
  changed();
}

/** Calls `listener` at each change; returns what ends that. */
export function onRuns(listener) {
  events.addEventListener('change', listener);
  return () => events.removeEventListener('change', listener);
}

/** Points at the run while the pointer or the focus is in the element. */
export function pointsAt(element, run) {
  for (const name of ['pointerenter', 'focusin']) element.addEventListener(name, () => pointAt(run));
  for (const name of ['pointerleave', 'focusout']) element.addEventListener(name, () => pointAt(null));
}
