// SPDX-License-Identifier: GPL-3.0-or-later
// Bound pairs, and bodies that never touch.
#include <gtest/gtest.h>

#include "tests/analyses/collision.hpp"

namespace mdana {
namespace {

using test::Approach;

constexpr double mass = 2, v = 0.5, omega = 0.5, radii = 10;
constexpr ForceSource sources[] = {ForceSource::forces, ForceSource::velocities,
                                   ForceSource::positions};

/// After touch a spring that also pulls: delta = v/omega exp(-damping t) sin(omega t), for ever.
test::Path bound(double damping) {
  return [=](double t) -> Approach {
    if (t < 0) return {v * t, v, 0};
    const double e = v / omega * std::exp(-damping * t), s = std::sin(omega * t),
                 c = std::cos(omega * t);
    return {e * s, e * (omega * c - damping * s),
            e * ((damping * damping - omega * omega) * s - 2 * damping * omega * c)};
  };
}

/// From delta = -2 on until `periods` after touch.
ForceCurve stuck(ForceSource source, double damping, double periods) {
  const double end = 2 * std::numbers::pi / omega * periods;
  return force_curve(test::head_on(test::even_times(-4, end, 0.05), bound(damping), radii, mass),
                     source, Units::lj, radii);
}

// A maximum each period, at a quarter of it; the last cycle counts when delta has turned back.
TEST(Sticking, CountsTheOscillations) {
  for (const ForceSource source : sources) {
    EXPECT_EQ(stuck(source, 0, 3.0).cycles.size(), 3u) << name(source);
    EXPECT_EQ(stuck(source, 0, 3.2).cycles.size(), 3u) << name(source);
    EXPECT_EQ(stuck(source, 0, 3.5).cycles.size(), 4u) << name(source);
    EXPECT_EQ(stuck(source, 0.01, 5.0).cycles.size(), 5u) << name(source);
    EXPECT_EQ(stuck(source, 0.01, 5.0).outcome, Outcome::stick) << name(source);
  }
}

// The first cycle ends at the first minimum: both bodies at rest, all kinetic energy is gone into
// the loop. Loading starts where delta is as small, in free flight. The corner at touch and the
// open last step cost a few steps of 0.05 in a contact of 12: 1 %.
TEST(Sticking, FirstLoopTakesTheKineticEnergy) {
  const ForceCurve curve = stuck(ForceSource::forces, 0, 3.0);
  const double energy = 0.5 * mass * v * v;
  EXPECT_EQ(curve.outcome, Outcome::stick);
  EXPECT_NEAR(curve.hysteresis_area.value, energy, 0.01 * energy);
  EXPECT_TRUE(test::covers(curve.hysteresis_area, energy, energy))
      << curve.hysteresis_area.value - energy << " stated " << *curve.hysteresis_area.error;
}

TEST(Sticking, PhasesAlternate) {
  const ForceCurve curve = stuck(ForceSource::forces, 0, 2.0);
  const auto times = test::even_times(-4, 2 * std::numbers::pi / omega * 2.0, 0.05);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double phase = omega * times[i] / (2 * std::numbers::pi);  // periods since touch
    if (phase < 0.01 || std::abs(std::sin(4 * std::numbers::pi * (phase - 0.125))) < 0.02) continue;
    const double within = phase - std::floor(phase);
    if (std::abs(within - 0.25) < 0.01 || std::abs(within - 0.75) < 0.01) continue;
    EXPECT_EQ(curve.phase[i], within > 0.25 && within < 0.75 ? Phase::unloading : Phase::loading)
        << phase;
  }
}

/// Motion in a straight line past the other body, with an optional pull.
RelativeMotion pass_by(double impact_parameter, double speed) {
  RelativeMotion motion;
  motion.times = test::even_times(0, 40, 0.5);
  motion.reduced_mass = mass;
  const auto n = static_cast<Eigen::Index>(motion.times.size());
  motion.position.resize(3, n);
  motion.velocity.resize(3, n);
  motion.acceleration = Eigen::Matrix3Xd::Zero(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    motion.steps.push_back(i);
    const double t = motion.times[static_cast<std::size_t>(i)];
    motion.position.col(i) << -20.1 * speed + speed * t, impact_parameter, 0.1;
    motion.velocity.col(i) << speed, 0, 0;
  }
  return motion;
}

TEST(NoContact, StillApproaching) {
  const auto path = test::with_flight(v, 1, v, [](double) { return Approach{}; });
  for (const ForceSource source : sources) {
    const ForceCurve curve =
        force_curve(test::head_on(test::even_times(-30, -5, 0.25), path, radii, mass), source,
                    Units::lj, radii);
    EXPECT_FALSE(curve.contact) << name(source);
    EXPECT_EQ(curve.outcome, Outcome::unresolved);
    EXPECT_TRUE(curve.cycles.empty());
    for (const Phase phase : curve.phase) EXPECT_EQ(phase, Phase::approach);
  }
}

TEST(NoContact, FlyByWithoutForces) {
  const ForceCurve curve = force_curve(pass_by(12, 0.5), ForceSource::forces, Units::lj, radii);
  EXPECT_FALSE(curve.contact);
}

// Rounding of the differences is a force greater than zero, and the speed along the centre line
// changes in any passage.
TEST(NoContact, FlyByWithDifferentiatedForces) {
  for (const double speed : {0.3, 0.5, 0.7}) {
    EXPECT_FALSE(
        force_curve(pass_by(12, speed), ForceSource::velocities, Units::lj, radii).contact);
    EXPECT_FALSE(force_curve(pass_by(12, speed), ForceSource::positions, Units::lj, radii).contact)
        << speed;
  }
}

/// A passage bent by an attraction 0.4/X^2 within X < 17, by velocity Verlet; X stays above 11.
RelativeMotion bent_passage() {
  RelativeMotion motion = pass_by(15, 0.5);
  const auto pull = [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return (x.norm() < 17 ? -0.4 / std::pow(x.norm(), 3) : 0.0) * x;
  };
  Eigen::Vector3d x = motion.position.col(0), u = motion.velocity.col(0);
  for (Eigen::Index i = 0; i < motion.frames(); ++i) {
    motion.position.col(i) = x;
    motion.velocity.col(i) = u;
    motion.acceleration.col(i) = pull(x);
    for (int step = 0; step < 50; ++step) {
      u += 0.005 * pull(x);
      x += 0.01 * u;
      u += 0.005 * pull(x);
    }
  }
  return motion;
}

TEST(NoContact, FlyByWithAttraction) {
  const ForceCurve curve = force_curve(bent_passage(), ForceSource::forces, Units::lj, radii);
  EXPECT_FALSE(curve.contact);
}

TEST(NoContact, FlyByWithDifferentiatedAttraction) {
  for (const ForceSource source : {ForceSource::velocities, ForceSource::positions})
    EXPECT_FALSE(force_curve(bent_passage(), source, Units::lj, radii).contact) << name(source);
}

}  // namespace
}  // namespace mdana
