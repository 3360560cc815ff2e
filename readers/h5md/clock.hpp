// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "readers/hdf5.hpp"

namespace mdana::h5md {

/// The `step` and `time` of a time-dependent element: a number a frame, or an increment and an
/// offset.
class Clock {
 public:
  /// Throws InputError if the element has no `step` or a wrong one.
  explicit Clock(const hdf5::Group& element);

  std::int64_t step(std::uint64_t frame) const;
  std::optional<double> time(std::uint64_t frame) const;

  /// How many frames have a step (and a time, if any has); nothing if they are increments.
  std::optional<std::uint64_t> frames() const { return frames_; }

 private:
  std::uint64_t length(const hdf5::Dataset& dataset);

  hdf5::Dataset step_;
  std::optional<hdf5::Dataset> time_;
  std::optional<std::uint64_t> frames_;
};

}  // namespace mdana::h5md
