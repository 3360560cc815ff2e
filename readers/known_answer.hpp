// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mdana {

/// A case whose answer is known in closed form, computed by a member of one of the lists.
struct KnownAnswer {
  std::string what;    ///< "a of a homogeneous disk"
  double computed;
  double exact;
  double digits;       ///< that must agree: -log10 |computed/exact - 1| (of |computed| if exact is 0)
};

/// The known answers of one member: <room>/<name>/<name>.known.cpp defines
/// `std::vector<KnownAnswer> <name>_known()`.
struct KnownMember {
  std::string_view name;
  std::vector<KnownAnswer> (*answers)();
};

/// All members of this build that have known answers, which is every member of the lists.
std::span<const KnownMember> known_members();

/// Correct digits of a computed answer; 16 if it is exact.
double correct_digits(const KnownAnswer& answer);

}  // namespace mdana
