// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "readers/h5md/clock.hpp"
#include "readers/hdf5.hpp"

namespace mdana::h5md {

/// An element of H5MD: a dataset that holds for all frames, or a group of step, time and value.
class Element {
 public:
  /// Nothing if the object of that name is neither.
  static std::optional<Element> find(const hdf5::Group& parent, const std::string& name);

  const std::string& name() const { return name_; }
  const std::string& place() const { return value_.place(); }
  bool time_dependent() const { return clock_.has_value(); }
  const Clock& clock() const { return *clock_; }
  const hdf5::Dataset& value() const { return value_; }

  hdf5::Shape shape() const;                     ///< of one frame
  std::optional<std::uint64_t> frames() const;   ///< of the values; nothing if they are fixed
  std::string columns_attribute() const { return columns_; }

  /// Numbers in one frame of the given first axis: all of them if it is that of a small element.
  hdf5::Slab slab(std::uint64_t frame, std::uint64_t first, std::uint64_t count) const;

  /// Throws TruncatedInput if the values of rows first and last of the frame were never written.
  void check_stored(std::uint64_t frame, std::uint64_t first, std::uint64_t last) const;

 private:
  Element(std::string name, hdf5::Dataset value) : name_(std::move(name)), value_(std::move(value)) {}

  std::string name_;
  std::string columns_;  ///< names that mdana wrote, else empty
  hdf5::Dataset value_;
  std::optional<Clock> clock_;
};

}  // namespace mdana::h5md
