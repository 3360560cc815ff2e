// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fits/contact_motion.hpp"
#include "fits/contact_scales.hpp"

namespace mdana {

/// Integrates with ever smaller tolerances until two results agree to the tolerance wanted; the
/// difference of the last two, with the energy residual, is the error stated. The scaled parameters
/// are in the order of the motion's gradients: w0, lam, kap, b, zeta.
Collision collide_with_crack(const CrackContact& kind, const std::vector<Parameter>& scaled,
                             const ContactScales& scales, const CollisionSettings& settings);

/// The same on a curve; scaled parameters w0, then those of the resistance.
Collision collide_on_curve(const CurveContact& kind, const std::vector<Parameter>& scaled,
                           const ContactScales& scales, const CollisionSettings& settings);

/// Sets e, its error and the outcome by e^2; a value within its error of zero is unresolved.
void set_restitution(Collision& collision, double e_squared, double error);

}  // namespace mdana
