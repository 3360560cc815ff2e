// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyses/energy_budget.hpp"
#include "analyses/force_curve.hpp"
#include "analyses/table.hpp"
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

  std::array<Value, 2> bump;  ///< growth of the far side of body 1, 2 [length]; see far_side_growth

  Plasticity verdict = Plasticity::no;
  std::vector<std::string> reasons;
};

inline constexpr double yield_begins = 0.24, yield_certain = 0.6;  ///< of p_c/E*

/// `contact` has R*; E* and gamma may be 0 if they are not known.
PlasticSigns plastic_signs(const ForceCurve& curve, const ElasticContact& contact);

/// How much farther a body reaches on its far side at the end than at first, by a column of the analysis
/// far_side: means over the windows, whose errors are thermal motion and rotation; without windows
/// the last frame less the first.
Value far_side_growth(const Table& far_side, std::size_t body,
                      const std::optional<EnergyWindows>& windows);

/// Takes the bumps into the verdict: a significant one is beyond three errors and bump_fraction of the
/// distance of nearest neighbours (a slipped plane of atoms stands out by more).
void judge_bumps(PlasticSigns& signs, const std::array<Value, 2>& bump, double spacing);
inline constexpr double bump_fraction = 0.3;

}  // namespace mdana
