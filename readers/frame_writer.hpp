// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "readers/block.hpp"
#include "readers/frame.hpp"

namespace mdana {

/// Writes a trajectory, frame by frame, blocks of atoms in their order.
class FrameWriter {
 public:
  virtual ~FrameWriter() = default;

  /// Begins a frame; `header.columns` are written, in their order, as they stand in the blocks (each
  /// by its kind_of_column). Throws InputError if the format cannot hold the frame, std::runtime_error
  /// if writing fails; so do the others.
  virtual void begin(const FrameHeader& header) = 0;
  virtual void add(const AtomBlock& block) = 0;

  /// Ends the file after its last frame; without it the file is not whole.
  virtual void finish() = 0;
};

}  // namespace mdana
