// SPDX-License-Identifier: GPL-3.0-or-later
// A Hertzian collision, integrated here, measured by the force curve.
#include <gtest/gtest.h>

#include "tests/analyses/collision.hpp"

namespace mdana {
namespace {

constexpr double mass = 1.5, v = 0.1, stiffness = 40, radii = 10;  // F = stiffness delta^1.5

double force(double delta) { return delta > 0 ? stiffness * delta * std::sqrt(delta) : 0; }

/// One step of velocity Verlet, which keeps the energy to 1e-10 at this step.
void step(test::Approach& a, double dt) {
  a.speed += 0.5 * dt * a.acceleration;
  a.delta += dt * a.speed;
  a.acceleration = -force(a.delta) / mass;
  a.speed += 0.5 * dt * a.acceleration;
}

/// Frames every `stride` steps of 1e-4, as a molecular-dynamics run would dump them.
RelativeMotion collision(int stride, int offset) {
  std::vector<double> times;
  std::vector<test::Approach> path;
  test::Approach at{-0.1, v, 0};
  for (int i = 0; at.delta > -0.1001; ++i, step(at, 1e-4))
    if (i % stride == offset) {
      times.push_back(1e-4 * i);
      path.push_back(at);
    }
  std::size_t frame = 0;
  return test::head_on(
      times, [&](double) { return path[frame++]; }, radii, mass);
}

// Energy: m* v^2/2 = 2/5 stiffness delta_max^2.5.
const double delta_max = std::pow(1.25 * mass * v * v / stiffness, 0.4);

TEST(HertzBounce, MaximaAreThoseOfTheEnergyAndTheLoopIsEmpty) {
  for (const ForceSource source :
       {ForceSource::forces, ForceSource::velocities, ForceSource::positions}) {
    const ForceCurve curve = force_curve(collision(400, 0), source, Units::lj, radii);
    EXPECT_EQ(curve.outcome, Outcome::bounce);
    EXPECT_NEAR(curve.delta_max.value / delta_max, 1, 1e-3);
    EXPECT_NEAR(curve.force_max.value / force(delta_max), 1, 2e-3) << name(source);
    EXPECT_NEAR(curve.hysteresis_area.value, 0, 2e-3 * 0.5 * mass * v * v) << name(source);
  }
}

}  // namespace
}  // namespace mdana
