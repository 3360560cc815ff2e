// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "fits/named_value.hpp"
#include "readers/dimension.hpp"

namespace mdana {

/// A parameter of a collision law, besides those of Impact.
struct CollisionParameter {
  std::string_view name;     ///< "T_vis"
  std::string_view meaning;  ///< "relaxation time of the bulk"
  Dimension dimension;
  double least = 0;
  bool least_allowed = false;  ///< whether least itself can be used
  double greatest = std::numeric_limits<double>::max();
  /// If it is not given; NaN leaves it to the law (the meaning tells). Nothing: it must be given.
  std::optional<double> fallback = {};
  std::string_view instead =
      {};  ///< of this one and that one, exactly one must be given; the other is NaN
  std::span<const std::string_view> words = {};  ///< if not empty, the value is an index into them
};

/// Two spheres that meet, reduced to one on a rigid plane. All laws have these.
struct Impact {
  double radius = 0;    ///< R*, 1/R* = 1/R1 + 1/R2 [length]
  double mass = 0;      ///< m*, 1/m* = 1/m1 + 1/m2 [mass]
  double modulus = 0;   ///< E*, 1/E* = sum (1 - nu^2)/E [pressure]
  double velocity = 0;  ///< v_imp > 0, relative velocity at delta = 0 [velocity]
};

/// What a law computes a collision from. Made and checked by collision_input().
struct CollisionInput {
  Impact impact;
  std::vector<double> values;  ///< of the law's parameters, in their order
};

struct CollisionSettings {
  double tolerance = 1e-8;  ///< wanted error of e
  double time_limit = 2;    ///< [s]; beyond it the outcome is unresolved
  bool trajectory = false;
  /// Where the trajectory is wanted, rising from 0 on: it then has one point for each of them until the
  /// contact or the computation ends, and that end. Empty: as the steps fall.
  std::vector<double> times = {};
  bool sensitivities = false;
};

enum class CollisionOutcome { bounce, stick, unresolved };
std::string_view name(CollisionOutcome outcome);

struct CollisionPoint {
  double time = 0;            ///< since delta = 0 [time]
  double delta = 0;           ///< R1 + R2 - X [length]
  double velocity = 0;        ///< d delta/dt [velocity]
  double contact_radius = 0;  ///< [length]
  double force = 0;           ///< -m* dv/dt, repulsive > 0, with all dissipation [force]
};

/// Derivatives by the parameters, each by the value itself: columns R*, m*, E*, v, then the law's.
/// The event that ends a phase (turning point, branch, detachment) moves with the parameters.
struct CollisionSensitivities {
  Eigen::VectorXd e_squared, delta_max, t_max;
};

/// A collision as a law predicts it. Numbers that the law does not give, or that are not known
/// since the outcome is unresolved, are NaN.
struct Collision {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  CollisionOutcome outcome = CollisionOutcome::unresolved;
  std::string reason;        ///< why unresolved or stick; empty for a bounce
  double e = unknown;        ///< 0 if the spheres stick
  double e_error = unknown;  ///< estimated bound of the numerical error
  /// e^2, continued below zero where the spheres stick: the energy that is missing at pull-off,
  /// over m* v^2/2.
  double e_squared = unknown;
  double e_squared_error = unknown;
  double delta_max = unknown;     ///< [length]
  double t_max = unknown;         ///< time of delta_max since delta = 0 [time]
  double contact_time = unknown;  ///< until detachment; NaN if the spheres stick [time]
  double a_max = unknown;         ///< greatest contact radius [length]
  double p_c_max = unknown;       ///< greatest pressure at the centre of contact [pressure]
  /// |E + dissipated - E_0|, greatest of all steps, over m* v^2/2 or, if more, F_c delta_0; 0 where
  /// a closed form has no such check.
  double energy_residual = unknown;
  long evaluations = 0;  ///< of the equations' right-hand side; 0 for a closed form
  double seconds = 0;
  std::vector<CollisionPoint> trajectory;               ///< if wanted
  std::optional<CollisionSensitivities> sensitivities;  ///< if wanted and the law has them

  /// Digits of e that its estimated error leaves, 0 to 16.
  double digits() const;
};

/// A law of collisions. Members of MDANA_COLLISION_LAWS in CMakeLists.txt; each defines
/// `extern const CollisionLaw <name>_collision`.
struct CollisionLaw {
  std::string_view name;  ///< "viscous-hertz"
  std::string_view summary;
  std::span<const CollisionParameter> parameters;
  Collision (*collide)(const CollisionInput& input, const CollisionSettings& settings);
};

/// All collision laws of this build.
std::span<const CollisionLaw* const> collision_laws();

/// The law of that name; null if this build has none.
const CollisionLaw* find_collision_law(std::string_view name);

/// Index of a law's parameter; nothing if it has none of that name.
std::optional<std::size_t> parameter_index(const CollisionLaw& law, std::string_view name);

/// What all laws have, under the names that users give: R or R1 R2, m or m1 m2 or rho, E, v. R2 and
/// m2 are infinite for a wall.
std::span<const CollisionParameter> impact_parameters();

/// Reads and checks the parameters of a law. Throws InputError naming the parameter that is
/// unknown, given twice, missing, not a number or out of its range.
CollisionInput collision_input(const CollisionLaw& law, std::span<const NamedValue> given);

/// The law's collision, with the seconds that it took. Throws InputError naming a value that is out
/// of its range.
Collision collide(const CollisionLaw& law, const CollisionInput& input,
                  const CollisionSettings& settings = {});

}  // namespace mdana
