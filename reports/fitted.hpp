// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analyses/force_curve.hpp"
#include "analyses/table.hpp"
#include "fits/force_fit.hpp"
#include "fits/hertz.hpp"
#include "reports/document.hpp"
#include "reports/run.hpp"

namespace mdana {

/// A Hertz fit with its spread; the errors of modulus and radius are the larger of the standard
/// error and the spread's deviation.
struct HertzResult {
  HertzFit fit;
  HertzSpread spread;
  Value modulus, radius;
};

/// Of a curve with the radii whose ratio it was measured with.
HertzData hertz_data(const ForceCurve& curve, const Radii& radii);
ForceData force_data(const ForceCurve& curve, const Radii& radii);

HertzResult fit_hertz_with_spread(const HertzData& data, const HertzSettings& settings);

/// Throws InputError if the bodies differ by more than 1 % in mass or size and their radii are not given: F(X)
/// does not tell R1/R2. `motion` is a motion table.
void require_known_ratio(const Run& run, const Table& motion, const Radii& radii);

/// Numbers of the fit under the names that other programs rely on.
void add_hertz(Document& document, const Run& run, const HertzResult& hertz);

/// Columns frame, X, F, F_fit, residual of the fitted points.
Table hertz_table(const HertzResult& hertz, const ForceCurve& curve);

/// The fitted force at a distance [force].
double fitted_force(const HertzFit& fit, double distance);

}  // namespace mdana
