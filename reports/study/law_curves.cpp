// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/law_curves.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "fits/andrews_limits.hpp"

namespace mdana {
namespace {

constexpr int points = 60;

/// From half the least velocity that was seen to half as much again as the greatest.
std::vector<double> velocities_about(std::span<const ObservedCollision> seen) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (const ObservedCollision& s : seen) least = std::min(least, *s.find("v")), greatest = std::max(greatest, *s.find("v"));
  std::vector<double> all;
  for (int i = 0; i <= points; ++i) all.push_back(0.5 * least + (1.5 * greatest - 0.5 * least) * i / points);
  return all;
}

std::vector<NamedNumber> found_in(const ContactFit& fit) {
  std::vector<NamedNumber> found;
  for (const Estimate& p : fit.parameters) found.push_back({p.name, p.value});
  return found;
}

double value_of(const ContactFit& fit, const std::string& name) {
  const auto at = std::ranges::find(fit.parameters, name, &Estimate::name);
  return at == fit.parameters.end() ? std::numeric_limits<double>::quiet_NaN() : at->value;
}

Series dashed(const std::string& label) { return {label, {}, {}, Series::Style::dashed, {}}; }

void add_point(Series& series, double x, double y) {
  series.x.push_back(x);
  series.y.push_back(y);
}

/// The motion of one collision by a law, from its contact on.
std::vector<CollisionPoint> motion_of(const CollisionLaw& law, const ObservedCollision& seen, const ContactFit& fit) {
  CollisionSettings settings;
  settings.trajectory = true;
  return collide(law, input_of(law, seen, found_in(fit)), settings).trajectory;
}

Series drawn(const std::string& label, const std::vector<CollisionPoint>& motion, double CollisionPoint::*x,
             double CollisionPoint::*y, double shift = 0) {
  Series series = dashed(label);
  for (const CollisionPoint& p : motion) add_point(series, p.*x + shift, p.*y);
  return series;
}

/// One of Andrews' law, and of one of its limits, over velocity.
class OverVelocity {
 public:
  explicit OverVelocity(const std::string& label) : delta_(dashed(label)), time_(dashed(label)) {}

  void add(double velocity, double delta_max, double radius, double time) {
    add_point(delta_, velocity, delta_max / radius);
    add_point(time_, velocity, time);
  }

  void take_into(std::vector<LawCurve>& curves) {
    curves.push_back({"delta-max-velocity", "", std::move(delta_)});
    curves.push_back({"t-max-velocity", "", std::move(time_)});
  }

 private:
  Series delta_, time_;
};

void add_velocity_curves(const CompressionStudy& study, std::vector<LawCurve>& curves) {
  const CollisionLaw& law = *find_collision_law("andrews");
  const Compressing& first = study.numbers[study.fitted.front()];
  OverVelocity both("Andrews"), elastic("elastic limit"), plastic("rigid plastic limit");
  ObservedCollision one = study.seen.front();
  Impact impact = first.impact;
  for (const double v : velocities_about(study.seen)) {
    std::ranges::find(one.given, "v", &NamedNumber::name)->value = v;
    const Collision c = collide(law, input_of(law, one, found_in(study.fits->both)));
    both.add(v, c.delta_max, first.effective_radius, c.t_max);
    impact.velocity = v;
    impact.modulus = value_of(study.fits->elastic, "E");
    const Compressed soft = elastic_limit(impact), stiff = rigid_plastic_limit(impact, value_of(study.fits->rigid_plastic, "Y"));
    elastic.add(v, soft.delta_max, first.effective_radius, soft.t_max);
    plastic.add(v, stiff.delta_max, first.effective_radius, stiff.t_max);
  }
  for (OverVelocity* curve : {&both, &elastic, &plastic}) curve->take_into(curves);
}

void add_motion(const CompressionStudy& study, const std::map<std::string, std::string>& groups, std::vector<LawCurve>& curves) {
  const std::size_t run = study.fitted.front();
  const auto group = groups.find(study.runs[run].dump);
  const double contact = study.maximum(run).contact_time;
  if (group == groups.end() || !(contact == contact)) return;
  const auto motion = motion_of(*find_collision_law("andrews"), study.seen.front(), study.fits->both);
  curves.push_back({"approach-speed", group->second,
                    drawn("Andrews", motion, &CollisionPoint::time, &CollisionPoint::velocity, contact)});
}

void add_radius_lines(const CompressionStudy& study, std::vector<LawCurve>& curves) {
  double greatest = 0;
  for (const CompressedRun& run : study.runs) greatest = std::max(greatest, run.radius());
  for (const RadiusLineAt& at : study.lines) {
    Series series = dashed(fmt::format("line at v = {:.3g}", at.velocity));
    for (const double radius : {0.0, 1.1 * greatest}) add_point(series, radius, at.line.slope.value * radius + at.line.intercept.value);
    curves.push_back({"delta-max-size", "", std::move(series)});
  }
}

}  // namespace

std::vector<LawCurve> curves_of(const CollisionLaw& law, const std::string& group, std::span<const ObservedCollision> seen,
                                const ContactFit& fit) {
  Series e = dashed(fmt::format("{}, {}", law.name, group));
  ObservedCollision one = seen.front();
  for (const double v : velocities_about(seen)) {
    std::ranges::find(one.given, "v", &NamedNumber::name)->value = v;
    add_point(e, v, collide(law, input_of(law, one, found_in(fit))).e);
  }
  const auto motion = motion_of(law, seen.front(), fit);
  const std::string label = fmt::format("law {}, v = {:.3g}", law.name, *seen.front().find("v"));
  return {{"restitution", "", std::move(e)},
          {"phase-plane", group, drawn(label, motion, &CollisionPoint::delta, &CollisionPoint::velocity)},
          {"contact-radius", group, drawn(label, motion, &CollisionPoint::delta, &CollisionPoint::contact_radius)},
          {"force", group, drawn(label, motion, &CollisionPoint::delta, &CollisionPoint::force)}};
}

std::vector<LawCurve> curves_of(const CompressionStudy& study, const std::map<std::string, std::string>& groups) {
  std::vector<LawCurve> curves;
  add_radius_lines(study, curves);
  if (!study.fits || !study.fits->both.usable) return curves;
  add_velocity_curves(study, curves);
  add_motion(study, groups, curves);
  return curves;
}

}  // namespace mdana
