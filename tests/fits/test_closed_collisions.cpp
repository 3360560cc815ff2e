// SPDX-License-Identifier: GPL-3.0-or-later
// Collisions in closed form: against the motion under the force laws, the papers' limits, numerical
// derivatives.
#include <bit>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fits/collision_law.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

using std::numbers::pi;

const Impact lj{73.5, 14434147.0 / 2, 65.5, 0.1};            // P1, R = 147
const Impact aggregate{1e-6, 3.35e-15, 1e6, 5};              // SI
const std::vector<double> speeds{1e-6, 0.3, 0.9, 1, 1.0 + 1e-12, 1.001, 1.3, 3, 30, 1e4};

const CollisionLaw& law(const char* name) { return *find_collision_law(name); }

double yield_velocity(const Impact& i, double p) {
  return std::pow(pi / 2 / i.modulus, 2) *
         std::sqrt(8 * pi * std::pow(i.radius, 3) / (15 * i.mass)) * std::pow(p, 2.5);
}

/// The collision at x = v/v_Y, andrews' Y 0.1 E*.
Collision andrews_at(Impact i, double x, const CollisionSettings& settings = {}) {
  const double Y = 0.1 * i.modulus;
  i.velocity = x * yield_velocity(i, Y);
  return collide(law("andrews"), {i, {Y}}, settings);
}

Collision thornton_at(Impact i, double x, const CollisionSettings& settings = {}) {
  i.velocity = x * 0.17;
  return collide(law("thornton"), {i, {0, Collision::unknown, 0.17}}, settings);
}

CollisionSettings with_trajectory() {
  CollisionSettings settings;
  settings.trajectory = true;
  return settings;
}

/// The numbers of the closed form against a motion by quadrature of the force law's energy: 1e-9 from
/// the energies' cancellation near rest.
void expect_motion(const Collision& c, double velocity) {
  ASSERT_EQ(c.outcome, CollisionOutcome::bounce) << c.reason;
  ASSERT_GT(c.trajectory.size(), 100u);
  const CollisionPoint &first = c.trajectory.front(), &last = c.trajectory.back();
  EXPECT_NEAR(first.velocity / velocity, 1, 1e-9);
  EXPECT_NEAR(-last.velocity / velocity / c.e, 1, 1e-9);
  EXPECT_NEAR(last.time / c.contact_time, 1, 1e-8);
  double turn = 0;
  for (std::size_t k = 1; k < c.trajectory.size(); ++k) {
    EXPECT_GE(c.trajectory[k].time, c.trajectory[k - 1].time);
    EXPECT_LE(c.trajectory[k].delta, c.delta_max * (1 + 1e-14));
    EXPECT_LE(c.trajectory[k].contact_radius, c.a_max * (1 + 1e-14));
    if (c.trajectory[k].velocity == 0) turn = c.trajectory[k].time;
  }
  EXPECT_NEAR(turn / c.t_max, 1, 1e-8);
}

TEST(ClosedCollisions, AreTheMotionsUnderTheirForces) {
  for (const Impact& i : {lj, aggregate})
    for (const double x : speeds) {
      SCOPED_TRACE(x);
      expect_motion(andrews_at(i, x, with_trajectory()), x * yield_velocity(i, 0.1 * i.modulus));
      expect_motion(thornton_at(i, x, with_trajectory()), x * 0.17);
    }
  for (const double gamma : {0.0, 0.01, 3.17, 100.0}) {
    SCOPED_TRACE(gamma);
    expect_motion(collide(law("dmt"), {lj, {gamma}}, with_trajectory()), lj.velocity);
  }
}

// Physics sheet, sections 3 and 6.
TEST(ClosedCollisions, RestitutionOfThePapers) {
  for (const double x : speeds) {
    const double andrews = x > 1 ? (std::sqrt(30 * x * x - 5) - 2) / (3 * x * x) : 1;
    EXPECT_NEAR(andrews_at(aggregate, x).e_squared / andrews, 1, 1e-12) << x;
    const double thornton =
        x > 1 ? std::sqrt(6 * std::sqrt(3.0) / 5) * std::sqrt(1 - 1 / (6 * x * x)) *
                    std::pow(1 + 2 * std::sqrt(6 * x * x / 5 - 0.2), -0.25)
              : 1;
    EXPECT_NEAR(thornton_at(lj, x).e / thornton, 1, 1e-12) << x;
  }
  EXPECT_NEAR(andrews_at(lj, 1e10).e * 1e5, std::pow(10.0 / 3.0, 0.25), 1e-9);
  EXPECT_NEAR(thornton_at(lj, 1e12).e * 1e3, 1.18499, 1e-5);
  EXPECT_EQ(andrews_at(lj, 0.5).e, 1);
  EXPECT_EQ(thornton_at(lj, 0.5).e, 1);
}

// P2 eqs 30-33, rho from m* = 16 pi/3 rho R*^3. Beyond x = 1e12, yield is at nothing.
TEST(Andrews, ElasticAndRigidPlasticLimits) {
  const Impact& i = aggregate;
  const double rho = i.mass / (16 * pi / 3 * std::pow(i.radius, 3));
  const Collision elastic = collide(law("andrews"), {i, {10 * i.modulus}});
  const double d = std::pow(5 * pi * rho * i.velocity * i.velocity / i.modulus, 0.4) * i.radius;
  EXPECT_NEAR(elastic.delta_max / d, 1, 1e-13);
  EXPECT_NEAR(elastic.t_max / (1.471637592 * d / i.velocity), 1, 1e-9);
  const double Y = 1e-6 * i.modulus;
  const Collision plastic = collide(law("andrews"), {i, {Y}});
  const double rest = 2 * yield_velocity(i, Y) / i.velocity;
  EXPECT_LT(rest, 1e-10);
  EXPECT_NEAR(plastic.delta_max / (4 * i.velocity * std::sqrt(rho / (3 * Y)) * i.radius), 1, rest + 1e-13);
  EXPECT_NEAR(plastic.t_max / (2 * pi * i.radius * std::sqrt(rho / (3 * Y))), 1, rest + 1e-13);
}

// By Y and by v_Y the same collision: p_y = 1.6 Y.
TEST(Thornton, YieldVelocityAndYieldStrengthAgree) {
  const double Y = 0.15 * lj.modulus, v = yield_velocity(lj, 1.6 * Y);
  EXPECT_NEAR(v, 0.17, 0.005);  // P1 IV A 3
  Impact i = lj;
  for (const double x : {0.5, 1.5, 10.0}) {
    i.velocity = x * v;
    const Collision by_strength = collide(law("thornton"), {i, {0, Y, Collision::unknown}});
    const Collision by_velocity = collide(law("thornton"), {i, {0, Collision::unknown, v}});
    EXPECT_NEAR(by_strength.e / by_velocity.e, 1, 1e-13);
    EXPECT_NEAR(by_strength.delta_max / by_velocity.delta_max, 1, 1e-13);
    EXPECT_NEAR(by_strength.t_max / by_velocity.t_max, 1, 1e-13);
    EXPECT_NEAR(by_strength.contact_time / by_velocity.contact_time, 1, 1e-13);
  }
}

/// e_JKR^2 of P1: 1 - 2 * 0.7722405 F_c delta0/(m* v^2).
double jkr_e_squared(const Impact& i, double gamma) {
  const double a0 = std::cbrt(9 * pi * gamma * i.radius * i.radius / i.modulus);
  const double loss = 0.7722405 * (3 * pi * gamma * i.radius) * (a0 * a0 / (3 * i.radius));
  return 1 - 2 * loss / (i.mass * i.velocity * i.velocity);
}

// Eq. 14; 0.7722405 has seven digits.
TEST(Thornton, WithAdhesionLossesAreAdded) {
  for (const double v : {0.005, 0.02, 0.1, 0.3, 5.0}) {
    Impact i = lj;
    i.velocity = v;
    const double plain = thornton_at(lj, v / 0.17).e_squared;
    const double expected = jkr_e_squared(i, 3.17) - (1 - plain);
    const Collision c = collide(law("thornton"), {i, {3.17, Collision::unknown, 0.17}});
    EXPECT_NEAR(c.e_squared, expected, 1e-7 * (1 - jkr_e_squared(i, 3.17)) + 1e-14) << v;
    EXPECT_EQ(c.outcome, expected > 0 ? CollisionOutcome::bounce : CollisionOutcome::stick) << v;
    EXPECT_NEAR(c.e, std::sqrt(std::max(expected, 0.0)), 1e-6) << v;
    EXPECT_TRUE(std::isnan(c.delta_max));
    EXPECT_EQ(c.reason.empty(), expected > 0);
  }
}

// delta_max by the energy.
TEST(Dmt, TurnsWhereTheEnergyIsStored) {
  for (const double v : {1e-9, 1e-3, 0.1, 10.0})
    for (const double gamma : {1e-12, 3.17, 1e3}) {
      Impact i = lj;
      i.velocity = v;
      const Collision c = collide(law("dmt"), {i, {gamma}});
      const double repulsion = 8.0 / 15 * i.modulus * c.a_max * c.delta_max * c.delta_max,
                   attraction = 4 * pi * gamma * i.radius * c.delta_max;
      EXPECT_EQ(c.e, 1);
      EXPECT_NEAR(repulsion - attraction, i.mass * v * v / 2, 1e-14 * (repulsion + attraction))
          << v << " " << gamma;
    }
}

/// Calls use(law, input) for ordinary collisions of every law of this file.
template <class Use>
void for_inputs(Use&& use) {
  for (const double v : {0.05, 0.17, 0.3, 2.0}) {
    Impact i = lj;
    i.velocity = v;
    use(law("dmt"), {i, {3.17}});
    use(law("dmt"), {i, {0}});
    use(law("andrews"), {i, {0.1 * i.modulus}});
    use(law("thornton"), {i, {0, Collision::unknown, 0.13}});
    use(law("thornton"), {i, {0, 0.15 * i.modulus, Collision::unknown}});
    use(law("thornton"), {i, {3.17, 0.15 * i.modulus, Collision::unknown}});
  }
}

/// The parameter of a column of the sensitivities.
double& parameter(CollisionInput& input, Eigen::Index column) {
  double* const impact[] = {&input.impact.radius, &input.impact.mass, &input.impact.modulus,
                            &input.impact.velocity};
  return column < 4 ? *impact[column] : input.values[static_cast<std::size_t>(column - 4)];
}

// Central differences at 1e-5: 1e-10 by truncation and 1e-11 by rounding, of value/parameter.
TEST(ClosedCollisions, SensitivitiesAreDerivatives) {
  CollisionSettings settings;
  settings.sensitivities = true;
  for_inputs([&](const CollisionLaw& l, const CollisionInput& input) {
    const Collision c = collide(l, input, settings);
    ASSERT_TRUE(c.sensitivities) << l.name;
    ASSERT_EQ(c.sensitivities->e_squared.size(), 4 + static_cast<Eigen::Index>(l.parameters.size()));
    for (Eigen::Index k = 0; k < c.sensitivities->e_squared.size(); ++k) {
      CollisionInput less = input, more = input;
      const double value = parameter(less, k);
      if (!(value > 0)) continue;
      const double h = 1e-5 * value;
      parameter(less, k) -= h;
      parameter(more, k) += h;
      const Collision a = collide(l, less), b = collide(l, more);
      const auto expect = [&](double derivative, double low, double high, double scale) {
        if (std::isnan(scale)) {
          EXPECT_TRUE(std::isnan(derivative)) << l.name << " " << k;
          return;
        }
        EXPECT_NEAR(derivative, (high - low) / (2 * h), 1e-8 * std::abs(scale) / value)
            << l.name << " " << k << " v " << input.impact.velocity;
      };
      expect(c.sensitivities->e_squared[k], a.e_squared, b.e_squared, 1);
      expect(c.sensitivities->delta_max[k], a.delta_max, b.delta_max, c.delta_max);
      expect(c.sensitivities->t_max[k], a.t_max, b.t_max, c.t_max);
    }
  });
}

TEST(Dmt, SensitivityToAdhesionFromNothing) {
  CollisionSettings settings;
  settings.sensitivities = true;
  const Collision none = collide(law("dmt"), {lj, {0}}, settings);
  const double gamma = 1e-6;
  const Collision some = collide(law("dmt"), {lj, {gamma}});
  EXPECT_NEAR(none.sensitivities->delta_max[4] * gamma / (some.delta_max - none.delta_max), 1, 1e-5);
  EXPECT_NEAR(none.sensitivities->t_max[4] * gamma / (some.t_max - none.t_max), 1, 1e-5);
}

// Powers of two of mass, length and time change exponents only.
TEST(ClosedCollisions, PowersOfTwoScaleExactly) {
  const double m = 0x1p-20, l = 0x1p-31, t = 0x1p+13;
  const double p = m / (l * t * t), v = l / t;
  for_inputs([&](const CollisionLaw& law, const CollisionInput& in) {
    CollisionInput scaled = in;
    scaled.impact = {in.impact.radius * l, in.impact.mass * m, in.impact.modulus * p,
                     in.impact.velocity * v};
    for (std::size_t k = 0; k < law.parameters.size(); ++k) {
      const Dimension& d = law.parameters[k].dimension;
      scaled.values[k] *= std::pow(m, d.mass) * std::pow(l, d.length) * std::pow(t, d.time);
    }
    const Collision a = collide(law, in), b = collide(law, scaled);
    const auto same = [&](double x, double y) {
      EXPECT_TRUE(x == y || (std::isnan(x) && std::isnan(y))) << law.name << " " << x << " " << y;
    };
    same(a.e, b.e);
    same(a.delta_max * l, b.delta_max);
    same(a.t_max * t, b.t_max);
    same(a.contact_time * t, b.contact_time);
    same(a.a_max * l, b.a_max);
    same(a.p_c_max * p, b.p_c_max);
  });
}

// Whatever the scale, a result or a reason; never a NaN in e of a resolved collision.
TEST(ClosedCollisions, ExtremesAreResolvedOrRefused) {
  for (const double v : {1e-300, 1e-100, 1e-12, 1.0, 1e12, 1e100, 1e300})
    for (const double E : {1e-30, 1.0, 1e30})
      for (const double strength : {1e-20, 0.1, 1e20})
        for (const double gamma : {0.0, 1e-30, 1.0, 1e30}) {
          const Impact i{1, 1, E, v};
          for (const Collision& c : {collide(law("andrews"), {i, {strength * E}}),
                                     collide(law("thornton"), {i, {gamma, strength * E, Collision::unknown}}),
                                     collide(law("dmt"), {i, {gamma}})}) {
            const bool resolved = c.outcome != CollisionOutcome::unresolved;
            EXPECT_EQ(resolved, std::isfinite(c.e)) << v << " " << E << " " << strength << " " << gamma;
            EXPECT_TRUE(!resolved || (c.e >= 0 && c.e <= 1)) << c.e;
            EXPECT_TRUE(resolved || !c.reason.empty());
          }
        }
  EXPECT_EQ(collide(law("andrews"), {{1, 1, 1, 1e-12}, {0.1}}).outcome, CollisionOutcome::bounce);
}

TEST(ClosedCollisions, ParametersAreNamedInErrors) {
  const std::vector<NamedValue> impact{{"R", "147"}, {"m", "14434147"}, {"E", "65.5"}, {"v", "0.1"}};
  const auto told = [&](const char* name, std::vector<NamedValue> more) {
    std::vector<NamedValue> all = impact;
    all.insert(all.end(), more.begin(), more.end());
    try {
      collision_input(law(name), all);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(told("andrews", {}).find("parameter Y is missing"), std::string::npos);
  EXPECT_NE(told("andrews", {{"Y", "-1"}}).find("Y=-1"), std::string::npos);
  EXPECT_NE(told("dmt", {{"gamma", "nan"}}).find("gamma"), std::string::npos);
  EXPECT_NE(told("thornton", {}).find("v_Y"), std::string::npos);
  EXPECT_NE(told("thornton", {{"Y", "1"}, {"v_Y", "1"}}).find("v_Y"), std::string::npos);
  EXPECT_EQ(told("thornton", {{"v_Y", "0.17"}}), "");
}

}  // namespace
}  // namespace mdana
