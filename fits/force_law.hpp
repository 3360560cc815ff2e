// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "fits/named_value.hpp"
#include "readers/dimension.hpp"

namespace mdana {

/// Two spheres in contact, reduced to one sphere on a rigid plane. A law reads what its parameters
/// name; the rest may be left out.
struct ElasticContact {
  double radius = 0;          ///< R*, 1/R* = 1/R1 + 1/R2 [length]
  double modulus = 0;         ///< E*, 1/E* = sum (1 - nu^2)/E [pressure]
  double surface_energy = 0;  ///< gamma of one surface [energy/length^2]
  double yield_strength = 0;  ///< Y [pressure]
  double spacing = 0;         ///< of the atoms: theoretical stress sigma0 = gamma/spacing [length]
  double delta_max = 0;       ///< greatest delta so far, where unloading begins [length]
};

/// A parameter of a force law: a member of ElasticContact.
struct ContactParameter {
  std::string_view name;     ///< "R*"
  std::string_view meaning;
  Dimension dimension;
  double ElasticContact::*value;
  bool zero_allowed = false;  ///< all are positive and finite
};

namespace contact_parameter {
inline constexpr ContactParameter radius{
    "R*", "reduced radius, 1/R* = 1/R1 + 1/R2", dimension::length, &ElasticContact::radius};
inline constexpr ContactParameter modulus{"E*", "reduced modulus, 1/E* = sum (1 - nu^2)/E",
                                          dimension::pressure, &ElasticContact::modulus};
inline constexpr ContactParameter surface_energy{"gamma", "energy of one surface",
                                                 dimension::surface_energy,
                                                 &ElasticContact::surface_energy, true};
inline constexpr ContactParameter yield_strength{"Y", "yield strength", dimension::pressure,
                                                 &ElasticContact::yield_strength};
inline constexpr ContactParameter spacing{"spacing", "of the atoms; sigma0 = gamma/spacing",
                                          dimension::length, &ElasticContact::spacing};
}  // namespace contact_parameter

/// Force and what belongs to it as functions of delta, on loading or on unloading; NaN for a delta
/// that is NaN.
struct ForceBranch {
  /// Force, repulsive > 0 [force]; zero where the law has no contact.
  double (*force)(double delta, const ElasticContact& contact) = nullptr;
  /// Contact radius [length]; zero without contact.
  double (*contact_radius)(double delta, const ElasticContact& contact) = nullptr;
  /// Least delta with contact [length].
  double (*least_delta)(const ElasticContact& contact) = nullptr;
  /// dF/ddelta [force/length]; -inf at a pull-off with a vertical tangent, zero without contact.
  double (*stiffness)(double delta, const ElasticContact& contact) = nullptr;
  /// Work done on the contact since the spheres were apart [energy], F = dU/ddelta; zero without
  /// contact. On unloading: what is left to be gained.
  double (*energy)(double delta, const ElasticContact& contact) = nullptr;
  /// Normal pressure at the distance r >= 0 from the centre of contact [pressure].
  double (*pressure)(double r, double delta, const ElasticContact& contact) = nullptr;
  /// Radius beyond which the pressure is zero [length]: of contact, or of a cohesive zone about it.
  double (*pressure_radius)(double delta, const ElasticContact& contact) = nullptr;
};

/// A law F(delta). Members of MDANA_LAWS in CMakeLists.txt; each defines
/// `extern const ForceLaw <name>_law`. The functions of the law itself are those of loading.
struct ForceLaw : ForceBranch {
  std::string_view name;
  std::string_view summary;
  std::span<const ContactParameter> parameters;
  /// From contact.delta_max down; null if it is the way back on the same curve.
  const ForceBranch* unloading = nullptr;
};

/// All force laws of this build.
std::span<const ForceLaw* const> force_laws();

/// The law of that name; null if this build has none.
const ForceLaw* find_force_law(std::string_view name);

/// The branch of unloading: that of loading for a law without history.
const ForceBranch& unloading(const ForceLaw& law);

/// Name without its star, as users give it: "E" is E*. R is the radius of each of two equal spheres.
std::string_view given_name(const ContactParameter& parameter);

/// Reads and checks what the law needs: R or R1 R2 (R2 may be inf: a wall), and its other parameters.
/// Throws InputError naming the one that is unknown, given twice, missing, not a number or out of its
/// range.
ElasticContact elastic_contact(const ForceLaw& law, std::span<const NamedValue> given);

/// Throws InputError naming a parameter of the law that is out of its range.
void require_parameters(const ForceLaw& law, const ElasticContact& contact);

}  // namespace mdana
