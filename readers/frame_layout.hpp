// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "readers/block.hpp"
#include "readers/frame.hpp"

namespace mdana {

/// How decimal text shows the numbers of a column.
struct PrintedPrecision {
  int digits = 0;      ///< significant digits at most; 0 if the column is not decimal fractions
  int decimals = 0;    ///< digits behind the point at most
  bool fixed = false;  ///< every number has as many decimals (as by %.6f), else digits count (%.10g)
};

/// What the atoms of one frame look like in its file: turns the frame's chunks into blocks. It needs
/// nothing but the chunk, so any thread may use it while the source goes on to other frames.
class FrameLayout {
 public:
  virtual ~FrameLayout() = default;

  /// Fills the wanted columns, and no others. Throws InputError naming line and column.
  virtual void convert(const Chunk& chunk, AtomBlock& block) const = 0;

  /// How the numbers of a column are printed, estimated from the chunk; by default as exact bits.
  virtual PrintedPrecision printed_precision(const Chunk&, std::string_view) const { return {}; }
};

inline void convert(const Chunk& chunk, AtomBlock& block) { chunk.layout->convert(chunk, block); }

}  // namespace mdana
