// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "readers/frame.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

/// One frame that formats write each in their way, and what is known of it: step 5e9, a box of edges
/// a = (8, 0, 0), b = (2, 4, 0), c = (-1, 1, 16) from the corner (-4, -2, 0), whose bounding box goes
/// from -5 to 6, -2 to 3, 0 to 16; atom 7 at the scaled place (0.5, 0.25, 0.125), atom 3 at
/// (1, 1, 1) with image flags (1, 0, -2), in this order.
struct TiltedPair {
  FrameHeader header;
  std::vector<KnownAnswer> answers;

  void add(std::string what, double computed, double exact);  ///< to all digits
};

/// Reads the frame from a file with these bytes, which is gone afterwards.
TiltedPair read_tilted_pair(std::string_view bytes);

}  // namespace mdana
