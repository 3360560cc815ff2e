// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of series and runs.
import { dark } from './theme.js';

// Okabe & Ito's, told apart by every kind of colour vision, as in the static figures; the dark ones
// lighter on a dark page.
const light = ['#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9', '#000000'];
const onDark = ['#4FA8E0', '#F0803C', '#35C497', '#E29BC3', '#F2B63D', '#8CCBF2', '#EDEFF1'];

/** The first seven by hand, the others spread by the golden angle. */
export function colour(index) {
  if (index < light.length) return (dark() ? onDark : light)[index];
  return `hsl(${Math.round(index * 137.508) % 360} 60% ${dark() ? 66 : 40}%)`;
}
