// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/law_catalogue.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "fits/collision_limits.hpp"
#include "readers/known_answer.hpp"

namespace mdana {
namespace {

using Parameters = std::map<std::string, double>;

/// The sphere of P1 with R = 147 for every law that the catalogue knows.
const std::map<std::string_view, Parameters>& base_cases() {
  static const Parameters sphere{{"R", 147}, {"m", 14434147}, {"E", 65.5}, {"v", 0.125}};
  const auto with = [](Parameters more) {
    more.insert(sphere.begin(), sphere.end());
    return more;
  };
  const Parameters krijt{{"gamma", 3.17}, {"nu", 0.25}, {"T_vis", 0.075}, {"spacing", 1.091}};
  Parameters plastic = krijt;
  plastic["v_Y"] = 0.0625;
  static const std::map<std::string_view, Parameters> cases{
      {"hertz", sphere},
      {"viscous-hertz", with({{"nu", 0.25}, {"T_vis", 0.075}})},
      {"jkr", with({{"gamma", 3.17}})},
      {"dmt", with({{"gamma", 3.17}})},
      {"thornton", with({{"v_Y", 0.0625}})},
      {"andrews", with({{"Y", 5}})},
      {"krijt", with(krijt)},
      {"krijt-plastic", with(plastic)},
      {"stress", with({{"gamma", 3.17},
                       {"nu", 0.25},
                       {"C", 2.1e-4},
                       {"B", 6.2},
                       {"zeta", 4},
                       {"spacing", 1.091}})},
      {"power", with({{"gamma", 3.17}, {"D", 118}, {"alpha", 3}, {"beta", 1.5}})}};
  return cases;
}

/// Collects the cases of one build.
class Catalogue {
 public:
  std::vector<LawCase> cases;

  /// The collision, whose price goes to the next case; nothing known if the build has no such law.
  Collision run(std::string_view law, const Parameters& p, double tolerance = 1e-10) {
    const CollisionLaw* found = find_collision_law(law);
    if (!found) return {};
    std::vector<NamedValue> given;
    for (const auto& [name, value] : p) given.push_back({name, fmt::format("{}", value)});
    const Collision c = collide(*found, collision_input(*found, given), {.tolerance = tolerance});
    evaluations_ += c.evaluations;
    seconds_ += c.seconds;
    unresolved_ = unresolved_ || c.outcome == CollisionOutcome::unresolved;
    return c;
  }

  void add(std::string_view law, std::string what, double computed, double exact, double needed) {
    LawCase c{law, std::move(what), computed,     exact,   needed,
              0,   unresolved_,     evaluations_, seconds_};
    if (std::isfinite(computed))
      c.digits = std::min(16.0, correct_digits({"", computed, exact, 0}));
    if (find_collision_law(law) && !std::isnan(exact)) cases.push_back(std::move(c));
    evaluations_ = 0;
    seconds_ = 0;
    unresolved_ = false;
  }

  /// That the spheres stick; to tell that it is not known counts as right, a wrong e does not.
  void add_stick(std::string_view law, std::string what, const Collision& c) {
    const bool right = c.outcome != CollisionOutcome::bounce;
    add(law, std::move(what), right ? 0 : c.e, 0, 16);
  }

 private:
  long evaluations_ = 0;
  double seconds_ = 0;
  bool unresolved_ = false;
};

Parameters with(Parameters p, std::initializer_list<std::pair<const std::string, double>> changes) {
  for (const auto& [name, value] : changes) p[name] = value;
  return p;
}

double unit_of(const Dimension& d, double mass, double length, double time) {
  return std::pow(mass, d.mass) * std::pow(length, d.length) * std::pow(time, d.time);
}

/// The same collision in other units; power's D by its exponents.
Parameters in_units(const CollisionLaw& law, Parameters p, double mass, double length,
                    double time) {
  const auto convert = [&](std::span<const CollisionParameter> parameters) {
    for (const CollisionParameter& q : parameters)
      if (const auto at = p.find(std::string(q.name)); at != p.end())
        at->second *= unit_of(q.dimension, mass, length, time);
  };
  convert(impact_parameters());
  convert(law.parameters);
  if (p.count("D"))
    p["D"] *= std::pow(length, 2 - p["beta"]) * std::pow(length / time, -p["alpha"]);
  return p;
}

/// e is a number: the units do not matter, powers of two not even in the last bit.
void add_units(Catalogue& c) {
  struct Unit {
    const char* what;
    double mass, length, time, digits;
  };
  const Unit units[] = {{"mass x 2^40", 0x1p40, 1, 1, 16},
                        {"length x 2^-30", 1, 0x1p-30, 1, 16},
                        {"time x 2^-60", 1, 1, 0x1p-60, 16},
                        {"argon in SI", 6.6335e-26, 3.405e-10, 2.156e-12, 8},
                        {"length x 1e9", 1, 1e9, 1, 8}};
  for (const auto& [name, p] : base_cases()) {
    const CollisionLaw* law = find_collision_law(name);
    if (!law) continue;
    const double exact = c.run(name, p).e_squared;
    for (const Unit& u : units) {
      // D is multiplied by powers that are no powers of two: the last bits differ.
      const double digits = name == "power" ? std::min(u.digits, 8.0) : u.digits;
      c.add(name, fmt::format("e^2 with {}", u.what),
            c.run(name, in_units(*law, p, u.mass, u.length, u.time)).e_squared, exact, digits);
    }
  }
}

/// Only R* and m* matter: a wall and a sphere of half the radius and mass. (C of `stress` belongs
/// to 2 R*.)
void add_geometry(Catalogue& c) {
  for (const auto& [name, p] : base_cases()) {
    if (!find_collision_law(name)) continue;
    const double infinity = std::numeric_limits<double>::infinity();
    const Collision equal = c.run(name, p);
    Parameters wall = p;
    wall.erase("R");
    wall.erase("m");
    wall = with(wall,
                {{"R1", p.at("R") / 2}, {"R2", infinity}, {"m1", p.at("m") / 2}, {"m2", infinity}});
    c.add(name, "e^2 on a wall", c.run(name, wall).e_squared, equal.e_squared, 16);
    wall = with(wall, {{"R1", p.at("R") * 0.75}, {"R2", p.at("R") * 1.5}});
    c.add(name, "delta_max of unequal spheres", c.run(name, wall).delta_max, equal.delta_max, 12);
  }
}

/// v at which JKR spheres begin to bounce: m* v^2/2 = 0.7722405 F_c delta_0.
double jkr_threshold(const Parameters& p) {
  const double pi = std::numbers::pi, r = p.at("R") / 2, m = p.at("m") / 2, gamma = p.at("gamma");
  const double a0 = std::cbrt(9 * pi * gamma * r * r / p.at("E"));
  const double loss = (6 * std::pow(4.0, 4.0 / 3.0) + 4) / 5 * std::pow(6.0, -4.0 / 3.0);
  return std::sqrt(2 * loss * 3 * pi * gamma * r * (a0 * (a0 / (3 * r))) / m);
}

void add_jkr(Catalogue& c) {
  const Parameters& p = base_cases().at("jkr");
  const double v0 = jkr_threshold(p);
  for (const double x : {1 + 1e-9, 1 + 1e-6, 1.001, 1.5, 10.0, 1e3, 1e6})
    c.add("jkr", fmt::format("e^2 at {} times the sticking velocity", x),
          c.run("jkr", with(p, {{"v", x * v0}})).e_squared, (1 - 1 / x) * (1 + 1 / x),
          x < 1.01 ? 5 : 13);
  for (const double x : {1 - 1e-9, 0.999, 0.1, 1e-6})
    c.add_stick("jkr", fmt::format("sticks at {} times the sticking velocity", x),
                c.run("jkr", with(p, {{"v", x * v0}})));
  for (double r = 1; r < 2e9; r *= 10) {
    Parameters q = with(p, {{"R", r}, {"m", 4.5 * r * r * r}});
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

void add_hertz(Catalogue& c) {
  const Parameters& p = base_cases().at("hertz");
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
  const Parameters& p = base_cases().at("viscous-hertz");
  for (const double t : {1e-30, 1e-6, 0.01, 1.0, 100.0}) {
    const double e2 = c.run("viscous-hertz", with(p, {{"T_vis", t}})).e_squared;
    c.add("viscous-hertz", fmt::format("e^2 by T v^0.2, T = {:g}", t),
          c.run("viscous-hertz", with(p, {{"T_vis", t / 2}, {"v", 32 * p.at("v")}})).e_squared, e2,
          7);
  }
  const Parameters one{{"R", 2}, {"m", 2}, {"E", 1}, {"v", 1}, {"nu", 0.5}};
  for (const double t : {1e-3, 1e-5, 1e-7}) {
    const double loss = 4 * 8 * t * std::pow(15.0 / 16.0, 0.6) * 0.4 * std::beta(0.6, 1.5);
    c.add("viscous-hertz", fmt::format("loss of little damping, T = {:g}", t),
          1 - c.run("viscous-hertz", with(one, {{"T_vis", t}}), 1e-12).e_squared, loss,
          t > 1e-4 ? 1 : 3);
  }
  c.add("viscous-hertz", "e without damping", c.run("viscous-hertz", with(one, {{"T_vis", 0}})).e,
        1, 16);
}

/// R multiplied by r, and everything else so that w_0, lam, kap and b stay.
Parameters similar(const Parameters& p, double r) {
  // a_0 and delta_0 as R, if gamma is as E R; tau as R sqrt(m/(E R^3)).
  Parameters q =
      with(p, {{"R", r * p.at("R")}, {"m", r * r * r * p.at("m")}, {"gamma", r * p.at("gamma")}});
  if (q.count("spacing")) q["spacing"] *= r;
  if (q.count("T_vis")) q["T_vis"] *= r;
  if (q.count("v_Y")) q["v_Y"] = p.at("v_Y");
  if (q.count("D")) q["D"] *= std::pow(r, 2 - p.at("beta"));
  return q;  // stress: T = C R
}

void add_similar(Catalogue& c) {
  for (const std::string_view law : {"krijt", "krijt-plastic", "stress", "power", "jkr"}) {
    const Parameters& p = base_cases().at(law);
    const double exact = c.run(law, p).e_squared;
    for (const double r : {1.0 / 147, 1e-9, 1e3, 1e7})
      c.add(law, fmt::format("e^2 of a similar sphere, R x {:.3g}", r),
            c.run(law, similar(p, r)).e_squared, exact, 8);
  }
}

/// Without dissipation JKR, with much or at low speed sticking.
void add_krijt(Catalogue& c) {
  for (const std::string_view law : {"krijt", "stress"}) {
    const Parameters& p = base_cases().at(law);
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
  const Parameters& p = base_cases().at("krijt");
  const double viscous = c.run("viscous-hertz", base_cases().at("viscous-hertz")).e_squared;
  for (const double gamma : {1e-2, 1e-4, 1e-6, 1e-10})
    c.add("krijt", fmt::format("e^2 with gamma = {:g} is viscous-hertz'", gamma),
          c.run("krijt", with(p, {{"gamma", gamma}}), 1e-8).e_squared, viscous,
          std::min(6.0, 1.4 - 0.5 * std::log10(gamma)));
  c.add("krijt", "e^2 without adhesion", c.run("krijt", with(p, {{"gamma", 0}})).e_squared, viscous,
        16);
  const double curve = c.run("krijt", with(p, {{"T_crack", 0}})).e_squared;
  Parameters power =
      with(base_cases().at("power"), {{"D", 2 * 0.075 / 0.0625}, {"alpha", 1}, {"beta", 1}});
  c.add("power", "e^2 of D v a is that of bulk dissipation", c.run("power", power).e_squared, curve,
        9);
}

void add_stress(Catalogue& c) {
  const Parameters& p = base_cases().at("stress");
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

/// F_dis = D v^2 a^3 without adhesion: e^2 = 1/(1 + 3 D_s/4), D_s = D E v^2 a^3/force; D_s as v^2,
/// so that the rebound speed saturates.
void add_power(Catalogue& c) {
  const Parameters one{{"R", 2},     {"m", 2},     {"E", 1},   {"v", 1},
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
  const Parameters& p = base_cases().at("power");
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
  const Parameters& p = base_cases().at("andrews");
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

/// Ice grains of 0.1 um.
void add_grains(Catalogue& c) {
  Parameters p{{"R", 1e-7}, {"rho", 1000}, {"E", 7e9 / (2 * (1 - 0.0625))}, {"gamma", 0.1}};
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

std::vector<LawCase> law_catalogue() {
  Catalogue c;
  add_units(c);
  add_geometry(c);
  add_similar(c);
  add_hertz(c);
  add_viscous_hertz(c);
  add_jkr(c);
  add_krijt(c);
  add_stress(c);
  add_power(c);
  add_plastic(c);
  add_grains(c);
  return std::move(c.cases);
}

}  // namespace mdana
