// SPDX-License-Identifier: GPL-3.0-or-later
// Upgrades the page: each static figure, table and still picture stays where it is and gets its live
// counterpart. Nothing is fetched; the data are in the page's application/json blocks.
import { json } from './blocks.js';
import { chartView } from './chart.js';
import { upgrade } from './lively.js';
import { noteRuns } from './runs.js';
import { addRunsPanel } from './runs_panel.js';
import { sceneView } from './scene.js';
import { makeSortable } from './table.js';
import { addThemeButton } from './theme.js';

noteRuns(json('page-data')?.runs ?? []);
addThemeButton();
addRunsPanel();
for (const table of document.querySelectorAll('main table')) makeSortable(table);
upgrade('figure[data-figure]', chartView, 24);
upgrade('figure[data-scene]', sceneView, 4);  // browsers keep some 8 to 16 WebGL contexts
document.documentElement.dataset.live = '';
