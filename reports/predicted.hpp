// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "analyses/table.hpp"
#include "fits/collision_law.hpp"
#include "fits/collision_limits.hpp"
#include "reports/document.hpp"

namespace mdana {

/// outcome, e, e_error, ... of a collision, as numbers; what is not known is null.
nlohmann::ordered_json to_json(const Collision& collision);

/// The same as lines for a terminal.
void add_lines(Document& document, const Collision& collision);

/// One row a collision: v, outcome and the numbers.
Table collision_table(std::span<const double> velocities, std::span<const Collision> collisions);

/// t, delta, v, a, F.
Table trajectory_table(const Collision& collision);

/// {"value", "error", ...} of a velocity that was looked for; null, and what is left out, without
/// one.
void add_velocity(Document& document, const std::string& name, const VelocityFound& found);

}  // namespace mdana
