// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mdana {

/// An extreme or stiff collision of which something is known by analysis.
struct LawCase {
  std::string_view law;
  std::string what;  ///< "e^2 without dissipation, R = 1e9"
  double computed = 0;
  double exact = 0;
  double needed = 0;  ///< digits that must be kept
  double digits = 0;  ///< that are; 0 if the outcome is unresolved, unless that is right
  bool unresolved = false;
  long evaluations = 0;
  double seconds = 0;

  bool kept() const { return digits >= needed; }
};

/// All cases of the laws of this build, computed.
std::vector<LawCase> law_catalogue();

}  // namespace mdana
