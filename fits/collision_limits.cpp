// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/collision_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mdana {
namespace {

/// Relative width of a bracket at which searching ends.
constexpr double narrow = 1e-12;

Collision at(const CollisionLaw& law, CollisionInput& input, double velocity,
             const CollisionSettings& settings, VelocityFound& found) {
  ++found.collisions;
  input.impact.velocity = velocity;
  return collide(law, input, settings);
}

VelocityFound nothing(VelocityFound found, std::string reason) {
  found.reason = std::move(reason);
  return found;
}

/// Halves the bracket as long as the sign there is known: `sign(v)` is -1 on the side of low, 1 on
/// the side of high, 0 if it cannot be told.
template <class Sign>
void bisect(VelocityFound& found, double low, double high, Sign&& sign) {
  while (high - low > narrow * high) {
    const double middle = low + (high - low) / 2;
    const int s = sign(middle);
    if (s == 0) break;
    (s < 0 ? low : high) = middle;
  }
  found.velocity = low + (high - low) / 2;
  found.error = (high - low) / 2;
}

}  // namespace

std::vector<double> search_velocities(const CollisionLaw& law, const CollisionInput& input) {
  const Impact& i = input.impact;
  const auto k = parameter_index(law, "gamma");
  const double gamma = k ? input.values[*k] : 0;
  // F_c delta_0/m* of JKR (P1 eq. 8), else E* R*^3/m*.
  const double a0 = std::cbrt(9 * std::numbers::pi * gamma * i.radius * (i.radius / i.modulus));
  const double square = gamma > 0 ? std::numbers::pi * gamma * a0 * (a0 / i.mass)
                                  : 1e-6 * i.modulus * i.radius * i.radius * (i.radius / i.mass);
  std::vector<double> velocities;
  for (int step = -4; step <= 48; ++step)
    velocities.push_back(std::sqrt(square) * std::pow(10.0, step / 12.0));
  return velocities;
}

VelocityFound sticking_velocity(const CollisionLaw& law, CollisionInput input,
                                const std::vector<double>& velocities,
                                const CollisionSettings& settings) {
  VelocityFound found;
  CollisionOutcome before = CollisionOutcome::unresolved;
  for (std::size_t k = 0; k < velocities.size(); ++k) {
    const CollisionOutcome here = at(law, input, velocities[k], settings, found).outcome;
    if (k > 0 && before == CollisionOutcome::stick && here == CollisionOutcome::bounce) {
      bisect(found, velocities[k - 1], velocities[k], [&](double v) {
        const CollisionOutcome o = at(law, input, v, settings, found).outcome;
        return o == CollisionOutcome::stick ? -1 : o == CollisionOutcome::bounce ? 1 : 0;
      });
      found.e = 0;
      return found;
    }
    if (k == 0 && here == CollisionOutcome::bounce)
      return nothing(found, "the spheres bounce at the lowest velocity");
    before = here;
  }
  return nothing(found, "the spheres do not begin to bounce between the velocities looked at");
}

VelocityFound peak_velocity(const CollisionLaw& law, CollisionInput input,
                            const std::vector<double>& velocities,
                            const CollisionSettings& settings) {
  VelocityFound found;
  std::size_t best = 0;
  double greatest = -1;
  for (std::size_t k = 0; k < velocities.size(); ++k) {
    const Collision c = at(law, input, velocities[k], settings, found);
    if (c.outcome == CollisionOutcome::bounce && c.e > greatest) greatest = c.e, best = k;
  }
  if (greatest < 0) return nothing(found, "the spheres stick at all velocities looked at");
  if (best == 0 || best + 1 == velocities.size())
    return nothing(found, "e is greatest at an end of the velocities looked at");
  CollisionSettings with = settings;
  with.sensitivities = true;
  if (!at(law, input, velocities[best], with, found).sensitivities)
    return nothing(found, "the law gives no derivative of e");
  bisect(found, velocities[best - 1], velocities[best + 1], [&](double v) {
    const Collision c = at(law, input, v, with, found);
    if (c.outcome != CollisionOutcome::bounce)
      return c.outcome == CollisionOutcome::stick && v < velocities[best] ? -1 : 0;
    const double slope = c.sensitivities->e_squared[3];
    return slope > 0 ? -1 : slope < 0 ? 1 : 0;
  });
  const Collision c = at(law, input, found.velocity, settings, found);
  found.e = c.e;
  found.e_error = c.e_error;
  return found;
}

}  // namespace mdana
