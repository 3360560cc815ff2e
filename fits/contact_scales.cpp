// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/contact_scales.hpp"

#include <cmath>
#include <numbers>

namespace mdana {

LawInput::LawInput(const CollisionInput& input) {
  const Impact& i = input.impact;
  radius = Parameter::variable(i.radius, 0);
  mass = Parameter::variable(i.mass, 1);
  modulus = Parameter::variable(i.modulus, 2);
  velocity = Parameter::variable(i.velocity, 3);
  for (std::size_t k = 0; k < input.values.size(); ++k)
    values.push_back(Parameter::variable(input.values[k], static_cast<int>(4 + k)));
}

double ContactScales::centre_pressure(double u) const {
  const double p = adhesive ? u - 1 / (3 * std::sqrt(u)) : u;
  return pressure.value * p * modulus.value;
}

ContactScales jkr_scales(const LawInput& i, const Parameter& gamma) {
  const double pi = std::numbers::pi;
  ContactScales s;
  s.radius = cbrt(9 * pi * gamma * i.radius * (i.radius / i.modulus));
  s.delta = s.radius * (s.radius / (3 * i.radius));
  s.force = 3 * pi * gamma * i.radius;
  s.time = sqrt(i.mass * (s.delta / s.force));
  s.pressure = 2 / pi * (s.radius / i.radius);
  s.modulus = i.modulus;
  return s;
}

ContactScales hertz_scales(const LawInput& i) {
  ContactScales s;
  s.adhesive = false;
  const Parameter x = pow(
      (i.mass / (i.radius * i.radius * i.radius)) * (i.velocity * (i.velocity / i.modulus)), 0.4);
  s.delta = x * i.radius;
  s.time = s.delta / i.velocity;
  s.radius = sqrt(x) * i.radius;
  s.force = i.mass * (i.velocity / s.time);
  s.pressure = 2 / std::numbers::pi * sqrt(x);
  s.modulus = i.modulus;
  return s;
}

}  // namespace mdana
