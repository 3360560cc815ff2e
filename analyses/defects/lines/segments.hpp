// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analyses/defects/lines/network.hpp"
#include "analyses/dislocation_lines.hpp"

namespace mdana::defects {

/// Family of a Burgers vector in the axes of the cube about it.
LineFamily family_of(const Ideal& burgers);

/// Names, frames, lengths: what is told of the lines. `less_smooth` is the same network smoothed less, for the
/// error of the lengths.
DislocationLines described(const LineNetwork& network, const LineNetwork& less_smooth, const Zone& zone,
                           const ZoneCrystal& crystal);

}  // namespace mdana::defects
