// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "fits/law_cases.hpp"

namespace mdana {
namespace {

double unit_of(const Dimension& d, double mass, double length, double time) {
  return std::pow(mass, d.mass) * std::pow(length, d.length) * std::pow(time, d.time);
}

/// The same collision in other units; power's D by its exponents.
CaseParameters in_units(const CollisionLaw& law, CaseParameters p, double mass, double length,
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
    CaseParameters wall = p;
    wall.erase("R");
    wall.erase("m");
    wall = with(wall,
                {{"R1", p.at("R") / 2}, {"R2", infinity}, {"m1", p.at("m") / 2}, {"m2", infinity}});
    c.add(name, "e^2 on a wall", c.run(name, wall).e_squared, equal.e_squared, 16);
    wall = with(wall, {{"R1", p.at("R") * 0.75}, {"R2", p.at("R") * 1.5}});
    c.add(name, "delta_max of unequal spheres", c.run(name, wall).delta_max, equal.delta_max, 12);
  }
}

/// R multiplied by r, and everything else so that w_0, lam, kap and b stay.
CaseParameters similar(const CaseParameters& p, double r) {
  // a_0 and delta_0 as R, if gamma is as E R; tau as R sqrt(m/(E R^3)).
  CaseParameters q =
      with(p, {{"R", r * p.at("R")}, {"m", r * r * r * p.at("m")}, {"gamma", r * p.at("gamma")}});
  if (q.count("spacing")) q["spacing"] *= r;
  if (q.count("T_vis")) q["T_vis"] *= r;
  if (q.count("v_Y")) q["v_Y"] = p.at("v_Y");
  if (q.count("D")) q["D"] *= std::pow(r, 2 - p.at("beta"));
  return q;  // stress: T = C R
}

void add_similar(Catalogue& c) {
  for (const std::string_view law : {"krijt", "krijt-plastic", "stress", "power", "jkr"}) {
    const CaseParameters& p = base_cases().at(law);
    const double exact = c.run(law, p).e_squared;
    for (const double r : {1.0 / 147, 1e-9, 1e3, 1e7})
      c.add(law, fmt::format("e^2 of a similar sphere, R x {:.3g}", r),
            c.run(law, similar(p, r)).e_squared, exact, 8);
  }
}

}  // namespace

void add_scaling_cases(Catalogue& c) {
  add_units(c);
  add_geometry(c);
  add_similar(c);
}

}  // namespace mdana
