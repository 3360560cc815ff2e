// SPDX-License-Identifier: GPL-3.0-or-later
// What every force law of the list keeps.
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fits/contacts.hpp"

namespace mdana {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// All functions of delta, by name; the pressure at the centre and within the contact.
std::vector<std::pair<const char*, double>> values(const ForceBranch& branch, double delta,
                                                   const ElasticContact& c) {
  return {{"force", branch.force(delta, c)},
          {"contact radius", branch.contact_radius(delta, c)},
          {"stiffness", branch.stiffness(delta, c)},
          {"energy", branch.energy(delta, c)},
          {"pressure", branch.pressure(0, delta, c)},
          {"pressure off the centre", branch.pressure(c.radius / 100, delta, c)},
          {"radius of pressure", branch.pressure_radius(delta, c)}};
}

// A delta that is not known must not look like spheres that are apart.
TEST(ForceLawContract, NoDeltaNoValue) {
  for (const ForceLaw* law : force_laws())
    for (ElasticContact c : {test::lj, test::ice, test::weak})
      for (const double gamma : {c.surface_energy, 0.0}) {
        c.surface_energy = gamma;
        c.delta_max = c.radius / 10;
        for (const ForceBranch* branch : {static_cast<const ForceBranch*>(law), &unloading(*law)}) {
          for (const auto& [what, value] : values(*branch, unknown, c))
            EXPECT_TRUE(std::isnan(value)) << law->name << ", " << what << ", gamma " << gamma;
          for (const auto& [what, value] : values(*branch, c.delta_max, c))
            EXPECT_TRUE(std::isfinite(value)) << law->name << ", " << what << ", gamma " << gamma;
        }
      }
}

}  // namespace
}  // namespace mdana
