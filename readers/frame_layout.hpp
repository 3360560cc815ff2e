// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "readers/block.hpp"
#include "readers/faults.hpp"
#include "readers/frame.hpp"

namespace mdana {

/// How decimal text shows the numbers of a column.
struct PrintedPrecision {
  int digits = 0;      ///< significant digits at most; 0 if the column is not decimal fractions
  int decimals = 0;    ///< digits behind the point at most
  bool fixed = false;  ///< every number has as many decimals (as by %.6f), else digits count (%.10g)
};

/// Where an atom stands.
struct AtomPlace {
  std::string file;        ///< empty: as the frame's header says
  std::uint64_t line = 0;  ///< from 1; 0 where a file has no lines
  std::uint64_t atom = 0;  ///< from 1 in the frame of its file; 0 where lines are told
};

/// What the atoms of one frame look like in its file: turns the frame's chunks into blocks. It needs
/// nothing but the chunk, so any thread may use it while the source goes on to other frames.
class FrameLayout {
 public:
  virtual ~FrameLayout() = default;

  /// Fills the wanted columns, and no others. Throws InputError naming line and column.
  virtual void convert(const Chunk& chunk, AtomBlock& block) const = 0;

  /// Fills the wanted columns as far as that is possible and tells everything that is wrong. By
  /// default what `convert` throws is one fault, and then no atom of the chunk is usable. The
  /// faults' frame and step are the caller's to state; a fault without a file has its place in its
  /// text, as InputError does.
  virtual void check(const Chunk& chunk, AtomBlock& block, BlockFaults& faults) const;

  /// Where the chunk's first atom stands; the others follow, a line or an atom each.
  virtual AtomPlace first_place(const Chunk& chunk) const { return {{}, 0, chunk.first_line}; }

  /// How the numbers of a column are printed, estimated from the chunk; by default as exact bits.
  virtual PrintedPrecision printed_precision(const Chunk&, std::string_view) const { return {}; }
};

inline void convert(const Chunk& chunk, AtomBlock& block) { chunk.layout->convert(chunk, block); }

/// Where an atom of the chunk stands, also in one of its parts.
AtomPlace place_of(const Chunk& chunk, std::size_t atom);

}  // namespace mdana
