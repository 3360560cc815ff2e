// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "fits/force_law.hpp"

namespace mdana {
namespace {

double contact_radius(double delta, const ElasticContact& c) {
  return delta > 0 ? std::sqrt(c.radius * delta) : 0.0;
}

double force(double delta, const ElasticContact& c) {
  return delta > 0 ? 4.0 / 3.0 * c.modulus * std::sqrt(c.radius * delta) * delta : 0.0;
}

double least_delta(const ElasticContact&) { return 0; }

}  // namespace

extern const ForceLaw hertz_law;
const ForceLaw hertz_law{"hertz", "elastic spheres without adhesion", force, contact_radius,
                         least_delta};

}  // namespace mdana
