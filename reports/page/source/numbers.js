// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a figure as a table, for those who do not see it and for copying.
import { digits, element } from './blocks.js';
import { pointName } from './hover.js';
import { makeSortable } from './table.js';

const most = 2000;  // rows

function rows(data) {
  return data.series.flatMap((series) => series.x.map((x, i) =>
    [pointName(series, i), digits(x),
     digits(series.y[i]) + (series.y_error?.[i] > 0 ? ` \u00b1 ${digits(series.y_error[i])}` : '')]));
}

export function numbersTable(data) {
  const all = rows(data);
  const line = (cells) => element('tr', {}, ...cells.map((c, k) =>
    element('td', { className: k ? 'number' : '' }, c)));
  const head = ['curve', data.x.label, data.y.label].map((t) => element('th', { scope: 'col' }, t));
  const table = element('table', {}, element('thead', {}, element('tr', {}, ...head)),
                        element('tbody', {}, ...all.slice(0, most).map(line)));
  makeSortable(table);
  const place = element('div', { className: 'scroll numbers', tabIndex: 0, role: 'region',
                                 'aria-label': `Numbers of ${data.title}` }, table);
  if (all.length > most)
    place.append(element('p', { className: 'quiet' }, `The first ${most} of ${all.length} points.`));
  return place;
}
