// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "fits/collision_limits.hpp"
#include "fits/law_cases.hpp"

namespace mdana {
namespace {

/// v at which JKR spheres begin to bounce: m* v^2/2 = 0.7722405 F_c delta_0.
double jkr_threshold(const CaseParameters& p) {
  const double pi = std::numbers::pi, r = p.at("R") / 2, m = p.at("m") / 2, gamma = p.at("gamma");
  const double a0 = std::cbrt(9 * pi * gamma * r * r / p.at("E"));
  const double loss = (6 * std::pow(4.0, 4.0 / 3.0) + 4) / 5 * std::pow(6.0, -4.0 / 3.0);
  return std::sqrt(2 * loss * 3 * pi * gamma * r * (a0 * (a0 / (3 * r))) / m);
}

void add_jkr(Catalogue& c) {
  const CaseParameters& p = base_cases().at("jkr");
  const double v0 = jkr_threshold(p);
  for (const double x : {1 + 1e-9, 1 + 1e-6, 1.001, 1.5, 10.0, 1e3, 1e6})
    c.add("jkr", fmt::format("e^2 at {} times the sticking velocity", x),
          c.run("jkr", with(p, {{"v", x * v0}})).e_squared, (1 - 1 / x) * (1 + 1 / x),
          x < 1.01 ? 5 : 13);
  for (const double x : {1 - 1e-9, 0.999, 0.1, 1e-6})
    c.add_stick("jkr", fmt::format("sticks at {} times the sticking velocity", x),
                c.run("jkr", with(p, {{"v", x * v0}})));
  for (double r = 1; r < 2e9; r *= 10) {
    CaseParameters q = with(p, {{"R", r}, {"m", 4.5 * r * r * r}});
    q["v"] = 2 * jkr_threshold(q);
    c.add("jkr", fmt::format("e^2 at twice the sticking velocity, R = {:g}", r),
          c.run("jkr", q).e_squared, 0.75, 13);
  }
  if (const CollisionLaw* law = find_collision_law("jkr")) {
    const CollisionInput input = collision_input(
        *law, std::vector<NamedValue>{
                  {"R", "147"}, {"m", "14434147"}, {"E", "65.5"}, {"gamma", "3.17"}, {"v", "1"}});
    c.add("jkr", "sticking velocity by search",
          sticking_velocity(*law, input, search_velocities(*law, input)).velocity, v0, 11);
  }
}

/// Without dissipation JKR, with much or at low speed sticking.
void add_krijt(Catalogue& c) {
  for (const std::string_view law : {"krijt", "stress"}) {
    const CaseParameters& p = base_cases().at(law);
    const std::string t = law == "krijt" ? "T_vis" : "C";
    const double jkr = c.run("jkr", base_cases().at("jkr")).e_squared;
    c.add(law, "e^2 without dissipation", c.run(law, with(p, {{t, 0}})).e_squared, jkr, 15);
    for (const double x : {1e-2, 1e-4, 1e-6, 1e-8, 1e-12, 1e-20, 1e-100})
      c.add(law, fmt::format("e^2 with {} x {:g}", t, x),
            c.run(law, with(p, {{t, p.at(t) * x}}), 1e-8).e_squared, jkr,
            std::min(6.0, 0.8 - 0.7 * std::log10(x)) - 0.5);
    for (const double x : {1e4, 1e6, 1e12, 1e30, 1e100})
      c.add_stick(law, fmt::format("sticks with {} x {:g}", t, x),
                  c.run(law, with(p, {{t, p.at(t) * x}})));
    for (const double v : {1e-3, 1e-6, 1e-12, 1e-100})
      c.add_stick(law, fmt::format("sticks at v = {:g}", v), c.run(law, with(p, {{"v", v}})));
    c.add(law, "e^2 with a fast crack and slow bulk",
          c.run(law, with(p, {{"T_crack", 1e-9}})).e_squared,
          c.run(law, with(p, {{"T_crack", 0}})).e_squared, 3.5);
  }
  const CaseParameters& p = base_cases().at("krijt");
  const double viscous = c.run("viscous-hertz", base_cases().at("viscous-hertz")).e_squared;
  for (const double gamma : {1e-2, 1e-4, 1e-6, 1e-10})
    c.add("krijt", fmt::format("e^2 with gamma = {:g} is viscous-hertz'", gamma),
          c.run("krijt", with(p, {{"gamma", gamma}}), 1e-8).e_squared, viscous,
          std::min(6.0, 1.4 - 0.5 * std::log10(gamma)));
  c.add("krijt", "e^2 without adhesion", c.run("krijt", with(p, {{"gamma", 0}})).e_squared, viscous,
        16);
  const double curve = c.run("krijt", with(p, {{"T_crack", 0}})).e_squared;
  CaseParameters power =
      with(base_cases().at("power"), {{"D", 2 * 0.075 / 0.0625}, {"alpha", 1}, {"beta", 1}});
  c.add("power", "e^2 of D v a is that of bulk dissipation", c.run("power", power).e_squared, curve,
        9);
}

void add_stress(Catalogue& c) {
  const CaseParameters& p = base_cases().at("stress");
  const double krijt =
      c.run("krijt", with(base_cases().at("krijt"), {{"T_vis", 2.1e-4 * 147}})).e_squared;
  c.add("stress", "e^2 with B = 0 is krijt's", c.run("stress", with(p, {{"B", 0}})).e_squared,
        krijt, 15);
  for (const double b : {1e-9, 1e-3, 0.1})
    c.add("stress", fmt::format("e^2 with B = {:g} is krijt's", b),
          c.run("stress", with(p, {{"B", b}})).e_squared, krijt, b > 0.01 ? 6 : 8);
  c.add("stress", "e^2 with zeta = 50 below its step",
        c.run("stress", with(p, {{"zeta", 50}, {"B", 2}})).e_squared, krijt, 8);
  for (const double b : {20.0, 1e2, 1e4, 1e100})
    c.add_stick("stress", fmt::format("sticks with B = {:g}", b),
                c.run("stress", with(p, {{"B", b}})));
  for (const double v : {10.0, 1e3})
    c.add_stick("stress", fmt::format("sticks or barely parts at v = {:g}", v),
                c.run("stress", with(p, {{"v", v}, {"B", 20}})));
}

/// Ice grains of 0.1 um.
void add_grains(Catalogue& c) {
  CaseParameters p{{"R", 1e-7}, {"rho", 1000}, {"E", 7e9 / (2 * (1 - 0.0625))}, {"gamma", 0.1}};
  const double m = 4.0 / 3.0 * std::numbers::pi * 1000 * 1e-21;
  const double v0 = jkr_threshold(with(p, {{"m", m}}));
  p["v"] = 3 * v0;
  c.add("jkr", "e^2 of ice grains at three times the sticking velocity", c.run("jkr", p).e_squared,
        8.0 / 9.0, 13);
  for (const double t : {1e-18, 1e-20})
    c.add(
        "krijt", fmt::format("e^2 of ice grains, T = {:g} s", t),
        c.run("krijt", with(p, {{"nu", 0.25}, {"T_vis", t}, {"spacing", 2.8e-10}}), 1e-8).e_squared,
        8.0 / 9.0, 2);
  for (const double t : {1e-6, 1.0})
    c.add_stick("krijt", fmt::format("ice grains stick, T = {:g} s", t),
                c.run("krijt", with(p, {{"nu", 0.25}, {"T_vis", t}, {"spacing", 2.8e-10}})));
}

}  // namespace

void add_adhesive_cases(Catalogue& c) {
  add_jkr(c);
  add_krijt(c);
  add_stress(c);
  add_grains(c);
}

}  // namespace mdana
