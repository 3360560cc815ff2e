// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace mdana {

/// Which frames of a trajectory are used: first, first + stride, ... before end.
struct FrameChoice {
  std::uint64_t first = 0;
  std::optional<std::uint64_t> end;  ///< nothing: to the last
  std::uint64_t stride = 1;          ///< at least 1

  /// The chosen frame at or after `index`; nothing if there is none.
  std::optional<std::uint64_t> at_or_after(std::uint64_t index) const;
};

/// "FIRST:END" or "FIRST:END:STRIDE", each part may be empty: "100:", ":50", "::10", "20:30".
/// Throws InputError.
FrameChoice parse_frame_choice(const std::string& text);

}  // namespace mdana
