// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "analyses/compression.hpp"
#include "analyses/force_curve.hpp"
#include "analyses/restitution.hpp"
#include "fits/collision_law.hpp"
#include "reports/document.hpp"
#include "reports/measured.hpp"
#include "reports/plan.hpp"
#include "reports/run.hpp"

namespace mdana {

/// What an atom counts for: the side of the contact plane where it is (Arakawa et al. 2024, eqs
/// 10-13), or the body that it belonged to first.
enum class Split { sign, membership };
inline constexpr std::array<std::string_view, 2> split_names{"sign", "membership"};

/// How much less than R_agg the radius R_eff of the effective surface is (eq. 15) [length].
struct SurfaceOffset {
  Value value{0, {}, dimension::length};
  std::string source = "none: t_max counts from X = 2 R_agg";
};

/// Two aggregates that collide, as they were measured. R_agg is the mean of both radii.
struct CompressedRun {
  std::string dump;
  Units units = Units::lj;
  Interaction interaction = Interaction::unknown;
  std::optional<double> filling_factor;   ///< by the scene
  Radii radii;
  std::array<double, 2> mass{};           ///< counted, of the first frame [mass]
  MeasuredMotion measured;
  ForceCurve curve;
  Restitution restitution;
  std::array<ApproachSeries, 2> series;   ///< by Split
  Value coordination;                     ///< mean over the grains of the first frame
  std::string no_coordination;            ///< why it is not known; else empty

  double radius() const { return radii.sum() / 2; }
  bool equal_bodies() const;              ///< radii and masses within 1 %, as the paper's formulas have them
};

/// One pass over the dump. Throws InputError: without contact, with less than two frames, without times.
CompressedRun measure_compression(const Run& run, const RunOptions& options, const SweepOptions& sweeping);

/// Leaves out what turned out not to be possible.
void settle(Plan& plan, const CompressedRun& run);

/// Motion of both bodies and of both halves: what -dX/dt and X are by either split.
ApproachSeries approach_by_membership(const RelativeMotion& motion);

/// What a run says once the offset is known.
struct Compressing {
  std::array<MaximumCompression, 2> by;  ///< by Split, from X = 2 R_eff
  double effective_radius = 0;           ///< R_eff = R_agg - offset [length]
  double density = 0;                    ///< of the aggregate: counted mass over the volume of R_agg
  Impact impact;                         ///< R* = R_eff/2, m* (eq. 29) for E* in force/length^2; v; no E*
  double counted_mass = 0;               ///< m* of the atoms, as `impact.mass`
};
Compressing compressing(const CompressedRun& run, const SurfaceOffset& offset);

/// Numbers of one run under the names that other programs rely on.
void add_compression(Document& document, const CompressedRun& run, Split split, const SurfaceOffset& offset);

/// step, time, delta, v_rel by the split, both by either split, atoms of the halves: a row a frame.
Table compression_table(const CompressedRun& run, Split split);

}  // namespace mdana
