// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analyses/sweep.hpp"
#include "fits/observed_collision.hpp"
#include "readers/input_record.hpp"
#include "reports/csv_text.hpp"

namespace mdana {

/// Collisions that were seen, and the files that tell of them.
struct Observations {
  struct File {
    InputRecord record;
    std::string format;  ///< "table", "motion", "collision", "compress", or that of a dump
  };
  std::vector<ObservedCollision> seen;
  std::vector<File> files;
  bool known_errors = true;  ///< every number that was seen has a standard error

  /// Whether some collision is given that parameter.
  bool given(std::string_view name) const;
};

/// What of a collision that was measured is fitted: e and sticking, delta_max and t_max, or delta(t), v(t)
/// and F(t).
enum class Wanted { restitution, compression, motion };

struct ObservationSettings {
  Wanted wanted = Wanted::restitution;
  std::optional<double> radius;  ///< of the bodies of dumps [length]; else as RunOptions have it
  SweepOptions sweeping;         ///< of dumps
};

/// Reads tables (CSV: a line of names, then one line a collision; # begins a comment), motions, results of
/// `mdana collision` and `mdana compress` (JSON or HDF5), and dumps, which are measured as `mdana collision`
/// does with what their scenes say. Columns: e, sigma, outcome (bounce or stick; e empty or 0 is a
/// sticking collision, too), delta_max, delta_max_error, t_max, t_max_error, and parameters of the
/// laws by their names. Of `mdana compress` delta_max and t_max, with errors by the scatter of repeated
/// runs (fits/repeats.hpp). Motions are tables with columns time (or t) and delta, as `mdana force` and
/// `mdana collision` write them, and, if they are wanted, what dumps and HDF5 results have. Throws InputError
/// with file and line, and if there are motions and collisions.
Observations read_observations(std::span<const std::filesystem::path> files, const ObservationSettings& settings = {});

/// The collisions of one table.
std::vector<ObservedCollision> observed_collisions(const CsvText& table);

/// Whether a table is one of a motion, by its columns, and the collision that it shows. Columns: time or
/// t, delta, and where known v, F, delta_error, v_error, F_error; R, R1, R2, m, m1, m2, E ..., if they stand in
/// every row the same; others are not looked at.
bool is_motion(const CsvText& table);
ObservedCollision observed_motion(const CsvText& table, const std::string& place);

/// The collision of a dump. Throws InputError as prepare_run and measure_motion do, and if what is wanted
/// cannot be told.
struct ObservedDump {
  ObservedCollision seen;
  std::vector<InputRecord> records;
  std::string format;
};
ObservedDump observe_dump(const std::filesystem::path& dump, const ObservationSettings& settings);

/// The collisions that a document tells of, and the command that made it. Radii and masses as far as it
/// has them.
struct ObservedDocument {
  std::vector<ObservedCollision> seen;
  std::string command;
};
/// `rows` is the motion that stands beside the document, if it is wanted and there is one.
ObservedDocument parse_observed_document(std::string_view text, const std::string& place, Wanted wanted,
                                         const std::vector<MotionSample>& rows = {});

/// Fills m and E by R, and gamma, nu and spacing, where they are not given, from Yoshida, Kokubo &
/// Tanaka 2024 (fits/lj_particles.hpp), but not what is to stay free. Throws InputError with the place
/// of a radius that is none of theirs.
void fill_from_lj_particles(Observations& observations, std::span<const std::string> leave);

}  // namespace mdana
