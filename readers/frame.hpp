// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readers/box.hpp"
#include "readers/units.hpp"

namespace mdana {

/// What a frame says of itself before its atoms.
struct FrameHeader {
  std::uint64_t index = 0;        ///< 0, 1, 2 ... in the trajectory
  std::int64_t step = 0;          ///< time step
  std::optional<double> time;     ///< [time], if the dump states it
  std::optional<Units> units;     ///< if the dump states them
  std::uint64_t atoms = 0;
  Box box;
  std::vector<std::string> columns;  ///< as the dump names them, in its order
  std::string place;                 ///< "file:line (frame i, step n)" for messages

  bool has_column(std::string_view name) const;

  /// The members, for other ranks; see analyses/parcel.hpp.
  template <class P>
  void pass(P& parcel) {
    parcel(index, step, time, units, atoms, box, columns, place);
  }
};

class FrameLayout;

/// Bytes of one block of atoms as they stand in the file, before conversion.
struct Chunk {
  /// Readable bytes behind every chunk, so that converters may load whole vector registers.
  static constexpr std::size_t padding = 256;

  std::uint64_t number = 0;      ///< the block's number in its frame
  std::size_t atoms = 0;
  std::uint64_t first_line = 0;  ///< where it starts, for messages
  std::string_view bytes;        ///< of the mapped file, or of `storage`
  std::vector<char> storage;

  std::shared_ptr<const FrameLayout> layout;  ///< of the frame
  std::shared_ptr<const void> file;           ///< what keeps the file open, if the source does not
  std::vector<Chunk> parts;  ///< of a frame in several files: what each gives, bytes are theirs
};

}  // namespace mdana
