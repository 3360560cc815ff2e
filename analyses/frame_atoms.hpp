// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "readers/block.hpp"
#include "readers/bodies.hpp"

namespace mdana {

/// Atoms of bodies 1 and 2 of a frame: 25 bytes an atom, 33 with ids, 4 more with types.
struct FrameAtoms {
  std::vector<double> x, y, z;        ///< [length], unwrapped as far as the dump allows
  std::vector<BodyIndex> body;        ///< 1, 2
  std::vector<std::int64_t> id;       ///< if the analyses' Needs have the column, else empty
  std::vector<std::int32_t> type;     ///< likewise

  std::size_t size() const { return body.size(); }
  void reserve(std::uint64_t atoms, bool ids, bool types);  ///< a hint, as a header says it
  void clear();                                             ///< keeps the memory
  /// Atoms of no or another body are left out.
  void add(const AtomBlock& block, std::span<const BodyIndex> bodies, bool ids, bool types);
  void sort_by_id();
  void reorder(const std::vector<std::uint32_t>& order);  ///< atom order[k] becomes the k-th

  template <class P>
  void pass(P& parcel) {
    parcel(x, y, z, body, id, type);
  }
};

}  // namespace mdana
