// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace mdana {

/// "T_vis=0.075" taken apart.
struct NamedValue {
  std::string name, text;
};

/// 1/(1/a + 1/b) without overflow; one may be infinite.
double reduced(double a, double b);

}  // namespace mdana
