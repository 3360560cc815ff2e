// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "readers/scene.hpp"
#include "reports/study/cache.hpp"

namespace mdana {

/// A run of a study as the report has it, without its tables.
struct ReportedRun {
  std::string name, group;
  std::string file;                 ///< name of its files
  Scene scene;
  std::string failure;              ///< why there is no result; else empty
  bool left_out = false;            ///< it was not asked for, and has no result yet
  nlohmann::ordered_json document;
  std::vector<PublishedValue> numbers;

  bool measured() const { return failure.empty(); }
  bool aggregate() const { return scene.interaction == Interaction::aggregate; }
  const Value* number(std::string_view name) const;
  bool weak(std::string_view name) const;  ///< the printed digits of the dump fix fewer than three of it
  std::string text(const char* name) const;  ///< of the document; empty if there is none
  Units units() const;                       ///< of a measured run
  double velocity() const;                   ///< as generated, else as measured before contact; NaN if unknown
};

/// A row a run: name, group, interaction, state, outcome, radius, velocity, seed, orientations, all
/// published numbers with their errors, the dump, its hash, the program. Dimensions are those of the numbers.
Table runs_table(std::span<const ReportedRun* const> runs);

/// A row a group and velocity of spheres that bounced or stuck: RMS e, its error and spread, sticking
/// probability with Wilson's 95 % limits.
Table velocities_table(std::span<const ReportedRun* const> runs);

/// The rows of a table whose label in a column is that one.
Table rows_with(const Table& table, const std::string& column, const std::string& label);

}  // namespace mdana
