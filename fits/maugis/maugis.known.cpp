// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "fits/force_law.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

extern const ForceLaw maugis_law;
std::vector<KnownAnswer> maugis_known();

namespace {

/// A contact of radius a with a zone up to c = 2a under sigma0 (arccos a/c = pi/3): gamma from the
/// width of the zone, delta and F in closed form, R* = E* = 1 (Maugis 1992, eqs 6.15-6.19).
struct Zone {
  double a, stress;
  static constexpr double theta = std::numbers::pi / 3;
  double root = std::sqrt(3.0) * a;  // sqrt(c^2 - a^2)
  double delta = a * a - 2 * stress * root;
  double force = 4.0 / 3.0 * a * a * a - 2 * stress * (4 * a * a * theta + a * root);
  double gamma = stress / std::numbers::pi * stress *
                 (2 * stress * (root * theta - a) + a * a * theta + a * root / 2) / stress;
  ElasticContact contact{1, 1, gamma, 0, gamma / stress};
};

}  // namespace

std::vector<KnownAnswer> maugis_known() {
  const Zone soft{0.25, 0.125}, hard{0.25, 1.0 / 64};
  std::vector<KnownAnswer> answers;
  for (const Zone& z : {soft, hard}) {
    const ElasticContact& c = z.contact;
    answers.insert(
        answers.end(),
        {{"a with c = 2a", maugis_law.contact_radius(z.delta, c), z.a, 14},
         {"c = 2a", maugis_law.pressure_radius(z.delta, c), 2 * z.a, 14},
         {"F with c = 2a", maugis_law.force(z.delta, c), z.force, 13},
         {"p_c = 2 E* a/(pi R*) - 2/3 sigma0", maugis_law.pressure(0, z.delta, c),
          2 * z.a / std::numbers::pi - 2.0 / 3.0 * z.stress, 13},
         {"p of the zone", maugis_law.pressure(1.5 * z.a, z.delta, c), -z.stress, 14}});
  }
  const ElasticContact plain{4, 0.75, 0, 0, 1};  // as hertz
  answers.push_back({"F without adhesion", maugis_law.force(9, plain), 54, 15});
  return answers;
}

}  // namespace mdana
