// SPDX-License-Identifier: GPL-3.0-or-later
// Figures become live when they come near the window, and the longest unseen one is still again when
// there are many: memory does not grow with the number of runs.

const ahead = '400px';

/** `view(figure)` makes the live part and returns {release()}; null: the figure stays still. */
export function upgrade(selector, view, limit) {
  const live = new Map();  // figure -> its view, longest unseen first
  const release = (figure) => {
    live.get(figure).release();
    live.delete(figure);
    delete figure.dataset.live;
  };
  const shown = (figure) => {
    const made = live.get(figure) ?? view(figure);
    if (!made) return;
    live.delete(figure);
    live.set(figure, made);
    figure.dataset.live = '';
    if (live.size > limit) release(live.keys().next().value);
  };
  const observer = new IntersectionObserver((entries) => {
    for (const entry of entries) if (entry.isIntersecting) shown(entry.target);
  }, { rootMargin: ahead });
  for (const figure of document.querySelectorAll(selector)) observer.observe(figure);
}
