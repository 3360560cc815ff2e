// SPDX-License-Identifier: GPL-3.0-or-later
// Tables sorted by a click or a key on the head of a column; rows of runs linked with the figures.
import { element } from './blocks.js';
import { isRun, pointsAt } from './runs.js';

const text = (row, column) => row.cells[column]?.dataset.value ?? row.cells[column]?.textContent.trim() ?? '';

/** The number that a cell begins with; NaN if it is none. */
const number = (row, column) => parseFloat(text(row, column).replace('\u2212', '-'));

/** Numbers before text, both in order. */
function compare(a, b, column) {
  const [p, q] = [number(a, column), number(b, column)];
  if (Number.isNaN(p) || Number.isNaN(q)) {
    if (Number.isNaN(p) !== Number.isNaN(q)) return Number.isNaN(p) ? 1 : -1;
    return text(a, column).localeCompare(text(b, column), 'en', { numeric: true });
  }
  return p - q;
}

function sortBy(table, heads, column) {
  const up = heads[column].getAttribute('aria-sort') !== 'ascending';
  const body = table.tBodies[0];
  const rows = [...body.rows].sort((a, b) => (up ? 1 : -1) * compare(a, b, column));
  body.append(...rows);
  heads.forEach((head) => head.removeAttribute('aria-sort'));
  heads[column].setAttribute('aria-sort', up ? 'ascending' : 'descending');
}

function linkRuns(table) {
  for (const row of table.tBodies[0].rows) {
    const run = row.dataset.run ?? text(row, 0);
    if (!isRun(run)) continue;
    row.dataset.run = run;
    pointsAt(row, run);
  }
}

export function makeSortable(table) {
  if (!table.tHead || !table.tBodies.length) return;
  linkRuns(table);
  if (table.tBodies[0].rows.length < 2) return;
  const heads = [...table.tHead.rows[0].cells];
  heads.forEach((head, column) => {
    const button = element('button', { type: 'button' }, ...head.childNodes);
    button.addEventListener('click', () => sortBy(table, heads, column));
    head.append(button);
  });
}
