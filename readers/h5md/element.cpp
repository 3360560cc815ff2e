// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/h5md/element.hpp"

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::h5md {

std::optional<Element> Element::find(const hdf5::Group& parent, const std::string& name) {
  if (parent.has_dataset(name)) return Element(name, parent.dataset(name));
  if (!parent.has_group(name)) return std::nullopt;
  const hdf5::Group group = parent.group(name);
  if (!group.has_dataset("value")) return std::nullopt;
  Element element(name, group.dataset("value"));
  if (element.value_.shape().empty())
    throw InputError(fmt::format("{}: values of frames expected, not one number", element.place()));
  element.clock_.emplace(group);
  if (const auto names = group.texts("mdana_columns"); names.size() == 1)
    element.columns_ = names.front();
  return element;
}

hdf5::Shape Element::shape() const {
  hdf5::Shape shape = value_.shape();
  if (time_dependent()) shape.erase(shape.begin());
  return shape;
}

std::optional<std::uint64_t> Element::frames() const {
  if (!time_dependent()) return std::nullopt;
  return value_.shape().front();
}

hdf5::Slab Element::slab(std::uint64_t frame, std::uint64_t first, std::uint64_t count) const {
  hdf5::Slab slab{hdf5::Shape(value_.shape().size(), 0), value_.shape()};
  std::size_t axis = 0;
  if (time_dependent()) {
    slab.first[0] = frame;
    slab.count[0] = 1;
    axis = 1;
  }
  slab.first[axis] = first;
  slab.count[axis] = count;
  return slab;
}

void Element::check_stored(std::uint64_t frame, std::uint64_t first, std::uint64_t last) const {
  for (const std::uint64_t row : {first, last})
    if (!value_.stored(slab(frame, row, 1).first))
      throw TruncatedInput(fmt::format("{}: the values of frame {}, atom {}, were never written",
                                       place(), frame, row + 1));
}

}  // namespace mdana::h5md
