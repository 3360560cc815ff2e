// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "readers/block.hpp"
#include "readers/columns.hpp"
#include "readers/frame.hpp"
#include "readers/selection.hpp"

namespace mdana {

/// Index of the body that an atom belongs to; 0 means none.
using BodyIndex = std::uint8_t;

/// Which atoms are particle 1, 2, ...: whole numbers (atom types, molecule numbers or ids) in
/// sorted runs, so that two bodies cost a few bytes however many atoms they have.
class Bodies {
 public:
  struct Run {
    std::int64_t first, last;  ///< inclusive
    BodyIndex body;
  };

  /// `column` is type, mol or id; the runs must be sorted and disjoint.
  Bodies(std::string column, std::vector<Run> runs, std::string rule);

  std::size_t count() const { return count_; }
  const std::string& rule() const { return rule_; }  ///< "type 1 and type 2", for the output
  ColumnSet columns() const { return {column_}; }

  /// The same atoms as other bodies: body b becomes `number[b - 1]`, 0 none.
  Bodies renumbered(std::span<const BodyIndex> number) const;

  /// Body of each atom of the block.
  void label(const AtomBlock& block, std::vector<BodyIndex>& body) const;

 private:
  std::string column_;
  std::vector<Run> runs_;
  std::string rule_;
  std::size_t count_ = 0;
};

/// Throws InputError unless the text is a rule for find_bodies.
void check_bodies_rule(const std::string& rule);

/// Bodies of a trajectory by a rule: `type`, `mol` (each value one body, ascending), `id:1-N` (the
/// second body is all other ids), `clusters` (connected atoms of the first frame, larger than 1 %
/// of the atoms, by lowest id), or empty: type if there are exactly two types, else mol, else
/// clusters. Reads the first frame, of which only selected atoms count. Throws InputError if the rule does not fit the dump.
Bodies find_bodies(const std::filesystem::path& dump, const FrameHeader& first,
                   const std::string& rule, const std::optional<Selection>& selection = {});

/// Clusters of a frame, counted from 0, as bodies: see `clusters` above. `header` is that of any frame of
/// the dump.
Bodies clusters_of_frame(const std::filesystem::path& dump, const FrameHeader& header,
                         std::uint64_t frame, const std::optional<Selection>& selection = {});

}  // namespace mdana
