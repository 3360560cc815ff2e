// SPDX-License-Identifier: GPL-3.0-or-later
// What Apache ECharts is told to draw: axes, curves, points and error bars of a figure.
import { digits } from './blocks.js';
import { colour } from './colours.js';
import { isShown, pointedRun, runColour } from './runs.js';
import { dark, styled } from './theme.js';

/** The runs that a figure's series are of. */
export const runsOf = (data) => [...new Set(data.series.map((s) => s.run).filter(Boolean))];

/** Colour of a series: of its run if the figure compares runs, else of its place in the figure. */
export function seriesColour(data, index) {
  const { run } = data.series[index];
  return run && runsOf(data).length > 1 ? runColour(run) : colour(index);
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
    name: data[name].label, nameLocation: 'middle',
    nameTextStyle: { color: styled('--text'), fontSize: 13 },
    axisLine: { show: true, onZero: false, lineStyle: { color: quiet } },
    axisTick: { show: true },
    axisLabel: { color: quiet, hideOverlap: true, showMinLabel: !state.window, showMaxLabel: !state.window,
                 formatter: digits },
    splitLine: { show: true, lineStyle: { color: styled('--line'), type: 'dotted' } },
  };
}

/** Whiskers from y - error to y + error (and the same in x), with caps of 6 pixels. */
function errorBars(series, look) {
  const rows = series.x.map((x, i) => [x, series.y[i], series.x_error?.[i] ?? 0, series.y_error?.[i] ?? 0]);
  const whisker = ([x1, y1], [x2, y2], [u, v]) => [
    [x1, y1, x2, y2], [x1 - u, y1 - v, x1 + u, y1 + v], [x2 - u, y2 - v, x2 + u, y2 + v]];
  return {
    type: 'custom', clip: true, silent: true, z: look.z, data: rows, encode: { x: 0, y: 1 },
    renderItem(_, api) {
      const [x, y, dx, dy] = [0, 1, 2, 3].map((k) => api.value(k));
      const lines = [];
      if (dx > 0) lines.push(...whisker(api.coord([x - dx, y]), api.coord([x + dx, y]), [0, 3]));
      if (dy > 0) lines.push(...whisker(api.coord([x, y - dy]), api.coord([x, y + dy]), [3, 0]));
      const style = { stroke: look.colour, lineWidth: 1.2, opacity: look.opacity };
      return { type: 'group', children: lines.map(([x1, y1, x2, y2]) =>
        ({ type: 'line', shape: { x1, y1, x2, y2 }, style })) };
    },
  };
}

function drawn(series, look, usable) {
  const points = series.x.map((x, i) => (usable(x, series.y[i]) ? [x, series.y[i]] : [null, null]));
  const common = { data: points, silent: true, animation: false, clip: true, z: look.z };
  if (series.style === 'points')
    return { ...common, type: 'scatter', symbolSize: look.strong ? 9 : 6,
             itemStyle: { color: look.colour, opacity: look.opacity } };
  const type = series.style === 'dashed' ? 'dashed' : 'solid';
  return { ...common, type: 'line', showSymbol: false, connectNulls: false,
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
    series.push(drawn(s, look, (x, y) => usable(state, x, y)));
    if (s.x_error || s.y_error) series.push(errorBars(s, look));
  });
  return { animation: false, darkMode: dark(), backgroundColor: 'transparent',
           textStyle: { fontFamily: getComputedStyle(document.body).fontFamily },
           grid: { left: 8, right: 18, top: 14, bottom: 8 },
           xAxis: axis(data, state, 'x'), yAxis: axis(data, state, 'y'), series };
}
