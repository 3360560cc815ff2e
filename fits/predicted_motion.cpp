// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/predicted_motion.hpp"

namespace mdana {
namespace {

CollisionPoint flight(const CollisionPoint& from, double time) {
  return {time, from.delta + from.velocity * (time - from.time), from.velocity, 0, 0};
}

}  // namespace

std::vector<CollisionPoint> predicted_motion(const Collision& collision, double velocity,
                                             std::span<const double> times) {
  constexpr double unknown = Collision::unknown;
  const std::vector<CollisionPoint>& path = collision.trajectory;
  if (path.empty()) return std::vector<CollisionPoint>(times.size(), {unknown, unknown, unknown, unknown, unknown});
  std::vector<CollisionPoint> points;
  std::size_t next = 0;
  for (const double t : times) {
    if (t < 0)
      points.push_back(flight({0, 0, velocity, 0, 0}, t));
    else if (next + 1 < path.size())
      points.push_back(path[next++]);
    else if (collision.outcome == CollisionOutcome::bounce)
      points.push_back(flight(path.back(), t));
    else
      points.push_back(path.back());
  }
  return points;
}

}  // namespace mdana
