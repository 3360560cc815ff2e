// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "analyses/analysis.hpp"

namespace mdana {

/// How far bodies 1 and 2 reach away from each other: the distance along the centre line from the
/// centre of mass to the fourth of the outermost atoms on the far side (three that fly off do not
/// count). A bump there is the antipodal deformation of Yoshida, Kokubo & Tanaka 2024, Sec. IV A 2.
/// Columns: far_side1, far_side2 [length].
std::unique_ptr<Analysis> make_far_side();

}  // namespace mdana
