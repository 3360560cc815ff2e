// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/chosen_frames.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {

bool ChosenFrames::at(std::uint64_t place, FrameHeader& header) {
  if (options_.frames && place >= *options_.frames) return false;
  std::uint64_t index = 0;
  for (; next_ <= place; ++next_) {
    const auto chosen = options_.choice.at_or_after(seen_);
    if (!chosen) return false;
    index = *chosen;
    seen_ = index + 1;
  }
  source_.seek(index);
  do {
    if (!source_.next(header)) return false;
  } while (header.index < index);
  seen_ = header.index + 1;
  return true;
}

double ChosenFrames::left(std::uint64_t place, double share, double a_frame) const {
  double left = a_frame > 0 ? (1 - share) / a_frame + 1 : std::numeric_limits<double>::infinity();
  const auto at_most = [&](std::uint64_t all) { left = std::min(left, static_cast<double>(all - std::min(all, place))); };
  const FrameChoice& choice = options_.choice;
  if (choice.end) at_most((*choice.end - std::min(*choice.end, choice.first)) / choice.stride + 1);
  if (options_.frames) at_most(*options_.frames);
  return left;
}

void FrameAgreement::see(const FrameHeader& header) {
  if (step_ && header.index == index_) return;
  if (step_ && header.step <= *step_)
    throw InputError(fmt::format("{}: the step does not come after that of the frame before ({})", header.place, *step_));
  if (step_ && header.time.has_value() != timed_)
    throw InputError(fmt::format("{}: some frames state their time and some do not", header.place));
  if (header.units && !units_) units_ = header.units;  // LAMMPS states them once a file
  if (header.units && header.units != units_)
    throw InputError(fmt::format("{}: the units differ from those of an earlier frame", header.place));
  index_ = header.index;
  step_ = header.step;
  timed_ = header.time.has_value();
}

}  // namespace mdana
