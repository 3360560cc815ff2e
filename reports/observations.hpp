// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "fits/observed_collision.hpp"
#include "readers/input_record.hpp"

namespace mdana {

/// Collisions that were seen, and the files that tell of them.
struct Observations {
  struct File {
    InputRecord record;
    std::string format;  ///< "table", "collision", "compress"
  };
  std::vector<ObservedCollision> seen;
  std::vector<File> files;
  bool known_errors = true;  ///< every number that was seen has a standard error

  /// Whether some collision is given that parameter.
  bool given(std::string_view name) const;
};

/// What of a document of `mdana collision` is fitted: e and sticking, or delta_max and t_max.
enum class Wanted { restitution, compression };

/// Reads tables (CSV: a line of names, then one line a collision; # begins a comment) and results of
/// `mdana collision` and `mdana compress` (JSON or HDF5). Columns: e, sigma, outcome (bounce or stick; e empty or 0 is a
/// sticking collision, too), delta_max, delta_max_error, t_max, t_max_error, and parameters of the
/// laws by their names. Of `mdana compress` delta_max and t_max, with errors by the scatter of repeated
/// runs (fits/repeats.hpp). Throws InputError with file and line.
Observations read_observations(std::span<const std::filesystem::path> files, Wanted wanted = Wanted::restitution);

/// The collisions of one table; `place` is its name in messages.
std::vector<ObservedCollision> parse_collision_table(std::string_view text, const std::string& place);

/// The collisions that a document tells of, and the command that made it. Radii and masses as far as it
/// has them.
struct ObservedDocument {
  std::vector<ObservedCollision> seen;
  std::string command;
};
ObservedDocument parse_observed_document(std::string_view text, const std::string& place, Wanted wanted);

/// Fills m and E by R, and gamma, nu and spacing, where they are not given, from Yoshida, Kokubo &
/// Tanaka 2024 (fits/lj_particles.hpp), but not what is to stay free. Throws InputError with the place
/// of a radius that is none of theirs.
void fill_from_lj_particles(Observations& observations, std::span<const std::string> leave);

}  // namespace mdana
