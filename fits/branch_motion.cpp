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
    if (!(to > from)) return 0;
    return boost::math::quadrature::gauss<double, 15>::integrate(
        [&](double s) { return 2 * range / speed_over_s(s); }, from, to);
  }

  CollisionPoint point(double t, double s, double direction) const {
    const double d = delta(s);
    return {t, d, direction * s * speed_over_s(s), branch.contact_radius(d, contact),
            branch.force(d, contact)};
  }
};

/// The times from rest of some s, 0 to just inside the end of contact.
class Timetable {
 public:
  explicit Timetable(const Way& way) : way_(way), s_{0}, t_{0} {
    for (int k = 1; k <= intervals; ++k) {
      s_.push_back(static_cast<double>(k) / intervals * (1 - 1e-12));
      t_.push_back(t_.back() + way.time(s_[s_.size() - 2], s_.back()));
    }
  }

  double length() const { return t_.back(); }

  std::vector<CollisionPoint> all(double direction) const {
    std::vector<CollisionPoint> points;
    for (std::size_t k = 0; k < s_.size(); ++k) points.push_back(way_.point(t_[k], s_[k], direction));
    return points;
  }

  /// At a time between 0 and length(): Newton's method within an interval, dt/ds = 2 range s/|v|.
  CollisionPoint at(double t, double direction) const {
    const auto after = std::ranges::lower_bound(t_, t);
    const auto k = static_cast<std::size_t>(std::clamp<long>(after - t_.begin(), 1, intervals));
    double s = s_[k - 1] + (s_[k] - s_[k - 1]) * (t - t_[k - 1]) / (t_[k] - t_[k - 1]);
    for (int i = 0; i < 4; ++i) {
      const double late = t_[k - 1] + way_.time(s_[k - 1], s) - t;
      s = std::clamp(s - late * way_.speed_over_s(s) / (2 * way_.range), s_[k - 1], s_[k]);
    }
    return way_.point(t, s, direction);
  }

 private:
  static constexpr int intervals = 100;
  const Way way_;
  std::vector<double> s_, t_;
};

}  // namespace

std::vector<CollisionPoint> branch_motion(const ForceBranch& in, const ForceBranch& out,
                                          const ElasticContact& contact, double mass,
                                          std::span<const double> times) {
  const double turn = contact.delta_max;
  const Timetable there({in, contact, mass, turn});
  const Timetable back({out, contact, mass, turn - out.least_delta(contact)});
  const double t_max = there.length(), t_end = t_max + back.length();
  std::vector<CollisionPoint> path;
  const auto add = [&](CollisionPoint p, double time) {
    path.push_back(p);
    path.back().time = time;
  };
  if (!times.empty()) {
    for (const double t : times)
      if (t <= t_end) add(t < t_max ? there.at(t_max - t, 1) : back.at(t - t_max, -1), t);
    add(back.at(t_end - t_max, -1), t_end);
    return path;
  }
  const auto in_points = there.all(1), out_points = back.all(-1);
  for (auto p = in_points.rbegin(); p != in_points.rend(); ++p) add(*p, t_max - p->time);
  for (std::size_t k = 1; k < out_points.size(); ++k) add(out_points[k], t_max + out_points[k].time);
  return path;
}

}  // namespace mdana
