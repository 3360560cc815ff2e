// SPDX-License-Identifier: GPL-3.0-or-later
// The values under the pointer, or of the point that the arrow keys have walked to.
import { digits, element } from './blocks.js';
import { isDrawn, seriesColour, usable } from './option.js';
import { isRun, pointAt } from './runs.js';
import { pixelsOf, plotEdges } from './window.js';

const reach = 40;  // pixels from the pointer to the nearest point

/** All drawn points within the plot. */
function* points(view) {
  const [left, right, top, bottom] = plotEdges(view.chart);
  const pixel = pixelsOf(view.chart, view.state.log);
  for (const [s, series] of view.data.series.entries()) {
    if (!isDrawn(view.data, view.state, series)) continue;
    for (let i = 0; i < series.x.length; ++i) {
      if (!usable(view.state, series.x[i], series.y[i])) continue;
      const [u, v] = pixel(series.x[i], series.y[i]);
      if (u >= left - 1 && u <= right + 1 && v >= top - 1 && v <= bottom + 1) yield { s, i, u, v };
    }
  }
}

export function nearest(view, u, v) {
  let best = null, least = reach * reach;
  for (const point of points(view)) {
    const d = (point.u - u) ** 2 + (point.v - v) ** 2;
    if (d < least) [best, least] = [point, d];
  }
  return best;
}

/** The next point of the series (along), or the first of the next series (across). */
export function neighbour(view, from, along, across) {
  const all = [...points(view)];
  if (!all.length) return null;
  const at = from ? all.findIndex((p) => p.s === from.s && p.i === from.i) : -1;
  if (at < 0) return all[0];
  if (!across) return all[Math.min(Math.max(at + along, 0), all.length - 1)];
  const drawn = [...new Set(all.map((p) => p.s))];
  const next = drawn[(drawn.indexOf(from.s) + across + drawn.length) % drawn.length];
  return all.find((p) => p.s === next);
}

const withError = (value, error) => digits(value) + (error > 0 ? ` \u00b1 ${digits(error)}` : '');

/** A curve by its run and label, which may begin with the run. */
export function curveName({ run, label }) {
  return run && !label.startsWith(run) ? `${run} \u00b7 ${label}` : label;
}

/** A curve, and the point of it if it has a name. */
export function pointName(series, i) {
  return series.names?.[i] ? `${curveName(series)} \u00b7 ${series.names[i]}` : curveName(series);
}

/** The run that a point is of; null if it is not known. */
function runOf({ run, names }, i) {
  return run ?? (isRun(names?.[i]) ? names[i] : null);
}

export function valueLines(data, { s, i }) {
  const series = data.series[s];
  return [pointName(series, i),
          `${data.x.label}: ${withError(series.x[i], series.x_error?.[i])}`,
          `${data.y.label}: ${withError(series.y[i], series.y_error?.[i])}`];
}

/** The box with the values and the ring about the point; `show(null)` takes them away. */
export function valueBox(view) {
  const box = element('div', { className: 'values', hidden: true });
  const ring = element('div', { className: 'ring', hidden: true });
  view.place.append(ring, box);
  let shown = null;
  const show = (point) => {
    shown = point;
    box.hidden = ring.hidden = !point;
    pointAt(point ? runOf(view.data.series[point.s], point.i) : null);
    if (!point) return;
    box.replaceChildren(...valueLines(view.data, point).map((t) => element('div', {}, t)));
    ring.style.borderColor = seriesColour(view.data, point.s);
    ring.style.transform = `translate(${point.u - 6}px, ${point.v - 6}px)`;
    const { clientWidth, clientHeight } = view.place;
    const x = point.u + 14 + box.offsetWidth > clientWidth ? point.u - 14 - box.offsetWidth : point.u + 14;
    const y = Math.min(Math.max(point.v - box.offsetHeight - 8, 2), clientHeight - box.offsetHeight - 2);
    box.style.transform = `translate(${Math.max(x, 2)}px, ${y}px)`;
  };
  return { show, shown: () => shown };
}
