// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/column_choice.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "readers/shown.hpp"

namespace mdana {
namespace {

bool is_position(const std::string& name) { return name == "x" || name == "y" || name == "z"; }

}  // namespace

ColumnChoice::ColumnChoice(const FrameHeader& frame, const ColumnSet& wanted) : box_(frame.box) {
  const bool positions = !wanted.as_they_stand();  // x, y, z stand for them
  if (positions && std::ranges::any_of(wanted.names(), is_position)) add_positions(frame);
  const bool all = wanted.as_they_stand() && wanted.empty();
  for (const std::string& name : all ? frame.columns : wanted.names())
    if (!positions || !is_position(name)) add(frame, name);
  if (wanted.selection()) {
    selection_ = *wanted.selection();
    add(frame, selection_->column());
  }
  std::ranges::sort(columns_, {}, &Column::in_file);
}

void ColumnChoice::add_positions(const FrameHeader& frame) {
  positions_ = position_source(frame.columns);
  if (!positions_)
    throw InputError(fmt::format("{}: no position columns (x y z, xs, xu or xsu)", frame.place));
  for (const std::string& name : positions_->columns) add(frame, name);
  if (positions_->image_flags)
    for (const char* name : {"ix", "iy", "iz"}) add(frame, name);
}

void ColumnChoice::add(const FrameHeader& frame, const std::string& name) {
  const auto it = std::ranges::find(frame.columns, name);
  if (it == frame.columns.end())
    throw InputError(fmt::format("{}: this frame has no column '{}'; it has {}", frame.place, name,
                                 shown(fmt::format("{}", fmt::join(frame.columns, " ")), 1000)));
  const auto in_file = static_cast<std::size_t>(it - frame.columns.begin());
  if (std::ranges::find(columns_, in_file, &Column::in_file) == columns_.end())
    columns_.push_back({in_file, name, kind_of_column(name)});
}

void ColumnChoice::finish(AtomBlock& block) const {
  if (selection_) selection_->apply(block);
  if (positions_) make_positions(*positions_, box_, block);
}

}  // namespace mdana
