// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "fits/contact_scales.hpp"

namespace mdana {

/// Parameters that several laws share.
namespace parameter {
inline constexpr std::array<std::string_view, 2> starts{"min", "jkr"};
inline constexpr CollisionParameter gamma{
    "gamma", "surface energy of one surface", dimension::surface_energy, 0, true, 1e300, {}};
inline constexpr CollisionParameter nu{"nu", "Poisson's ratio", dimension::none, 0, false, 0.5, {}};
inline constexpr CollisionParameter T_vis{
    "T_vis", "relaxation time of the bulk", dimension::time, 0, true, 1e300, {}};
inline constexpr CollisionParameter T_crack{
    "T_crack",
    "relaxation time in the crack law (default: that of the bulk)",
    dimension::time,
    0,
    true,
    1e300,
    Collision::unknown};
inline constexpr CollisionParameter spacing{
    "spacing",
    "between neighbouring atoms, gamma/sigma_0 (default: 1.091, fcc in units lj)",
    dimension::length,
    0,
    false,
    1e300,
    1.091};
inline constexpr CollisionParameter start{
    "start",
    "contact radius at delta = 0: least that the crack law has (min), or on the JKR curve (jkr)",
    dimension::none,
    0,
    true,
    1,
    0,
    {},
    starts};
}  // namespace parameter

/// T(p_c) = T_vis exp[(B p_c/E*)^zeta] for p_c > 0, else T_vis (P1 eq. 17).
struct StressDependence {
  Parameter b, zeta;
};

/// Adhesive spheres with bulk dissipation and a crack at the edge of contact: P1 eqs 10-12, B1, B2.
struct ViscousContact {
  Parameter gamma, nu, T_vis;
  std::optional<Parameter> T_crack;  ///< else as T_vis
  Parameter spacing = 1.091;
  bool start_on_curve = false;
  std::optional<StressDependence> stress;
};

/// Without adhesion a = sqrt(R* delta); without delay in the crack law a is on the JKR curve;
/// without any dissipation e has a closed form.
Collision collide_viscous(const LawInput& input, const ViscousContact& contact,
                          const CollisionSettings& settings);

/// Elastic collision without adhesion, in closed form.
Collision collide_elastic(const LawInput& input, const CollisionSettings& settings);

}  // namespace mdana
