// SPDX-License-Identifier: GPL-3.0-or-later
// The 3-D view: defect atoms, dislocation lines and fault planes of chosen frames.
import { element, json, push, toggle } from './blocks.js';
import { atomsObject, lineObject, planeObject } from './scene_parts.js';
import { Stage, painter, perAngle } from './stage.js';
import { onTheme } from './theme.js';

function fill(view) {
  const frame = view.data.frames[view.frame];
  view.stage.clear();
  for (const plane of frame.planes ?? []) view.stage.content.add(planeObject(plane, view.data.unit));
  for (const atoms of frame.atoms ?? []) view.stage.content.add(atomsObject(atoms, perAngle));
  for (const line of frame.lines ?? []) view.stage.content.add(lineObject(line, view.data.unit));
  show(view);
}

function show(view) {
  for (const thing of view.stage.content.children) thing.visible = !view.hidden.has(thing.userData.layer);
  view.stage.repaint();
}

/** All layers of all frames: [name, colour, class of the swatch]. */
function layers(data) {
  const all = new Map();
  for (const frame of data.frames)
    for (const [list, swatch] of [[frame.lines, 'line'], [frame.planes, 'points'], [frame.atoms, 'points']])
      for (const { name, colour } of list ?? []) all.set(name, [name, colour, swatch]);
  return [...all.values()];
}

function legend(view) {
  const buttons = layers(view.data).map(([name, colour, shape]) => {
    const button = toggle(name, true, (on) => {
      on ? view.hidden.delete(name) : view.hidden.add(name);
      show(view);
    });
    const swatch = element('span', { className: `swatch ${shape}` });
    swatch.style.color = colour;
    button.prepend(swatch);
    return button;
  });
  return element('div', { className: 'legend', role: 'group', 'aria-label': 'What is shown' }, ...buttons);
}

function frameChoice(view) {
  const choice = element('select', { 'aria-label': 'Frame' },
    ...view.data.frames.map((frame, k) => element('option', { value: k }, frame.label)));
  choice.value = view.frame;
  choice.addEventListener('change', () => {
    view.frame = Number(choice.value);
    fill(view);
  });
  return choice;
}

function tools(view) {
  const parts = [element('span', { className: 'title' }, view.data.title),
                 push('+', 'Nearer', () => view.stage.zoom(0.8)),
                 push('\u2212', 'Farther', () => view.stage.zoom(1.25)),
                 push('Reset', 'Reset the view', () => (view.stage.aim(), view.stage.repaint()))];
  if (view.data.frames.length > 1) parts.splice(1, 0, frameChoice(view));
  return element('div', { className: 'tools', role: 'group', 'aria-label': 'View' }, ...parts);
}

const turns = { ArrowLeft: [-0.15, 0], ArrowRight: [0.15, 0], ArrowUp: [0, -0.15], ArrowDown: [0, 0.15] };

function gestures(view) {
  const { place, stage } = view;
  place.addEventListener('keydown', (event) => {
    if (turns[event.key]) stage.turn(...turns[event.key]);
    else if (event.key === '+') stage.zoom(0.8);
    else if (event.key === '-') stage.zoom(1.25);
    else return;
    event.preventDefault();
  });
  place.addEventListener('wheel', (event) => {
    if (!event.shiftKey && !event.ctrlKey) return;
    event.preventDefault();
    stage.zoom(event.deltaY + event.deltaX > 0 ? 1.1 : 0.9);
  }, { passive: false });
  place.addEventListener('pointermove', (event) => {
    const { left, top } = place.getBoundingClientRect();
    const [x, y] = [event.clientX - left, event.clientY - top];
    const text = event.buttons ? null : stage.under(x, y)?.userData.text;
    view.box.hidden = !text;
    view.box.textContent = text ?? '';
    const side = x > place.clientWidth / 2 ? x - 14 - view.box.offsetWidth : x + 14;
    view.box.style.transform = `translate(${side}px, ${Math.max(y - 30, 2)}px)`;
  });
  place.addEventListener('pointerleave', () => (view.box.hidden = true));
}

/** The live part of a figure with its data in the block scene-NAME. */
export function sceneView(figure) {
  const data = json(`scene-${figure.dataset.scene}`);
  if (!data?.frames?.length) return null;
  const place = element('div', { className: 'chart stage', tabIndex: 0, role: 'group',
    'aria-roledescription': '3-D view',
    'aria-label': `${data.title}. ${data.alt} Arrow keys turn it, plus and minus zoom.` });
  const brush = painter();
  if (!brush) return null;
  const live = element('div', { className: 'live' }, place);
  figure.prepend(live);
  const stage = new Stage(place, brush);
  const box = element('div', { className: 'values', hidden: true });
  place.append(box);
  const view = { data, place, stage, box, frame: data.shown ?? 0, hidden: new Set() };
  live.prepend(tools(view));
  live.append(legend(view));
  gestures(view);
  fill(view);
  stage.aim();
  const end = onTheme(() => stage.repaint());
  return { release() {
    end();
    stage.release();
    live.remove();
  } };
}
