// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "fits/contact_fit.hpp"
#include "fits/fit_coordinates.hpp"

namespace mdana {

/// From the scales of an elastic collision: where a parameter may be looked for. Wide, since it is
/// only where starts are drawn from. That of D is of D v^alpha a^beta.
std::pair<double, double> usual_range(std::string_view name, const CollisionScales& scales);

}  // namespace mdana
