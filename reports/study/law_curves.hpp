// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "reports/compression_study.hpp"
#include "reports/figure.hpp"

namespace mdana {

/// What a fitted law says, drawn into the figure of a kind.
struct LawCurve {
  std::string kind;
  std::string group;  ///< empty: of all groups
  Series series;
};

/// e(v), and delta, v, a, F of the first collision that was seen.
std::vector<LawCurve> curves_of(const CollisionLaw& law, const std::string& group, std::span<const ObservedCollision> seen,
                                const ContactFit& fit);

/// Greatest compression and its time over velocity with the found E* and Y and in both limits (Arakawa et al.
/// 2024, Figs 8, 9), over radius by straight lines (Figs 5, 6), and the motion of the first collision (Fig. 12).
/// `groups`: of runs by their names.
std::vector<LawCurve> curves_of(const CompressionStudy& study, const std::map<std::string, std::string>& groups);

}  // namespace mdana
