// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyses/force_curve.hpp"
#include "analyses/value.hpp"
#include "fits/force_law.hpp"

namespace mdana {

/// Whether the bodies yielded.
enum class Plasticity { no, possible, yes };

std::string_view name(Plasticity plasticity);

/// Signs of plastic deformation (Yoshida, Kokubo & Tanaka 2024, Sec. IV A 3).
struct PlasticSigns {
  /// Pressure at the centre of the contact at greatest delta over E*: by Hertz, (2/pi) sqrt(delta/R*);
  /// by JKR if E* and gamma are known (eq. 9). Yield begins near 0.24; beyond 0.6 it is certain.
  Value pressure_hertz;
  std::optional<Value> pressure_jkr;
  /// delta at which the force vanishes on unloading less that on loading [length]; NaN if it does not.
  Value residual;
  /// By JKR if that is known, else by Hertz.
  const Value& pressure() const { return pressure_jkr ? *pressure_jkr : pressure_hertz; }

  Plasticity verdict = Plasticity::no;
  std::vector<std::string> reasons;
};

inline constexpr double yield_begins = 0.24, yield_certain = 0.6;  ///< of p_c/E*

/// `contact` has R*; E* and gamma may be 0 if they are not known.
PlasticSigns plastic_signs(const ForceCurve& curve, const ElasticContact& contact);

}  // namespace mdana
