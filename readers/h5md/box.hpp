// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "readers/box.hpp"
#include "readers/h5md/element.hpp"

namespace mdana::h5md {

/// The group `box` of a group of particles.
class BoxReader {
 public:
  /// Throws InputError if the group lacks what H5MD demands, or is not three-dimensional.
  explicit BoxReader(const hdf5::Group& particles);

  /// Edges and origin, as far as they are there.
  std::vector<const Element*> elements() const;

  Box box(std::uint64_t frame) const;

 private:
  std::array<bool, 3> periodic_{};
  std::optional<Element> edges_, origin_;
};

}  // namespace mdana::h5md
