// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "analyses/energy_curve.hpp"
#include "analyses/force_curve.hpp"
#include "analyses/value.hpp"

namespace mdana {

/// Frames [first, last) that are averaged over.
struct EnergyWindow {
  std::size_t first = 0, last = 0;
  std::size_t frames() const { return last - first; }
};

/// Before: the first half of the frames before contact. After: the last half of those after
/// separation; if there are none, the last whole periods of the bound pair, between turns of delta of the
/// same kind, as few as hold a tenth of all frames, at least eight; without a whole period, or if none
/// ends near the end, the last tenth, but none before the first turn. Nothing if there is no frame before contact, or no turn.
struct EnergyWindows {
  EnergyWindow before, after;
};
std::optional<EnergyWindows> energy_windows(const ForceCurve& curve);

/// What a collision made of the energy: differences after - before, of means over the windows. The
/// standard error of a mean is the larger of s/sqrt(n) and half the difference of the means of the two
/// halves of the window, which sees correlated frames; of one frame, the change to its neighbours. Values
/// are NaN where something is unknown.
struct EnergyBudget {
  EnergyWindows windows;
  Value K_p_initial;  ///< of the relative motion
  Value delta_K_p;    ///< of the relative motion; what is lost is negative
  Value delta_K_t;    ///< of both bodies, rotation included
  Value delta_rotation;
  Value delta_W;      ///< its error holds that of total energy, which no window sees
  Value K_t_share, W_share;  ///< delta_K_t and delta_W over |delta_K_p|
  Value energy_drift;        ///< change of K_p + K_t + W over K_p_initial
  /// (delta_K_t + delta_W) / K_p_initial; its error holds the ringing, which is yet to be converted.
  Value converted;
  Value ringing;             ///< of bodies that stick: K_p after / K_p_initial; else 0
  Value restitution;         ///< e by the approach speeds; 0 if the bodies stick, NaN if unresolved
  Value across;              ///< change of K_p across the centre line over K_p_initial
  Value one_minus_e2;        ///< should be converted - energy_drift + across + ringing
  std::array<Value, 2> temperature_before, temperature_after;
};
EnergyBudget energy_budget(const EnergyCurve& energy, const ForceCurve& curve,
                           const EnergyWindows& windows);

/// Mean of the values in the window that are known, and its error by the rule above.
Value window_mean(const std::vector<double>& values, EnergyWindow window, Dimension dimension);

}  // namespace mdana
