// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/h5md/clock.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::h5md {
namespace {

template <class T>
T one(const hdf5::Dataset& dataset, const hdf5::Shape& place) {
  T value{};
  dataset.read({place, hdf5::Shape(place.size(), 1)}, std::span(&value, 1));
  return value;
}

template <class T>
T of_frame(const hdf5::Dataset& dataset, std::uint64_t frame) {
  if (!dataset.stored({frame}))
    throw TruncatedInput(fmt::format("{}: the value of frame {} was never written",
                                     dataset.place(), frame));
  return one<T>(dataset, {frame});
}

template <class T>
T offset(const std::vector<T>& values) {
  return values.empty() ? T{} : values.front();
}

}  // namespace

Clock::Clock(const hdf5::Group& element) : step_(element.dataset("step")) {
  if (step_.kind() != hdf5::Kind::integer)
    throw InputError(fmt::format("{}: whole numbers expected", step_.place()));
  length(step_);
  if (!element.has_dataset("time")) return;
  time_ = element.dataset("time");
  length(*time_);
}

/// Takes note of the length of a dataset, which may be a scalar.
std::uint64_t Clock::length(const hdf5::Dataset& dataset) {
  const hdf5::Shape shape = dataset.shape();
  if (shape.size() > 1)
    throw InputError(fmt::format("{}: one number a frame expected", dataset.place()));
  if (shape.size() == 1) frames_ = std::min(frames_.value_or(shape[0]), shape[0]);
  return frames_.value_or(0);
}

std::int64_t Clock::step(std::uint64_t frame) const {
  if (step_.shape().size() == 1) return of_frame<std::int64_t>(step_, frame);
  std::int64_t result = 0;
  if (__builtin_mul_overflow(one<std::int64_t>(step_, {}), frame, &result) ||
      __builtin_add_overflow(result, offset(step_.integers("offset")), &result))
    throw InputError(fmt::format("{}: the step of frame {} is not below 2^63", step_.place(), frame));
  return result;
}

std::optional<double> Clock::time(std::uint64_t frame) const {
  if (!time_) return std::nullopt;
  const double time = time_->shape().size() == 1
                          ? of_frame<double>(*time_, frame)
                          : one<double>(*time_, {}) * static_cast<double>(frame) +
                                offset(time_->reals("offset"));
  if (!std::isfinite(time))
    throw InputError(fmt::format("{}: the time of frame {} is {}", time_->place(), frame, time));
  return time;
}

}  // namespace mdana::h5md
