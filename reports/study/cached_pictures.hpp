// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "reports/defect_view.hpp"
#include "reports/snapshots.hpp"

namespace mdana {

/// As a record keeps them: places with six digits.
nlohmann::ordered_json cached(const Snapshot& snapshot);
nlohmann::ordered_json cached(const ViewedFrame& frame);

Snapshot cached_snapshot(const nlohmann::ordered_json& json);
ViewedFrame cached_view(const nlohmann::ordered_json& json);

}  // namespace mdana
