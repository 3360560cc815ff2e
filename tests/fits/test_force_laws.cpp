// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of the force laws: every member of the list, on loading and on unloading.
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include "readers/input_error.hpp"
#include "tests/fits/contacts.hpp"

namespace mdana {
namespace {

using namespace test;

/// One branch of one law, up to the greatest delta.
struct Case {
  const ForceLaw* law;
  const ForceBranch* branch;
  ElasticContact contact;

  double least() const { return branch->least_delta(contact); }
  double greatest() const { return contact.delta_max; }
  bool loading() const { return branch == static_cast<const ForceBranch*>(law); }
  std::string text() const {
    return std::string(law->name) + (loading() ? " loading" : " unloading") + ", R* " +
           std::to_string(contact.radius) + ", turn " + std::to_string(greatest() / contact.radius);
  }
};

/// All branches of all laws, with turning points below and far beyond yield.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const ForceLaw* law : force_laws())
    for (ElasticContact c : {lj, ice, stiff, weak})
      for (const double turn : {0.02, 3.0, 1e3}) {
        c.delta_max = turn * std::max(jkr_delta(c), yield_delta(c));
        all.push_back({law, law, c});
        if (law->unloading) all.push_back({law, law->unloading, c});
      }
  return all;
}

/// Calls use(delta) from just above the least delta to the greatest, in steps of a third.
template <class Use>
void for_deltas(const Case& k, Use&& use) {
  const double range = k.greatest() - k.least();
  for (double part = 1; part > 1e-5; part *= 0.7312) use(k.least() + part * range);
}

TEST(ForceLaws, AreFoundByName) {
  for (const ForceLaw* law : force_laws()) {
    EXPECT_EQ(find_force_law(law->name), law);
    EXPECT_FALSE(law->summary.empty());
    EXPECT_FALSE(law->parameters.empty());
  }
  EXPECT_EQ(find_force_law("none"), nullptr);
}

void expect_named(const ForceLaw& law, const ContactParameter& p, double wrong) {
  ElasticContact c = lj;
  c.*p.value = wrong;
  try {
    require_parameters(law, c);
    ADD_FAILURE() << law.name << " takes " << p.name << " = " << wrong;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(p.name), std::string::npos) << error.what();
  }
}

TEST(ForceLaws, ParametersOutOfRangeAreNamed) {
  for (const ForceLaw* law : force_laws()) {
    EXPECT_NO_THROW(require_parameters(*law, lj)) << law->name;
    for (const ContactParameter& p : law->parameters) {
      for (const double wrong : {-1.0, std::nan(""), HUGE_VAL}) expect_named(*law, p, wrong);
      if (!p.zero_allowed) expect_named(*law, p, 0);
    }
    ElasticContact plain = lj;
    plain.surface_energy = 0;
    EXPECT_NO_THROW(require_parameters(*law, plain)) << law->name;
  }
}

// Beyond the least delta there is no force and no contact, above it there is.
TEST(ForceLaws, ContactBeginsAtTheLeastDelta) {
  for (const Case& k : cases()) {
    const double least = k.least(), step = 1e-6 * (k.greatest() - least);
    const ForceBranch& b = *k.branch;
    EXPECT_EQ(b.force(least - step, k.contact), 0) << k.text();
    EXPECT_EQ(b.contact_radius(least - step, k.contact), 0) << k.text();
    EXPECT_EQ(b.energy(least - step, k.contact), 0) << k.text();
    EXPECT_EQ(b.stiffness(least - step, k.contact), 0) << k.text();
    EXPECT_EQ(b.pressure(0, least - step, k.contact), 0) << k.text();
    EXPECT_NE(b.force(least + step, k.contact), 0) << k.text();
    EXPECT_GT(b.contact_radius(least + step, k.contact), 0) << k.text();
  }
}

// Not the weak one: its yielding contact pulls harder the wider it is.
TEST(ForceLaws, GrowWithDelta) {
  for (const ForceLaw* law : force_laws())
    for (const ElasticContact& c : {lj, ice, stiff}) {
      double force = law->force(0, c), radius = law->contact_radius(0, c);
      for (double d = 1e-3; d < 1e6; d *= 1.1) {
        const double next = law->force(d * jkr_delta(c), c),
                     a = law->contact_radius(d * jkr_delta(c), c);
        EXPECT_GT(next, force) << law->name << " " << d;
        EXPECT_GT(a, radius) << law->name << " " << d;
        force = next;
        radius = a;
      }
    }
}

// By dimension F = E* L^2 f(delta/L, gamma/(E* L), ...): lengths and pressures times powers of two
// change the exponents and no other bit, of every function of every branch.
TEST(ForceLaws, PowersOfTwoScaleEveryNumberExactly) {
  for (const Case& k : cases())
    for (const double l : {0x1p-31, 0x1p-7, 0x1p+20})
      for (const double p : {0x1p-10, 0x1p+33}) {
        const ElasticContact& c = k.contact;
        const ElasticContact scaled{c.radius * l,         c.modulus * p, c.surface_energy * p * l,
                                    c.yield_strength * p, c.spacing * l, c.delta_max * l};
        const auto same = [&](double value, double unit, double other) {
          EXPECT_EQ(std::bit_cast<std::uint64_t>(value * unit), std::bit_cast<std::uint64_t>(other))
              << k.text();
        };
        const ForceBranch& b = *k.branch;
        same(b.least_delta(c), l, b.least_delta(scaled));
        for_deltas(k, [&](double d) {
          same(b.force(d, c), p * l * l, b.force(d * l, scaled));
          same(b.contact_radius(d, c), l, b.contact_radius(d * l, scaled));
          same(b.pressure_radius(d, c), l, b.pressure_radius(d * l, scaled));
          same(b.stiffness(d, c), p * l, b.stiffness(d * l, scaled));
          same(b.energy(d, c), p * l * l * l, b.energy(d * l, scaled));
          const double r = 0.3 * b.contact_radius(d, c);
          same(b.pressure(r, d, c), p, b.pressure(r * l, d * l, scaled));
        });
      }
}

/// Slope by five points at steps h: truncation h^4/30 of the fifth derivative.
template <class Function>
double slope(const Function& f, double x, double h) {
  return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h);
}

// Steps of 1e-3 of the way from the least delta, where the functions can have roots: 1e-11 of the
// slope; and the rounding of the values (and of delta) over a step.
template <class Function, class Slope>
void expect_slope(const Case& k, const Function& f, const Slope& derivative) {
  for_deltas(k, [&](double d) {
    const double h = 1e-3 * (d - k.least());
    const double exact = derivative(d), numeric = slope(f, d, h);
    const double rounding = 2e-15 * (std::abs(f(d)) + std::abs(exact * d)) / h;
    EXPECT_NEAR(numeric, exact, 1e-9 * std::abs(exact) + rounding)
        << k.text() << " delta " << d / k.greatest();
  });
}

TEST(ForceLaws, ForceIsTheDerivativeOfTheEnergy) {
  for (const Case& k : cases())
    expect_slope(
        k, [&](double d) { return k.branch->energy(d, k.contact); },
        [&](double d) { return k.branch->force(d, k.contact); });
}

TEST(ForceLaws, StiffnessIsTheDerivativeOfTheForce) {
  for (const Case& k : cases())
    expect_slope(
        k, [&](double d) { return k.branch->force(d, k.contact); },
        [&](double d) { return k.branch->stiffness(d, k.contact); });
}

/// Radius of the core within which the pressure is that of the centre.
double core_radius(const Case& k, double delta, double a) {
  const double centre = k.branch->pressure(0, delta, k.contact);
  double lo = 0, hi = a;
  for (int i = 0; i < 60; ++i) {
    const double r = lo + (hi - lo) / 2;
    (k.branch->pressure(r, delta, k.contact) == centre ? lo : hi) = r;
  }
  return lo;
}

/// int p dA and its uncertainty: 1e-10 of int |p| dA (repulsion and attraction cancel), more for a
/// thin ring, near whose rim r is known to rounding of a only. Of the core, of the rest of the contact in y = sqrt(1 - r^2/a^2) and the
/// like, which lifts the roots at its rim, and of a cohesive zone.
std::pair<double, double> pressure_integral(const Case& k, double delta) {
  const double a = k.branch->contact_radius(delta, k.contact),
               c = k.branch->pressure_radius(delta, k.contact), b = core_radius(k, delta, a);
  const auto integral = [&](const auto& value) {
    using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
    const auto p = [&](double r) { return value(k.branch->pressure(r, delta, k.contact)); };
    const double inner = p(0) * (b / a) * (b / a), ring = (1 - b / a) * (1 + b / a);
    const double rest = 2 * ring * Rule::integrate([&](double y) {
                          return p(a * std::sqrt(1 - ring * y * y)) * y;
                        }, 0.0, 1.0, 2, 1e-11);
    const double zone = p(a + (c - a) / 2) * (c / a - 1) * (c / a + 1);
    return std::numbers::pi * a * a * (inner + rest + (c > a ? zone : 0));
  };
  const double thin = 1 + 0.1 / ((1 - b / a) * (1 + b / a));
  return {integral([](double p) { return p; }),
          1e-10 * thin * integral([](double p) { return std::abs(p); })};
}

TEST(ForceLaws, PressureOverTheContactIsTheForce) {
  for (const Case& k : cases())
    for_deltas(k, [&](double d) {
      const auto [net, uncertainty] = pressure_integral(k, d);
      double force = k.branch->force(d, k.contact);
      const double outside = 4.0 / 3.0 * pull_off_force(k.contact);
      if (k.law->name == "dmt") force += outside;  // its attraction acts outside the contact
      EXPECT_NEAR(net, force, uncertainty + 4e-16 * outside) << k.text() << " at " << d / k.greatest();
      const double rim = k.branch->pressure_radius(d, k.contact);
      EXPECT_EQ(k.branch->pressure(rim * (1 + 1e-12), d, k.contact), 0) << k.text();
      EXPECT_NE(k.branch->pressure(rim * (1 - 1e-12), d, k.contact), 0) << k.text();
    });
}

// Unloading goes on from where loading ends, and gives back no more than was put in. Rounding of
// delta moves the numbers of a dent that is shallow beside delta.
TEST(ForceLaws, UnloadingBeginsWhereLoadingEnds) {
  for (const Case& k : cases()) {
    if (k.loading()) continue;
    const double turn = k.greatest(), a = k.law->contact_radius(turn, k.contact),
                 force = k.law->force(turn, k.contact), depth = turn - k.least();
    const double rounding = 1e-14 * (1 + turn / depth);
    EXPECT_NEAR(k.branch->force(turn, k.contact), force, rounding * std::abs(force)) << k.text();
    EXPECT_NEAR(k.branch->contact_radius(turn, k.contact), a, rounding * a) << k.text();
    if (k.contact.radius == weak.radius) continue;  // see thornton.md, limits
    const double in = k.law->energy(turn, k.contact), back = k.branch->energy(turn, k.contact);
    EXPECT_LE(back, in + rounding * std::abs(in)) << k.text();
    if (turn > 2 * 1.6 * 1.6 * yield_delta(k.contact)) {
      EXPECT_LT(back, 0.95 * in) << k.text();
    }
  }
}

TEST(ForceLaws, ShallowContactsUnloadOnTheWayBack) {
  int seen = 0;
  for (const Case& k : cases()) {
    if (k.loading() || k.law->pressure(0, k.greatest(), k.contact) > 0.9 * k.contact.yield_strength)
      continue;
    ++seen;
    for_deltas(k, [&](double d) {
      EXPECT_DOUBLE_EQ(k.branch->energy(d, k.contact), k.law->energy(d, k.contact)) << k.text();
    });
  }
  EXPECT_GT(seen, 3);
}

/// All numbers of a branch at one delta.
std::vector<double> numbers(const ForceBranch& b, double d, const ElasticContact& c) {
  const double a = b.contact_radius(d, c);
  return {b.force(d, c),     b.least_delta(c),      a, b.energy(d, c),
          b.pressure(0, d, c), b.pressure(0.5 * a, d, c), b.pressure_radius(d, c)};
}

// From 1e-30 to 1e30 of the units, and at the edges of the contact.
TEST(ForceLaws, ExtremeScalesGiveFiniteNumbers) {
  for (const ForceLaw* law : force_laws())
    for (const ForceBranch* branch : {static_cast<const ForceBranch*>(law), &unloading(*law)})
      for (const double l : {1e-30, 1.0, 1e30})
        for (const double p : {1e-30, 1.0, 1e30})
          for (const double gamma : {0.0, 1e-300, 1e-30, 1e-6, 1.0, 1e6})
            for (const double d : {0.0, 1e-300, 1e-30, 1e-9, 0.3, 10.0, -1e-9, -1e30, 1e20}) {
              ElasticContact c{l, p, gamma * p * l, 0.1 * p, 0.01 * l, std::max(d, 0.01) * l};
              for (const double delta : {d * l, branch->least_delta(c)})
                for (const double number : numbers(*branch, delta, c))
                  EXPECT_TRUE(std::isfinite(number))
                      << law->name << " l " << l << " p " << p << " gamma " << gamma << " d " << d;
            }
}

}  // namespace
}  // namespace mdana
