// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mdana {

enum class Severity { error, note };

/// What can be wrong with a dump, or worth a look.
enum class FaultKind {
  word,
  not_whole,
  line,
  block,
  header,
  atom_count,
  truncated,
  duplicate_id,
  not_finite,
  type,
  mass,
  step_order,
  time_order,
  time_missing,
  units_change,
  outside_box,
  atoms_change,
  columns_change,
  file_step,
  ids_lost,
  ids_gained,
  ids_unchecked,
  no_atoms,
};

struct FaultKindWords {
  FaultKind kind;
  std::string_view name;  ///< "duplicate_id"
  Severity severity;
  std::string_view meaning;
};

/// All kinds in their order.
std::span<const FaultKindWords> fault_kinds();
const FaultKindWords& words_of(FaultKind kind);

/// One fault and its place, as far as that is known.
struct Fault {
  FaultKind kind = FaultKind::word;
  std::string what;
  std::string file;
  std::optional<std::uint64_t> line;   ///< from 1
  std::optional<std::uint64_t> atom;   ///< from 1 in its frame, where a file has no lines
  std::optional<std::uint64_t> frame;  ///< from 0
  std::optional<std::int64_t> step;
  std::string column;
  std::uint64_t times = 1;  ///< values that it stands for; its place is that of the first
};

/// Faults in the order in which they were met: all are counted, the first few of each kind kept.
class Faults {
 public:
  explicit Faults(std::size_t limit = 20) : limit_(limit) {}

  void add(Fault fault);

  /// Those of another list behind these; the other's limit must not be smaller.
  void add(const Faults& later);

  std::uint64_t count(FaultKind kind) const { return counts_[static_cast<std::size_t>(kind)]; }
  std::uint64_t count(Severity severity) const;
  const std::vector<Fault>& kept() const { return kept_; }
  std::size_t limit() const { return limit_; }

  /// States frame and step of those that do not, and the file (and line) of those without one: out
  /// of their text if it begins with them, else it is the dump.
  void settle(std::uint64_t frame, std::int64_t step, std::string_view dump);

 private:
  static constexpr std::size_t kinds = static_cast<std::size_t>(FaultKind::no_atoms) + 1;

  std::size_t limit_;
  std::vector<Fault> kept_;
  std::array<std::uint64_t, kinds> counts_{};
  std::array<std::size_t, kinds> kept_of_{};
};

/// What is wrong with one block of atoms.
struct BlockFaults {
  explicit BlockFaults(std::size_t limit = 20) : faults(limit) {}

  Faults faults;
  std::vector<bool> unusable;  ///< atoms whose numbers in the block mean nothing; empty: none
  bool all_unusable = false;   ///< the block may even lack columns

  void reset();
  bool usable(std::size_t atom) const {
    return !all_unusable && (unusable.empty() || !unusable[atom]);
  }
  bool whole() const { return !all_unusable && unusable.empty(); }
  void spoil(std::size_t atom, std::size_t atoms);  ///< makes one of the block's atoms unusable
};

/// A fault out of a message "file:line: what" or "file: what" about a dump of that name (which may
/// stand for a set of files).
Fault located(FaultKind kind, std::string_view message, std::string_view dump);

}  // namespace mdana
