// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "readers/block.hpp"
#include "readers/faults.hpp"
#include "readers/frame.hpp"
#include "readers/frame_layout.hpp"

namespace mdana {

/// Ids that stand twice in a frame, and those lost and gained since the first whole frame, which is
/// the reference. Frames that are not whole are looked at for duplicates only.
class IdCheck {
 public:
  /// `memory` in bytes; a frame that needs more is not compared, which is a note.
  IdCheck(std::size_t memory, std::string dump) : memory_(memory), dump_(std::move(dump)) {}

  void begin();
  /// Blocks in their order. What is met at once is told in `faults`.
  void add(const Chunk& chunk, const AtomBlock& block, BlockFaults& faults);
  void end(const FrameHeader& header, bool whole, Faults& faults);

  bool compared() const { return compared_; }

 private:
  struct Met {
    std::int64_t id;
    std::uint64_t atom;  ///< in the frame
  };
  struct Stretch {
    std::uint64_t first;
    AtomPlace place;
  };

  void add_id(std::int64_t id, const Chunk& chunk, std::size_t atom, BlockFaults& faults);
  bool in_reference(std::int64_t id, std::size_t& at) const;
  void remember_places(const Chunk& chunk);
  Fault at_frame(FaultKind kind, const FrameHeader& header, std::string what) const;
  void tell_duplicates(const FrameHeader& header, Faults& faults);
  void settle_place(std::uint64_t atom, Fault& fault) const;
  void compare(const FrameHeader& header, Faults& faults);
  void adopt();
  std::size_t bytes() const;

  std::size_t memory_;
  std::string dump_;
  std::vector<std::int64_t> reference_;  ///< ascending
  bool has_reference_ = false;
  bool compared_ = false;
  bool told_too_many_ = false;

  std::vector<bool> seen_;  ///< of the reference, in this frame
  std::vector<Met> others_;
  std::vector<Stretch> places_;
  std::uint64_t atoms_ = 0;  ///< of this frame so far
  bool too_many_ = false;
  bool any_unusable_ = false;
};

}  // namespace mdana
