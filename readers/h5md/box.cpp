// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/h5md/box.hpp"

#include <cmath>

#include <Eigen/LU>
#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::h5md {
namespace {

std::array<bool, 3> periodicity(const hdf5::Group& box) {
  const auto boundary = box.texts("boundary");
  if (boundary.size() != 3)
    throw InputError(fmt::format("{}: the attribute 'boundary' must have three words", box.place()));
  std::array<bool, 3> periodic{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (boundary[k] != "periodic" && boundary[k] != "none")
      throw InputError(fmt::format("{}: boundary '{}' (periodic or none expected)", box.place(),
                                   boundary[k]));
    periodic[k] = boundary[k] == "periodic";
  }
  return periodic;
}

std::vector<double> numbers(const Element& element, std::uint64_t frame) {
  std::size_t count = 1;
  for (const auto n : element.shape()) count *= static_cast<std::size_t>(n);
  element.check_stored(frame, 0, 0);
  std::vector<double> values(count);
  element.value().read(element.slab(frame, 0, 3), values);
  for (const double value : values)
    if (!std::isfinite(value))
      throw InputError(fmt::format("{}: {} in frame {}", element.place(), value, frame));
  return values;
}

}  // namespace

BoxReader::BoxReader(const hdf5::Group& particles) {
  const hdf5::Group box = particles.group("box");
  if (const auto d = box.integers("dimension"); d.size() != 1 || d.front() != 3)
    throw InputError(fmt::format("{}: the attribute 'dimension' must be 3", box.place()));
  periodic_ = periodicity(box);
  edges_ = Element::find(box, "edges");
  origin_ = Element::find(box, "origin");
  if (!edges_ && (periodic_[0] || periodic_[1] || periodic_[2]))
    throw InputError(fmt::format("{}: periodic, but there are no 'edges'", box.place()));
  if (edges_ && edges_->shape() != hdf5::Shape{3} && edges_->shape() != hdf5::Shape{3, 3})
    throw InputError(fmt::format("{}: three lengths or three vectors expected", edges_->place()));
  if (origin_ && origin_->shape() != hdf5::Shape{3})
    throw InputError(fmt::format("{}: three coordinates expected", origin_->place()));
}

std::vector<const Element*> BoxReader::elements() const {
  std::vector<const Element*> all;
  for (const auto* element : {&edges_, &origin_})
    if (*element) all.push_back(&**element);
  return all;
}

Box BoxReader::box(std::uint64_t frame) const {
  Box box;
  box.periodic = periodic_;
  if (origin_) box.origin = Eigen::Map<const Eigen::Vector3d>(numbers(*origin_, frame).data());
  if (!edges_) return box;
  const std::vector<double> values = numbers(*edges_, frame);
  if (values.size() == 3)
    box.edges = Eigen::Map<const Eigen::Vector3d>(values.data()).asDiagonal();
  else  // a row of the file is an edge, and a column here
    box.edges = Eigen::Map<const Eigen::Matrix3d>(values.data());
  if (!(std::abs(box.edges.determinant()) > 0))
    throw InputError(fmt::format("{}: the edges of frame {} are no box", edges_->place(), frame));
  return box;
}

}  // namespace mdana::h5md
