// SPDX-License-Identifier: GPL-3.0-or-later
// A figure that shows values, zooms, has log axes, and hides curves and runs.
import { CustomChart, LineChart, ScatterChart } from 'echarts/charts';
import { GridComponent } from 'echarts/components';
import { init, use } from 'echarts/core';
import { CanvasRenderer } from 'echarts/renderers';

import { element, json, push, toggle } from './blocks.js';
import { addGestures } from './gestures.js';
import { valueBox } from './hover.js';
import { legend } from './legend.js';
import { numbersTable } from './numbers.js';
import { chartOption, runsOf } from './option.js';
import { onRuns } from './runs.js';
import { onTheme } from './theme.js';
import { changedWindow, shownWindow } from './window.js';

use([LineChart, ScatterChart, CustomChart, GridComponent, CanvasRenderer]);

const states = new WeakMap();  // of figures, kept while they are still

function stateOf(figure, data) {
  if (!states.has(figure))
    states.set(figure, { log: { x: data.x.log, y: data.y.log }, window: null, hiddenLabels: new Set() });
  return states.get(figure);
}

function tools(view) {
  const log = (name) => toggle(`log ${name}`, view.state.log[name], (on) => {
    view.state.log[name] = on;
    view.setWindow(null);
  }, `Logarithmic ${name} axis`);
  let table = null;
  const numbers = toggle('Numbers', false, (on) => {
    table?.remove();
    table = on ? numbersTable(view.data) : null;
    if (table) view.live.append(table);
  }, 'The points as a table');
  return element('div', { className: 'tools', role: 'group', 'aria-label': 'Axes and zoom' },
    element('span', { className: 'title' }, view.data.title), log('x'), log('y'),
    push('+', 'Zoom in', () => view.change({ factor: 0.5 })),
    push('\u2212', 'Zoom out', () => view.change({ factor: 2 })),
    push('Reset', 'Reset the zoom', () => view.setWindow(null)), numbers);
}

function makeView(figure, data) {
  const place = element('div', { className: 'chart', tabIndex: 0, role: 'group',
    'aria-roledescription': 'interactive figure',
    'aria-label': `${data.title}. ${data.alt} Arrow keys walk along the points, plus and minus zoom.` });
  const canvas = element('div', { className: 'canvas' });
  place.append(canvas);
  const live = element('div', { className: 'live' }, place);
  figure.prepend(live);
  const view = { figure, data, place, live, state: stateOf(figure, data), chart: init(canvas) };
  view.isLive = () => !view.chart.isDisposed();
  view.draw = () => view.isLive() && view.chart.setOption(chartOption(data, view.state), true);
  view.setWindow = (window) => {
    view.state.window = window;
    view.values.show(null);
    view.draw();
  };
  view.change = (how) => view.setWindow(changedWindow(shownWindow(view.chart), view.state.log, how));
  view.values = valueBox(view);
  return view;
}

/** The live part of a figure with its data in the block figure-NAME. */
export function chartView(figure) {
  const data = json(`figure-${figure.dataset.figure}`);
  if (!data?.series?.length) return null;
  const view = makeView(figure, data);
  const curves = legend(view);
  view.live.prepend(tools(view));
  view.live.append(curves.list);
  addGestures(view);
  view.draw();
  let frame = 0;
  const later = () => (cancelAnimationFrame(frame), (frame = requestAnimationFrame(view.draw)));
  const ends = [onTheme(later), curves.release];
  if (runsOf(data).length > 1) ends.push(onRuns(later));
  const resized = new ResizeObserver(() => view.chart.resize());
  resized.observe(view.place);
  return { release() {
    ends.forEach((end) => end());
    resized.disconnect();
    view.chart.dispose();
    view.live.remove();
  } };
}
