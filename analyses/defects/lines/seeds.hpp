// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analyses/defects/labels.hpp"

namespace mdana::defects {

inline bool at_surface(Site site) { return site == Site::surface || site == Site::contact; }

/// Places in and beside dislocations: bulk defects, atoms in contact, hcp atoms at the rim of their layer, and atoms at the
/// surface that touch one of these.
std::vector<char> line_seeds(const Sites& sites);

}  // namespace mdana::defects
