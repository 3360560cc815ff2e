// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "readers/faults.hpp"
#include "readers/frame.hpp"

namespace mdana {

/// What does not fit between the headers of a trajectory's frames.
class HeaderCheck {
 public:
  explicit HeaderCheck(std::string dump) : dump_(std::move(dump)) {}

  /// The next frame: its step, time, units and columns.
  void add(const FrameHeader& header, Faults& faults);

  /// The number of atoms of the last frame, if it was whole.
  void add_atoms(const FrameHeader& header, Faults& faults);

 private:
  void tell(FaultKind kind, const FrameHeader& header, std::string what, Faults& faults) const;
  void check_time(const FrameHeader& header, Faults& faults);
  void check_file(const FrameHeader& header, Faults& faults);
  void check_units(const FrameHeader& header, Faults& faults);

  std::string dump_;
  std::optional<FrameHeader> before_;
  std::string file_;               ///< that the last frame stands in
  std::optional<bool> with_time_;  ///< the first frame states its time
  std::optional<double> time_;     ///< stated last
  std::optional<Units> units_;     ///< stated first
  std::optional<std::uint64_t> atoms_;
};

}  // namespace mdana
