// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "analyses/sweep.hpp"
#include "analyses/table.hpp"
#include "analyses/value.hpp"
#include "readers/units.hpp"
#include "reports/run.hpp"

namespace mdana {

/// "12.34 ± 0.05 ε/σ": as many digits as the error leaves, or six without an error; "not determined"
/// for NaN.
std::string to_text(const Value& value, Units units);

/// The value in SI; its dimension must not be none.
Value in_si(const Value& value, const PhysicalUnits& material);

/// A published number and its name.
struct PublishedValue {
  std::string name;
  Value value;
};

/// A table besides the one that a command makes.
struct FurtherTable {
  std::string group, name;
  Table table;
};

/// The result of a command: one JSON document, and the same as lines for a terminal. A name with
/// dots ("contact_radius.gyration.max") makes nested objects.
class Document {
 public:
  /// Starts with command, mdana_version and inputs.
  explicit Document(std::string_view command);
  /// Besides, the units, scene, bodies and masses of a run, and its warnings.
  Document(std::string_view command, const Run& run);

  /// {value, error}, in a material also {si: {value, error, unit}}; then the details, an object.
  void number(std::string_view name, const Value& value, const nlohmann::ordered_json& details = {});
  void text(std::string_view name, const std::string& value);
  void json(std::string_view name, nlohmann::ordered_json value);  ///< not shown on a terminal
  void line(std::string label, std::string text);                  ///< shown on a terminal only
  void further_table(FurtherTable table) { tables_.push_back(std::move(table)); }  ///< for sinks that hold all tables

  void warn(std::string warning);
  void left_out(std::string what, std::string reason);

  void input(const InputRecord& file, std::string_view format);
  void damage(const std::string& what);  ///< a warning, and `damaged`

  /// Adds what a sweep says of itself: input, seconds, damage and other warnings.
  void sweep(const SweepResult& swept, std::string_view format);

  Units units() const { return units_; }  ///< of the numbers
  void set_units(Units units);            ///< of several runs; throws InputError if they differ
  bool damaged() const { return damaged_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  const std::vector<PublishedValue>& numbers() const { return numbers_; }  ///< in the order of `number`

  const std::vector<FurtherTable>& further_tables() const { return tables_; }

  std::string to_json() const;      ///< indented, one trailing newline
  std::string to_terminal() const;  ///< aligned lines, then warnings
  nlohmann::ordered_json content() const;

 private:
  void physical(const PhysicalUnits& material);

  Units units_ = Units::lj;  ///< of the numbers
  std::optional<PhysicalUnits> physical_;
  nlohmann::ordered_json root_;
  std::vector<std::pair<std::string, std::string>> lines_;
  std::vector<std::string> warnings_;
  std::vector<PublishedValue> numbers_;
  std::vector<FurtherTable> tables_;
  bool damaged_ = false;
};

/// Indented, with a line end; bytes of names that are not UTF-8 are replaced by U+FFFD.
std::string to_text(const nlohmann::ordered_json& json);

/// {"value": ..., "error": ... or null}.
nlohmann::ordered_json to_json(const Value& value);

}  // namespace mdana
