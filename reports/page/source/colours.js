// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of series and runs, and of dislocations and faults as the field paints them.
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

export const lineColours = {
  perfect: '#2F6BFF', shockley: '#1FA33A', stair_rod: '#E01FC0', hirth: '#E3C400', frank: '#00B8C8',
  other: '#E02020',
};
export const planeColours = { intrinsic: '#E8862E', extrinsic: '#8A63D2', twin: '#3C8FD9' };
export const atomColours = {
  fcc: '#6FBF73', hcp: '#E0574F', bcc: '#5B7FE0', ico: '#E0C341', bulk_defect: '#C9A227',
  surface: '#9AA5AF', contact: '#5F6B76', other: '#8C97A1',
};
