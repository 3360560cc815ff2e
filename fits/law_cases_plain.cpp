// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "fits/law_cases.hpp"

namespace mdana {
namespace {

void add_hertz(Catalogue& c) {
  const CaseParameters& p = base_cases().at("hertz");
  const double depth = c.run("hertz", p).delta_max;
  for (const double x : {1e-12, 1e-6, 1e3}) {
    const Collision h = c.run("hertz", with(p, {{"v", x * p.at("v")}}));
    c.add("hertz", fmt::format("delta_max at v x {:g}", x), h.delta_max, depth * std::pow(x, 0.8),
          13);
    c.add("hertz", fmt::format("contact time at v x {:g}", x), h.contact_time,
          2 * 1.471637592 * h.delta_max / (x * p.at("v")), 9);
  }
}

/// lam of P1 eq. 12 depends on T v^(1/5) only; little damping costs 4 lam d_max^1.5 0.4 B(3/5,
/// 3/2).
void add_viscous_hertz(Catalogue& c) {
  const CaseParameters& p = base_cases().at("viscous-hertz");
  for (const double t : {1e-30, 1e-6, 0.01, 1.0, 100.0}) {
    const double e2 = c.run("viscous-hertz", with(p, {{"T_vis", t}})).e_squared;
    c.add("viscous-hertz", fmt::format("e^2 by T v^0.2, T = {:g}", t),
          c.run("viscous-hertz", with(p, {{"T_vis", t / 2}, {"v", 32 * p.at("v")}})).e_squared, e2,
          7);
  }
  const CaseParameters one{{"R", 2}, {"m", 2}, {"E", 1}, {"v", 1}, {"nu", 0.5}};
  for (const double t : {1e-3, 1e-5, 1e-7}) {
    const double loss = 4 * 8 * t * std::pow(15.0 / 16.0, 0.6) * 0.4 * std::beta(0.6, 1.5);
    c.add("viscous-hertz", fmt::format("loss of little damping, T = {:g}", t),
          1 - c.run("viscous-hertz", with(one, {{"T_vis", t}}), 1e-12).e_squared, loss,
          t > 1e-4 ? 1 : 3);
  }
  c.add("viscous-hertz", "e without damping", c.run("viscous-hertz", with(one, {{"T_vis", 0}})).e,
        1, 16);
}

/// F_dis = D v^2 a^3 without adhesion: e^2 = 1/(1 + 3 D_s/4), D_s = D E v^2 a^3/force; D_s as v^2,
/// so that the rebound speed saturates.
void add_power(Catalogue& c) {
  const CaseParameters one{{"R", 2},     {"m", 2},     {"E", 1},   {"v", 1},
                           {"gamma", 0}, {"alpha", 2}, {"beta", 3}};
  for (const double d : {1e-12, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9})
    c.add("power", fmt::format("e^2 = 1/(1 + 3D/4), D = {:g}", d),
          c.run("power", with(one, {{"D", d}}), 1e-11).e_squared, 1 / (1 + 0.75 * d),
          d > 1e7   ? 2
          : d > 1e4 ? 5
                    : 9);
  for (const double v : {1e-6, 10.0, 1e3})
    c.add("power", fmt::format("rebound speed saturates, v = {:g}", v),
          v * c.run("power", with(one, {{"D", 1}, {"v", v}}), 1e-11).e,
          v / std::sqrt(1 + 0.75 * v * v), v > 100 ? 5 : 9);
  const CaseParameters& p = base_cases().at("power");
  for (const double v : {1e-3, 1e-12})
    c.add_stick("power", fmt::format("sticks at v = {:g}", v), c.run("power", with(p, {{"v", v}})));
  for (const double d : {1e12, 1e30})
    c.add_stick("power", fmt::format("sticks with D = {:g}", d),
                c.run("power", with(p, {{"D", d}})));
}

/// e = 1 with DMT's attraction; the closed forms of the plastic laws by x = v/v_Y (P1 eq. 13; for
/// andrews e^2 = (sqrt(30x^2 - 5) - 2)/(3x^2), v_Y by the work up to delta_Y = (pi Y/(2 E*))^2 R*).
void add_plastic(Catalogue& c) {
  for (const double v : {1e-12, 1e-3, 0.1, 1e3}) {
    c.add("dmt", fmt::format("e at v = {:g}", v),
          c.run("dmt", with(base_cases().at("dmt"), {{"v", v}})).e, 1, 16);
    c.add(
        "thornton", fmt::format("e^2 below the yield velocity, v = {:g}", v),
        c.run("thornton", with(base_cases().at("thornton"), {{"v", v}, {"v_Y", 2 * v}})).e_squared,
        1, 15);
  }
  const CaseParameters& p = base_cases().at("andrews");
  const double r = p.at("R") / 2, m = p.at("m") / 2, e = p.at("E"), y = p.at("Y") / e;
  const double depth = std::pow(std::numbers::pi * y / 2, 2);  // delta_Y/R*
  const double v_y = std::sqrt(16.0 / 15.0 * e * r * r * r * std::pow(depth, 2.5) / m);
  for (const double x : {1.001, 2.0, 30.0, 1e6}) {
    const double tn = 6 * std::sqrt(3.0) / 5 * (1 - 1 / (6 * x * x)) /
                      std::sqrt(1 + 2 * std::sqrt(1.2 * x * x - 0.2));
    c.add("thornton", fmt::format("e^2 at v = {:g} v_Y", x),
          c.run("thornton", with(base_cases().at("thornton"), {{"v", 0.0625 * x}})).e_squared, tn,
          12);
    c.add("andrews", fmt::format("e^2 at v = {:g} v_Y", x),
          c.run("andrews", with(p, {{"v", x * v_y}})).e_squared,
          (std::sqrt(30 * x * x - 5) - 2) / (3 * x * x), 12);
  }
  for (const double x : {1e-6, 0.5, 0.999})
    c.add("andrews", fmt::format("e at v = {:g} v_Y", x),
          c.run("andrews", with(p, {{"v", x * v_y}})).e, 1, 16);
}

}  // namespace

void add_plain_cases(Catalogue& c) {
  add_hertz(c);
  add_viscous_hertz(c);
  add_power(c);
  add_plastic(c);
}

}  // namespace mdana
