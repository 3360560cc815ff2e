// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the axes that is seen. On a log axis lengths are those of the logarithms.

const forward = (log, value) => (log ? Math.log(value) : value);
const backward = (log, value) => (log ? Math.exp(value) : value);

/** Values at two corners of the plot, by pixel. */
export function windowBetween(chart, a, b) {
  const place = { xAxisIndex: 0, yAxisIndex: 0 };
  const [p, q] = [chart.convertFromPixel(place, a), chart.convertFromPixel(place, b)];
  const sorted = (k) => [Math.min(p[k], q[k]), Math.max(p[k], q[k])];
  return { x: sorted(0), y: sorted(1) };
}

/** Left, right, top and bottom of the plot in pixels. */
export function plotEdges(chart) {
  const { x, y, width, height } = chart.getModel().getComponent('grid').coordinateSystem.getRect();
  return [x, x + width, y, y + height];
}

export function shownWindow(chart) {
  const [left, right, top, bottom] = plotEdges(chart);
  return windowBetween(chart, [left, top], [right, bottom]);
}

/** The window made `factor` times as long about a part (0 to 1) of each axis, then moved by parts. */
export function changedWindow(window, log, { factor = 1, about = [0.5, 0.5], move = [0, 0] }) {
  const change = (name, k) => {
    const [least, greatest] = window[name].map((v) => forward(log[name], v));
    const length = greatest - least, start = least + length * (about[k] * (1 - factor) + move[k]);
    return [start, start + length * factor].map((v) => backward(log[name], v));
  };
  return { x: change('x', 0), y: change('y', 1) };
}

/** A function from values to pixels, faster for many points than asking the chart for each. */
export function pixelsOf(chart, log) {
  const [left, right, top, bottom] = plotEdges(chart);
  const { x, y } = shownWindow(chart);
  const along = (isLog, [least, greatest], from, to) => {
    const a = forward(isLog, least), slope = (to - from) / (forward(isLog, greatest) - a);
    return (value) => from + slope * (forward(isLog, value) - a);
  };
  const [u, v] = [along(log.x, x, left, right), along(log.y, y, bottom, top)];
  return (px, py) => [u(px), v(py)];
}
