// SPDX-License-Identifier: GPL-3.0-or-later
// Light or dark: as the system says, or as the button says.

const root = document.documentElement;
const system = matchMedia('(prefers-color-scheme: dark)');
const listeners = new Set();

export const dark = () => (root.dataset.theme ?? (system.matches ? 'dark' : 'light')) === 'dark';

/** Calls `listener` at each change; returns what ends that. */
export function onTheme(listener) {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** Value of a custom property of the style sheet. */
export const styled = (name) => getComputedStyle(root).getPropertyValue(name).trim();

export function addThemeButton() {
  const button = document.createElement('button');
  button.type = 'button';
  button.className = 'theme';
  const changed = () => {
    button.textContent = dark() ? 'Light' : 'Dark';
    button.setAttribute('aria-label', dark() ? 'Light colours' : 'Dark colours');
    for (const listener of listeners) listener();
  };
  button.addEventListener('click', () => {
    root.dataset.theme = dark() ? 'light' : 'dark';
    changed();
  });
  system.addEventListener('change', changed);
  document.querySelector('main').prepend(button);
  changed();
}
