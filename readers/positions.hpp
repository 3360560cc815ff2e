// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readers/block.hpp"
#include "readers/box.hpp"

namespace mdana {

/// How the positions x, y, z of a frame follow from the columns that it has.
struct PositionSource {
  std::array<std::string, 3> columns;  ///< xu.., xsu.., x.. or xs..
  bool scaled = false;                 ///< fractions of the box
  bool unwrapped = false;              ///< periodic images already added
  bool image_flags = false;            ///< ix iy iz to be added

  /// Positions may jump at periodic faces: wrapped, and no image flags to undo it.
  bool may_jump(const Box& box) const { return !unwrapped && !image_flags && box.any_periodic(); }
};

/// The most faithful source among the columns: unwrapped before wrapped, unscaled before scaled;
/// nothing if there are no positions.
std::optional<PositionSource> position_source(const std::vector<std::string>& columns);

/// Makes columns x, y, z of the block from the source's columns, which it must have.
void make_positions(const PositionSource& source, const Box& box, AtomBlock& block);

}  // namespace mdana
