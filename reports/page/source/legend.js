// SPDX-License-Identifier: GPL-3.0-or-later
// The legend of a chart: a button for each curve, or for each run if the figure compares runs.
import { element, toggle } from './blocks.js';
import { runsOf, seriesColour } from './option.js';
import { isShown, onRuns, pointsAt, runColour, showRuns } from './runs.js';
import { onTheme } from './theme.js';

const mostRuns = 16;  // beyond it the list of runs at the head of the page is the legend

function entry(text, className, pressed, changed, paint) {
  const swatch = element('span', { className: `swatch ${className}` });
  const button = toggle(text, pressed, changed);
  button.prepend(swatch);
  return { button, paint: () => (swatch.style.color = paint()) };
}

/** Labels with a button: all, but of a figure that compares runs only those of several runs or of none. */
function labelsOf({ series }, many) {
  const labels = [...new Set(series.map((s) => s.label))];
  if (!many) return labels;
  const runs = (label) => new Set(series.filter((s) => s.label === label).map((s) => s.run));
  const some = labels.filter((label) => runs(label).size > 1 || runs(label).has(undefined));
  return some.length < 2 && series.every((s) => s.run) ? [] : some;
}

function labelEntries(view, many) {
  return labelsOf(view.data, many).map((label) => {
    const index = view.data.series.findIndex((s) => s.label === label);
    const changed = (on) => {
      on ? view.state.hiddenLabels.delete(label) : view.state.hiddenLabels.add(label);
      view.draw();
    };
    return entry(label, view.data.series[index].style ?? 'line', !view.state.hiddenLabels.has(label), changed,
                 () => (many && view.data.series[index].run ? 'inherit' : seriesColour(view.data, index)));
  });
}

function runEntries(view, runs) {
  return runs.map((run) => {
    const points = view.data.series.every((s) => s.run !== run || s.style === 'points');
    const made = entry(run, points ? 'points' : 'line', isShown(run), (on) => showRuns([run], on),
                       () => runColour(run));
    pointsAt(made.button, run);
    return { ...made, run };
  });
}

/** The legend and what ends its listening. */
export function legend(view) {
  const runs = runsOf(view.data);
  const many = runs.length > 1;
  const ofRuns = many && runs.length <= mostRuns ? runEntries(view, runs) : [];
  const entries = [...labelEntries(view, many), ...ofRuns];
  const paint = () => entries.forEach((e) => e.paint());
  const press = () => ofRuns.forEach((e) => e.button.setAttribute('aria-pressed', isShown(e.run)));
  paint();
  const ends = [onTheme(paint), onRuns(press)];
  const list = element('div', { className: 'legend', role: 'group', 'aria-label': 'Curves' },
                       ...entries.map((e) => e.button));
  if (runs.length > mostRuns)
    list.append(element('span', { className: 'quiet' }, `${runs.length} runs, coloured as in the list of runs`));
  return { list, release: () => ends.forEach((end) => end()) };
}
