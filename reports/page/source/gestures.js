// SPDX-License-Identifier: GPL-3.0-or-later
// Pointer and keys on a chart: values under the pointer, a box drawn to zoom into, shift and wheel, arrow
// keys from point to point, + and - and 0 to zoom, shift and arrows to move.
import { element } from './blocks.js';
import { nearest, neighbour } from './hover.js';
import { plotEdges, windowBetween } from './window.js';

const least = 8;  // pixels of a box that is meant

function inPlot(view, event) {
  const { left, top } = view.place.getBoundingClientRect();
  const [x0, x1, y0, y1] = plotEdges(view.chart);
  const clamp = (v, a, b) => Math.min(Math.max(v, a), b);
  return [clamp(event.clientX - left, x0, x1), clamp(event.clientY - top, y0, y1)];
}

function boxZoom(view) {
  const box = element('div', { className: 'zoom-box', hidden: true });
  view.place.append(box);
  let from = null;
  const size = ([x, y]) => [Math.abs(x - from[0]), Math.abs(y - from[1])];
  view.place.addEventListener('pointerdown', (event) => {
    if (event.button !== 0 || event.pointerType === 'touch') return;
    from = inPlot(view, event);
    view.place.setPointerCapture(event.pointerId);
  });
  view.place.addEventListener('pointermove', (event) => {
    if (!from) return;
    const to = inPlot(view, event), [width, height] = size(to);
    box.hidden = width < least && height < least;
    box.style.transform = `translate(${Math.min(from[0], to[0])}px, ${Math.min(from[1], to[1])}px)`;
    box.style.width = `${width}px`;
    box.style.height = `${height}px`;
  });
  view.place.addEventListener('pointerup', (event) => {
    if (!from) return;
    const to = inPlot(view, event), [width, height] = size(to);
    if (width >= least && height >= least) view.setWindow(windowBetween(view.chart, from, to));
    from = null;
    box.hidden = true;
  });
  view.place.addEventListener('pointercancel', () => (from = null, (box.hidden = true)));
  return () => from !== null;
}

function wheelZoom(view) {
  view.place.addEventListener('wheel', (event) => {
    if (!event.shiftKey && !event.ctrlKey) return;
    event.preventDefault();
    const [x0, x1, y0, y1] = plotEdges(view.chart), [x, y] = inPlot(view, event);
    const about = [(x - x0) / (x1 - x0), (y1 - y) / (y1 - y0)];
    view.change({ factor: event.deltaY + event.deltaX > 0 ? 1.25 : 0.8, about });
  }, { passive: false });
}

const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

function keys(view) {
  view.place.addEventListener('keydown', (event) => {
    const arrow = arrows[event.key];
    if (arrow && event.shiftKey) view.change({ move: arrow.map((v) => 0.2 * v) });
    else if (arrow) view.values.show(neighbour(view, view.values.shown(), arrow[0], arrow[1]));
    else if (event.key === '+') view.change({ factor: 0.5 });
    else if (event.key === '-') view.change({ factor: 2 });
    else if (event.key === '0') view.setWindow(null);
    else if (event.key === 'Escape') view.values.show(null);
    else return;
    event.preventDefault();
  });
  view.place.addEventListener('blur', () => view.values.show(null));
}

export function addGestures(view) {
  const boxing = boxZoom(view);
  let frame = 0;
  view.place.addEventListener('pointermove', (event) => {
    cancelAnimationFrame(frame);
    frame = requestAnimationFrame(() => {
      if (!boxing() && view.isLive()) view.values.show(nearest(view, ...inPlot(view, event)));
    });
  });
  view.place.addEventListener('pointerleave', () => {
    cancelAnimationFrame(frame);
    view.values.show(null);
  });
  view.place.addEventListener('dblclick', () => view.setWindow(null));
  wheelZoom(view);
  keys(view);
}
