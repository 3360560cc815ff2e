// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mdana {

/// A stiff or extreme case of one member, of which something is known by analysis.
struct ExtremeCase {
  enum class Verdict {
    kept,      ///< at least the digits that it should keep
    lost,      ///< fewer: a wrong number without a warning
    refused,   ///< an error or a warning that names the cause, where that is right
    accepted,  ///< a number where there is none
  };

  std::string member;         ///< "collision", "fit-hertz", a law
  std::string what;           ///< "atoms 1e7 radii from the origin"
  std::string quantity;       ///< of several numbers the one with the fewest digits to spare
  double computed = 0, exact = 0;
  double digits = 0;          ///< that agree
  double needed = 0;          ///< that must, by the rounding of the input or the stated error
  double condition = 0;       ///< of a fit; 0 if there is none
  long evaluations = 0;       ///< of a law's equations of motion
  bool unresolved = false;    ///< a law says that it does not know
  double seconds = 0;
  Verdict verdict = Verdict::kept;
  std::string told;           ///< the refusal

  bool right() const { return verdict == Verdict::kept || verdict == Verdict::refused; }
};

std::string_view name(ExtremeCase::Verdict verdict);

/// Collisions written as dumps and analysed from there: any units and sizes, far away, on a drift, large ids
/// and steps, coarse, few, noisy and rounded frames, and what must be refused.
std::vector<ExtremeCase> extreme_dumps();

/// Fits of forces and collisions to points of known laws: narrow ranges, few points, tiny and huge
/// scales, radii far greater than delta, and data that determine nothing.
std::vector<ExtremeCase> extreme_fits();

/// The collisions of the laws' catalogue (fits/law_catalogue.hpp).
std::vector<ExtremeCase> extreme_laws();

/// Crystals of which faults and lines are known: any lengths, far away, turned, noisy, and too few atoms. None if this
/// build has no defects.
std::vector<ExtremeCase> extreme_structures();

/// Contacts of grains on a lattice: any lengths, tiny overlaps, far away, unequal, and what must be refused.
std::vector<ExtremeCase> extreme_networks();

}  // namespace mdana
