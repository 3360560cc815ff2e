// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "analyses/analysis.hpp"

namespace mdana {

/// Radius of each body as sqrt(5/3) times its radius of gyration, which for a homogeneous sphere is
/// its radius. Columns: radius1 radius2 [length].
std::unique_ptr<Analysis> make_gyration();

}  // namespace mdana
