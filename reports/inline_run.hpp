// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "reports/run.hpp"

namespace mdana {

/// The format of a run without a dump: what LAMMPS wrote by the lines of mdana emit --for lammps-inline.
inline constexpr std::string_view inline_format = "lammps_inline";

/// Whether there are atoms, or only sums over those of each body.
inline bool has_atoms(const Run& run) { return run.format != inline_format; }
inline constexpr const char* needs_atoms =
    "needs the atoms; what LAMMPS wrote by mdana emit --for lammps-inline has sums over the bodies alone, of which force, fit-hertz, "
    "fit-force and energy tell";

/// Such a file as a run whose frames are its rows; the scene is the one of the options, else what its head says of
/// it. Throws InputError, also for options that say what was settled when the run was made.
Run inline_run(const RunOptions& options);

/// As sweep() gives it: of such a file its rows, of any other run the dump is read. Throws InputError, too, if an analysis needs
/// more than the file has.
SweepResult sweep_run(const Run& run, std::span<const std::unique_ptr<Analysis>> analyses, const SweepOptions& options);

/// Standard deviation of the difference of two bodies' mean positions (column x) or velocities (vx) by the printed
/// digits, where the bodies have so many atoms; 0 if they are exact or not known.
double rounding_of_means(const Run& run, const std::string& column, double atoms1, double atoms2, int dropped_digits);

}  // namespace mdana
