// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>

#include "readers/block.hpp"
#include "readers/faults.hpp"
#include "readers/frame.hpp"

namespace mdana {

/// Faults of single values that one entry a column stands for: how many, and the first of them.
class ColumnFaults {
 public:
  void add(Fault fault);                 ///< another one of its kind and column
  void add(const ColumnFaults& later);
  void settle(std::uint64_t frame, std::int64_t step, std::string_view file);
  void tell(Faults& faults) const;

 private:
  std::map<std::pair<FaultKind, std::string>, Fault> first_;
};

/// What is wrong with the values of a block whose words are right: types and masses (one fault an
/// atom), values that are not finite and positions far outside a periodic box (one a column).
void check_values(const FrameHeader& header, const Chunk& chunk, const AtomBlock& block,
                  BlockFaults& faults, ColumnFaults& of_columns);

/// A fault at an atom of the chunk; its frame and step, and the file if the layout does not know
/// it, are left open.
Fault fault_at(FaultKind kind, const Chunk& chunk, std::size_t atom, std::string what,
               std::string column = {});

}  // namespace mdana
