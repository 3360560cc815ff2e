// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "analyses/dislocation_lines.hpp"
#include "analyses/line_tracks.hpp"

namespace mdana {

/// Of a frame: `lines` {family: {segments, length}}, `total_length`, `burgers_residual`, `short_length` of pieces below
/// two spacings, the longest `segments` and the `unresolved` ends. `tracks` of the segments.
nlohmann::ordered_json lines_json(const DislocationLines& lines, const std::vector<std::uint32_t>& tracks, double spacing);

/// Of a run: `nucleated`, `absorbed`, `stored` segments, `slip_systems` and the plastic `distortion` of the bodies.
/// `frames` in all.
nlohmann::ordered_json line_history_json(const LineTracks& tracks, std::size_t frames);

}  // namespace mdana
