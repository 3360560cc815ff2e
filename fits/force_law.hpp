// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace mdana {

/// Two elastic spheres in contact, reduced to one sphere on a rigid plane.
struct ElasticContact {
  double radius = 0;          ///< R*, 1/R* = 1/R1 + 1/R2 [length]
  double modulus = 0;         ///< E*, 1/E* = sum (1 - nu^2)/E [pressure]
  double surface_energy = 0;  ///< gamma of one surface [energy/length^2]
};

/// A law F(delta) that needs no history. Members of MDANA_LAWS in CMakeLists.txt; each defines
/// `extern const ForceLaw <name>_law`.
struct ForceLaw {
  std::string_view name;
  std::string_view summary;
  /// Force, repulsive > 0 [force]; zero where the law has no contact.
  double (*force)(double delta, const ElasticContact& contact);
  /// Contact radius [length]; zero without contact.
  double (*contact_radius)(double delta, const ElasticContact& contact);
  /// Least delta with contact [length].
  double (*least_delta)(const ElasticContact& contact);
};

/// All force laws of this build.
std::span<const ForceLaw* const> force_laws();

/// The law of that name; null if this build has none.
const ForceLaw* find_force_law(std::string_view name);

}  // namespace mdana
