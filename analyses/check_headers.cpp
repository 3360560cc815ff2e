// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/check_headers.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/file_set.hpp"

namespace mdana {

void HeaderCheck::tell(FaultKind kind, const FrameHeader& header, std::string what,
                       Faults& faults) const {
  Fault fault = located(kind, header.place, dump_);
  fault.what = std::move(what);
  fault.frame = header.index;
  fault.step = header.step;
  faults.add(std::move(fault));
}

void HeaderCheck::add(const FrameHeader& header, Faults& faults) {
  if (before_ && header.step <= before_->step)
    tell(FaultKind::step_order, header,
         fmt::format("step {} follows step {}", header.step, before_->step), faults);
  if (before_ && header.columns != before_->columns)
    tell(FaultKind::columns_change, header,
         fmt::format("the columns are {}, in the frame before {}", fmt::join(header.columns, " "),
                     fmt::join(before_->columns, " ")), faults);
  check_file(header, faults);
  check_time(header, faults);
  check_units(header, faults);
  before_ = header;
}

/// LAMMPS names a file of a set by the step of its first frame.
void HeaderCheck::check_file(const FrameHeader& header, Faults& faults) {
  const std::string file = located(FaultKind::file_step, header.place, dump_).file;
  if (file == std::exchange(file_, file)) return;
  const auto named = step_in_name(dump_, file);
  if (named && std::cmp_not_equal(*named, header.step))
    tell(FaultKind::file_step, header,
         fmt::format("the first step is {}, the file's name says {}", header.step, *named), faults);
}

void HeaderCheck::check_time(const FrameHeader& header, Faults& faults) {
  if (!with_time_) with_time_ = header.time.has_value();
  if (*with_time_ != header.time.has_value())
    tell(FaultKind::time_missing, header,
         header.time ? "the frame states its time, the first one does not"
                     : "the frame does not state its time, the first one does", faults);
  if (!header.time) return;
  if (!std::isfinite(*header.time))
    tell(FaultKind::not_finite, header, fmt::format("the time is {}", *header.time), faults);
  else if (time_ && *header.time <= *time_)
    tell(FaultKind::time_order, header, fmt::format("time {} follows time {}", *header.time, *time_),
         faults);
  if (std::isfinite(*header.time)) time_ = header.time;
}

/// LAMMPS states the units once a file.
void HeaderCheck::check_units(const FrameHeader& header, Faults& faults) {
  if (header.units && !units_) units_ = header.units;
  if (header.units != units_ && header.units)
    tell(FaultKind::units_change, header,
         fmt::format("units {}, in an earlier frame {}", name(*header.units), name(*units_)), faults);
}

void HeaderCheck::add_atoms(const FrameHeader& header, Faults& faults) {
  if (header.atoms == 0) tell(FaultKind::no_atoms, header, "a frame without atoms", faults);
  if (atoms_ && *atoms_ != header.atoms)
    tell(FaultKind::atoms_change, header,
         fmt::format("{} atoms, in the frame before {}", header.atoms, *atoms_), faults);
  atoms_ = header.atoms;
}

}  // namespace mdana
