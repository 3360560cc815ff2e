// SPDX-License-Identifier: GPL-3.0-or-later
// What Apache ECharts is told to draw: axes, curves, points and error bars of a figure.
import { digits } from './blocks.js';
import { colour } from './colours.js';
import { isShown, pointedRun, runColour } from './runs.js';
import { dark, styled } from './theme.js';

const runs = new WeakMap();  // of figures' data

/** The runs that a figure's series are of. */
export function runsOf(data) {
  if (!runs.has(data)) runs.set(data, [...new Set(data.series.map((s) => s.run).filter(Boolean))]);
  return runs.get(data);
}

/** Colour of a series: where runs are compared of its run, or that of text; else of its place. */
export function seriesColour(data, index) {
  if (runsOf(data).length < 2) return colour(index);
  const { run } = data.series[index];
  return run ? runColour(run) : styled('--text');
}

/** Whether a series is drawn. The one run of a figure is always drawn. */
export function isDrawn(data, state, series) {
  if (state.hiddenLabels.has(series.label)) return false;
  return !series.run || runsOf(data).length < 2 || isShown(series.run);
}

function axis(data, state, name) {
  const quiet = styled('--quiet');
  const [min, max] = state.window?.[name] ?? [];
  return {
    type: state.log[name] ? 'log' : 'value', scale: true, min, max,
    name: data[name].label, nameLocation: 'middle', nameGap: name === 'x' ? 28 : undefined,
    nameTextStyle: { color: styled('--text'), fontSize: 13 },
    axisLine: { show: true, onZero: false, lineStyle: { color: quiet } },
    axisTick: { show: true },
    axisLabel: { color: quiet, hideOverlap: true, showMinLabel: !state.window, showMaxLabel: !state.window,
                 formatter: digits },
    splitLine: { show: true, lineStyle: { color: styled('--line'), type: 'dotted' } },
  };
}

/** The ends of a whisker about a value; on a log axis one that reaches zero has no lower end. */
function ends(value, error, log) {
  if (!(error > 0)) return [null, null];
  return [log && value - error <= 0 ? null : value - error, value + error];
}

/** A line with caps of 6 pixels where it ends, without one where it leaves the plot at `beyond`. */
function whisker(from, to, beyond, across) {
  const cap = ([x, y]) => [x - across[0], y - across[1], x + across[0], y + across[1]];
  const start = from ?? [across[0] ? to[0] : beyond, across[0] ? beyond : to[1]];
  return [[...start, ...to], cap(to), ...(from ? [cap(from)] : [])];
}

function errorBars(series, look, state) {
  const rows = series.x.map((x, i) => [x, series.y[i], ...ends(x, series.x_error?.[i], state.log.x),
                                       ...ends(series.y[i], series.y_error?.[i], state.log.y)])
    .filter(([x, y]) => usable(state, x, y));
  return {
    type: 'custom', clip: true, silent: true, z: look.z, data: rows, encode: { x: [0, 2, 3], y: [1, 4, 5] },
    renderItem({ coordSys, dataIndex }, api) {
      const [x, y, x1, x2, y1, y2] = rows[dataIndex];
      const lines = [];
      if (x2 !== null)
        lines.push(...whisker(x1 === null ? null : api.coord([x1, y]), api.coord([x2, y]), coordSys.x, [0, 3]));
      if (y2 !== null)
        lines.push(...whisker(y1 === null ? null : api.coord([x, y1]), api.coord([x, y2]),
                              coordSys.y + coordSys.height, [3, 0]));
      const style = { stroke: look.colour, lineWidth: 1.2, opacity: look.opacity };
      return { type: 'group', children: lines.map(([xa, ya, xb, yb]) =>
        ({ type: 'line', shape: { x1: xa, y1: ya, x2: xb, y2: yb }, style })) };
    },
  };
}

function drawn(series, look, state) {
  const points = series.x.map((x, i) => (usable(state, x, series.y[i]) ? [x, series.y[i]] : [null, null]));
  const common = { data: points, silent: true, animation: false, z: look.z };
  if (series.style === 'points')
    return { ...common, type: 'scatter', clip: state.window !== null, symbolSize: look.strong ? 9 : 6,
             itemStyle: { color: look.colour, opacity: look.opacity } };
  const type = { dashed: 'dashed', dotted: 'dotted', 'dash-dotted': [9, 4, 2, 4] }[series.style] ?? 'solid';
  return { ...common, type: 'line', clip: true, showSymbol: false, connectNulls: false,
           lineStyle: { color: look.colour, width: look.strong ? 3.5 : 2, type, opacity: look.opacity } };
}

/** Whether a point has a place on the axes. */
export function usable(state, x, y) {
  return Number.isFinite(x) && Number.isFinite(y) && !(state.log.x && x <= 0) && !(state.log.y && y <= 0);
}

export function chartOption(data, state) {
  const many = runsOf(data).length > 1;
  const pointed = many && runsOf(data).includes(pointedRun()) ? pointedRun() : null;
  const series = [];
  data.series.forEach((s, index) => {
    if (!isDrawn(data, state, s)) return;
    const strong = pointed !== null && s.run === pointed;
    const look = { colour: seriesColour(data, index), strong, z: strong ? 4 : 2,
                   opacity: pointed === null || strong ? 1 : 0.15 };
    series.push(drawn(s, look, state));
    if (s.x_error || s.y_error) series.push(errorBars(s, look, state));
  });
  return { animation: false, darkMode: dark(), backgroundColor: 'transparent',
           textStyle: { fontFamily: getComputedStyle(document.body).fontFamily },
           grid: { left: 8, right: 18, top: 14, bottom: 8 },
           xAxis: axis(data, state, 'x'), yAxis: axis(data, state, 'y'), series };
}
