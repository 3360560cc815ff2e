// SPDX-License-Identifier: GPL-3.0-or-later
// The list of runs: tick boxes that act on all figures and tables, and a filter if there are many.
import { element } from './blocks.js';
import { isShown, onRuns, pointsAt, runColour, runNames, showRuns } from './runs.js';
import { onTheme } from './theme.js';

const filterFrom = 12;  // runs

function entry(run) {
  const box = element('input', { type: 'checkbox', checked: true });
  const swatch = element('span', { className: 'swatch' });
  const label = element('label', {}, box, swatch, run);
  box.addEventListener('change', () => showRuns([run], box.checked));
  pointsAt(label, run);
  return { run, box, swatch, label };
}

function filter(entries) {
  const field = element('input', { type: 'search', placeholder: 'part of a name' });
  field.addEventListener('input', () => {
    const wanted = field.value.toLowerCase();
    for (const { run, label } of entries) label.hidden = !run.toLowerCase().includes(wanted);
  });
  return element('label', { className: 'filter' }, 'Find runs ', field);
}

function switches(entries) {
  const listed = () => entries.filter((e) => !e.label.hidden).map((e) => e.run);
  return [['Show all', true], ['Hide all', false]].map(([text, shown]) => {
    const button = element('button', { type: 'button' }, text);
    button.addEventListener('click', () => showRuns(listed(), shown));
    return button;
  });
}

/** Above the first section. */
export function addRunsPanel() {
  const names = runNames();
  if (names.length < 2) return;
  const entries = names.map(entry);
  const paint = () => entries.forEach((e) => (e.swatch.style.background = runColour(e.run)));
  const tick = () => entries.forEach((e) => (e.box.checked = isShown(e.run)));
  const tools = element('div', { className: 'tools' }, ...switches(entries));
  if (names.length >= filterFrom) tools.prepend(filter(entries));
  const panel = element('details', { className: 'runs', open: names.length < filterFrom },
    element('summary', {}, `Runs in the figures (${names.length})`), tools,
    element('div', { className: 'run-list', role: 'group', 'aria-label': 'Runs' }, ...entries.map((e) => e.label)));
  document.querySelector('main h2').before(panel);
  paint();
  onTheme(paint);
  onRuns(tick);
}
