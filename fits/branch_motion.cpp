// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/branch_motion.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/quadrature/gauss.hpp>

namespace mdana {
namespace {

/// One way, from rest at delta_max; delta = delta_max - range s^2, of which v/s and t are smooth.
struct Way {
  const ForceBranch& branch;
  const ElasticContact& contact;
  double mass, range;

  double delta(double s) const { return contact.delta_max - range * s * s; }

  /// |v|/s, v from the energy; near rest from the force there.
  double speed_over_s(double s) const {
    if (s < 1e-4) return std::sqrt(2 * range * (branch.force(contact.delta_max, contact) / mass));
    const double gained = branch.energy(contact.delta_max, contact) - branch.energy(delta(s), contact);
    return std::sqrt(std::max(2 * (gained / mass), 0.0)) / s;
  }

  /// Time between two values of s: int 2 range s ds/|v|.
  double time(double from, double to) const {
    return boost::math::quadrature::gauss<double, 15>::integrate(
        [&](double s) { return 2 * range / speed_over_s(s); }, from, to);
  }

  CollisionPoint point(double t, double s, double direction) const {
    const double d = delta(s);
    return {t, d, direction * s * speed_over_s(s), branch.contact_radius(d, contact),
            branch.force(d, contact)};
  }
};

/// The points from rest on, the last just inside the contact.
std::vector<CollisionPoint> from_rest(const Way& way, int points, double direction) {
  std::vector<CollisionPoint> found{way.point(0, 0, direction)};
  double t = 0, before = 0;
  for (int k = 1; k <= points; ++k) {
    const double s = static_cast<double>(k) / points * (1 - 1e-12);
    t += way.time(before, s);
    found.push_back(way.point(t, s, direction));
    before = s;
  }
  return found;
}

}  // namespace

std::vector<CollisionPoint> branch_motion(const ForceBranch& in, const ForceBranch& out,
                                          const ElasticContact& contact, double mass, int points) {
  const double turn = contact.delta_max;
  auto path = from_rest({in, contact, mass, turn}, points, 1);
  const double t_max = path.back().time;
  for (CollisionPoint& p : path) p.time = t_max - p.time;
  std::reverse(path.begin(), path.end());
  const auto back = from_rest({out, contact, mass, turn - out.least_delta(contact)}, points, -1);
  for (std::size_t k = 1; k < back.size(); ++k) {
    path.push_back(back[k]);
    path.back().time += t_max;
  }
  return path;
}

}  // namespace mdana
