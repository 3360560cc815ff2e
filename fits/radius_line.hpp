// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "analyses/value.hpp"

namespace mdana {

/// delta_max = slope R_agg + intercept (Arakawa et al. 2024, eqs 14, 20), and the offset of the surface
/// that makes delta_max - 2 offset proportional to R_agg - offset (eqs 15, 17, 18, 21).
struct RadiusLine {
  Value slope;          ///< also delta_max,eff/R_eff
  Value intercept;      ///< [length]
  double covariance;    ///< of slope and intercept [length]; NaN if not known
  Value offset;         ///< intercept/(2 - slope) [length]
  double chi2;          ///< of the errors that are given; else the sum of squared residuals
};

/// Least squares, weighted if errors are given. Standard errors are by the errors given, or by the
/// residuals where those are greater or nothing is given; none from two points without errors. There are
/// at least two points, of two radii.
RadiusLine fit_radius_line(std::span<const double> radius, std::span<const double> delta_max,
                           std::span<const double> errors);

}  // namespace mdana
