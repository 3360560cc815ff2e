// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fits/collision_law.hpp"

namespace mdana {

/// A measured number and its standard error; NaN where there is none.
struct Measured {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();

  bool known() const { return value == value; }
};

/// A parameter under the name that collision laws have for it (R, m, E, v, gamma ...).
struct NamedNumber {
  std::string name;
  double value = 0;
};

/// A number of both bodies: equal ones (within 1 %) under the name of both ("R"), others under their own
/// ("R1", "R2"); nothing if one is not known.
void give_both(std::vector<NamedNumber>& given, const std::string& name, double first, double second);

/// A moment of a collision that was followed.
struct MotionSample {
  double time = 0;  ///< [time]
  Measured delta, velocity, force;  ///< R1 + R2 - X, d delta/dt, repulsive > 0
};

/// A collision that was seen, by whatever law. Either it was followed, or at least one of e, delta_max
/// and t_max is known.
struct ObservedCollision {
  std::vector<NamedNumber> given;  ///< what is known of it, v among them
  bool stuck = false;              ///< then e is 0, and its error says how small it would have to be
  Measured e, delta_max, t_max;
  std::vector<MotionSample> motion;  ///< if it was followed; times since delta = 0
  std::string place;               ///< "runs.csv:7", for messages

  /// The number of that name; nothing if it is not given.
  std::optional<double> find(std::string_view name) const;
};

/// What a law computes it from: what is given of it, where the law knows it, over `constants`.
/// Throws InputError with the place if a parameter is missing or out of its range.
CollisionInput input_of(const CollisionLaw& law, const ObservedCollision& seen,
                        std::span<const NamedNumber> constants);

}  // namespace mdana
