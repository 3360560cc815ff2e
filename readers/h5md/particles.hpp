// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "readers/column_choice.hpp"
#include "readers/frame.hpp"
#include "readers/h5md/box.hpp"
#include "readers/h5md/element.hpp"

namespace mdana::h5md {

/// An element with a value, or a few, for each atom, and the columns that they are.
struct AtomElement {
  Element element;
  std::vector<std::string> columns;
};

/// A group of particles of an H5MD file.
class Particles {
 public:
  /// Throws InputError if there is none, or more than one and none called "all".
  explicit Particles(const hdf5::Group& file);

  const std::string& place() const { return group_.place(); }
  std::uint64_t rows() const { return rows_; }  ///< places for atoms in a frame
  const std::vector<AtomElement>& elements() const { return elements_; }
  const AtomElement& position() const { return elements_[position_]; }

  /// Step, time, box, units and columns of a frame; all atoms.
  FrameHeader header(std::uint64_t frame) const;

  /// The value of `id` where there is no atom, if the file declares one.
  std::optional<std::int64_t> absent() const;
  const Element& id() const;

  /// How many frames are there of everything that these elements and the box need, and of what has
  /// most.
  struct Frames {
    std::uint64_t whole, begun;
  };
  Frames frames(const std::vector<const Element*>& needed) const;

  /// Throws InputError if the element's step differs from that of the positions.
  void check_step(const Element& element, std::uint64_t frame, std::int64_t step) const;

  const BoxReader& box() const { return box_; }

 private:
  void add(const std::string& name);

  hdf5::Group group_;
  BoxReader box_;
  std::optional<Units> units_;
  std::vector<AtomElement> elements_;
  std::size_t position_ = 0;
  std::uint64_t rows_ = 0;
};

}  // namespace mdana::h5md
