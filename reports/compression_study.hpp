// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "fits/contact_fit.hpp"
#include "fits/radius_line.hpp"
#include "reports/compressed.hpp"

namespace mdana {

/// delta_max against R_agg at one velocity.
struct RadiusLineAt {
  double velocity = 0;  ///< [velocity]
  std::size_t runs = 0;
  RadiusLine line;
};

/// Andrews' law by delta_max and t_max (eqs 34, 35).
struct AndrewsFits {
  ContactFit both;           ///< E* and Y
  ContactFit counted;        ///< the same with the counted masses
  ContactFit elastic;        ///< E* alone, Y infinite
  ContactFit rigid_plastic;  ///< Y alone, E* infinite
};

/// Several collisions of aggregates of one kind together.
struct CompressionStudy {
  Split split = Split::sign;
  std::vector<CompressedRun> runs;
  std::vector<RadiusLineAt> lines;        ///< of velocities with two radii and more
  SurfaceOffset offset;
  std::vector<Compressing> numbers;       ///< one a run
  std::vector<std::size_t> fitted;        ///< runs whose delta_max and v are known
  std::vector<ObservedCollision> seen;    ///< one a fitted run, from R_eff, with m* of eq. 29
  bool known_errors = false;              ///< there are repeats, which tell them
  std::optional<AndrewsFits> fits;
  std::string no_fit;                     ///< why there are none

  const MaximumCompression& maximum(std::size_t run) const {
    return numbers[run].by[static_cast<std::size_t>(split)];
  }
  /// Whether several velocities were there to be fitted, but do not determine E* and Y.
  bool fit_failed() const;
};

/// The offset is the one given, else that of the lines if it differs from zero by two standard errors,
/// else none. Throws InputError if it leaves nothing of a radius, or if runs have other units.
CompressionStudy study_compression(std::vector<CompressedRun> runs, Split split,
                                   const std::optional<SurfaceOffset>& offset);

/// Lines, offset, dispersion and sticking by radius and velocity, E* and Y, or the pairs of them that one
/// velocity allows. The runs themselves are told by add_compression.
void add_compression_study(Document& document, const CompressionStudy& study);

/// The pairs E*, Y that one delta_max from 2 R_eff allows (Fig. 10), and the two ends of the line.
void add_degeneracy(Document& document, const Impact& impact, const Value& delta_max);

/// A row a run: radii, v, delta_max, t_max, outcome, e, and if E* and Y are found delta_max and t_max by
/// the fit, in the elastic and in the rigid plastic limit.
Table compression_study_table(const CompressionStudy& study);

}  // namespace mdana
