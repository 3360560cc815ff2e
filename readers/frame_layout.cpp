// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/frame_layout.hpp"

#include "readers/input_error.hpp"

namespace mdana {

void FrameLayout::check(const Chunk& chunk, AtomBlock& block, BlockFaults& faults) const {
  try {
    convert(chunk, block);
  } catch (const InputError& error) {
    Fault fault;
    fault.kind = FaultKind::block;
    fault.what = error.what();
    faults.faults.add(std::move(fault));
    faults.all_unusable = true;
  }
}

AtomPlace place_of(const Chunk& chunk, std::size_t atom) {
  for (const Chunk& part : chunk.parts) {
    if (atom < part.atoms) return place_of(part, atom);
    atom -= part.atoms;
  }
  AtomPlace place = chunk.layout->first_place(chunk);
  (place.line ? place.line : place.atom) += atom;
  return place;
}

}  // namespace mdana
