// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "readers/column_choice.hpp"
#include "readers/frame_layout.hpp"
#include "readers/h5md/particles.hpp"

namespace mdana::h5md {

/// What a chunk holds, element after element, and which columns of a block it becomes.
class AtomLayout final : public FrameLayout {
 public:
  static constexpr std::size_t text_bytes = 32;  ///< room for a text in a chunk

  /// One element as chunks hold it: an atom's numbers of eight bytes, or its text, side by side.
  struct Part {
    const Element* element;  ///< for reading; not used by `convert`
    std::string place;
    ColumnKind kind;
    std::size_t components;

    std::size_t bytes_of_atom() const {
      return components * (kind == ColumnKind::text ? text_bytes : sizeof(double));
    }
  };

  /// Throws InputError if the frame lacks a wanted column, or holds it as another kind.
  AtomLayout(const FrameHeader& header, const Particles& particles, const ColumnSet& wanted);

  const std::vector<Part>& parts() const { return parts_; }
  std::size_t bytes_of_atom() const;

  void convert(const Chunk& chunk, AtomBlock& block) const override;

 private:
  struct Target {
    std::size_t part, component;
    std::string name;
  };
  std::size_t part_of(const AtomElement& element, ColumnKind kind);

  ColumnChoice choice_;
  std::vector<Part> parts_;
  std::vector<Target> targets_;
};

}  // namespace mdana::h5md
