// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/usual_parameters.hpp"

#include <cmath>
#include <numbers>

namespace mdana {

std::pair<double, double> usual_range(std::string_view name, const CollisionScales& s) {
  const double energy = s.mass * s.velocity * s.velocity / 2;
  if (name == "T_vis" || name == "T_crack" || name == "T") return {1e-4 * s.time, s.time};
  if (name == "C") return {1e-5 * s.time / s.radius, s.time / s.radius};
  if (name == "B") return {0.1 / s.pressure, 4 / s.pressure};
  if (name == "zeta" || name == "alpha" || name == "beta") return {0.5, 6};
  if (name == "D") return {1e-3 * s.force / s.modulus, 10 * s.force / s.modulus};
  if (name == "E") return {0.03 * s.modulus, 30 * s.modulus};
  if (name == "R") return {0.5 * s.radius, 8 * s.radius};
  if (name == "Y") return {1e-3 * s.modulus, s.modulus};
  if (name == "v_Y") return {0.01 * s.velocity, 10 * s.velocity};
  if (name == "nu") return {0.05, 0.5};
  if (name == "spacing") return {0.1 * s.contact_radius, s.contact_radius};
  if (name == "gamma") {  // JKR: the loss 0.7722 F_c delta0 is the energy at about the upper end
    const double r = s.radius;
    const double loss_of_one = 0.7722 * std::pow(9 * std::numbers::pi, 2.0 / 3.0) * std::numbers::pi *
                               std::pow(r, 4.0 / 3.0) * std::pow(s.modulus, -2.0 / 3.0);
    const double most = std::pow(energy / loss_of_one, 0.6);
    return {1e-4 * most, 10 * most};
  }
  return {1e-3, 1e3};
}

std::vector<FreeParameter> usual_free_parameters(const CollisionLaw& law) {
  std::vector<std::string> names;
  if (law.name == "stress") names = {"C", "B", "zeta"};
  else if (law.name == "power") names = {"D", "alpha", "beta"};
  else if (law.name == "jkr") names = {"gamma"};
  else if (law.name == "andrews") names = {"E", "Y"};
  else if (law.name == "krijt-plastic") names = {"T_vis", "v_Y"};
  else if (parameter_index(law, "T_vis")) names = {"T_vis"};
  else if (parameter_index(law, "v_Y")) names = {"v_Y"};
  std::vector<FreeParameter> free;
  for (std::string& name : names) free.push_back({std::move(name), {}, {}, {}, {}, false});
  return free;
}

}  // namespace mdana
