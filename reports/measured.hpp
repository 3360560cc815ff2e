// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "analyses/force_curve.hpp"
#include "analyses/relative_motion.hpp"
#include "analyses/restitution.hpp"
#include "analyses/sweep.hpp"
#include "reports/document.hpp"
#include "reports/run.hpp"

namespace mdana {

/// The bodies' motion of a run, with the tables of other analyses from the same pass.
struct MeasuredMotion {
  SweepResult swept;  ///< tables: motion first, then the others in their order
  RelativeMotion motion;
};

/// One pass over the dump. Throws InputError also if there are fewer than two frames.
MeasuredMotion measure_motion(const Run& run, MotionParts parts,
                              std::vector<std::unique_ptr<Analysis>> others,
                              SweepOptions options);

/// Force curve of a measured motion; the error of the radii is part of that of delta_max. Throws
/// InputError if the bodies never touch. `by` as in force_series.
ForceCurve touching_force_curve(const Run& run, const RelativeMotion& motion, ForceSource source,
                                const Radii& radii, ForceDerivative by = {});

/// Numbers and sources of a force curve under the names that other programs rely on.
void add_force(Document& document, const ForceCurve& curve, ForceSource source,
               const Radii& radii);

/// Motion off the axis, e, e_total and the speeds that they are ratios of, if they are determined; Plan::settle says why not.
void add_restitution(Document& document, const Restitution& restitution);

/// `lost`, the greatest number of the bodies' atoms that are missing, and a warning if there are any.
void add_lost_atoms(Document& document, const RelativeMotion& motion);

/// Warns where the numbers of a force curve do not mean what they seem to.
void warn_of_force(Document& document, const ForceCurve& curve);

}  // namespace mdana
