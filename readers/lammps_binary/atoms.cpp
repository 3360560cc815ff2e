// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/lammps_binary/atoms.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "readers/lammps_binary/byte_order.hpp"

namespace mdana::lammps_binary {
namespace {

constexpr std::size_t atoms_at_once = 256;  ///< whose numbers stay in the processor's cache

/// Beyond it doubles do not tell whole numbers apart.
constexpr double largest_whole = 0x1p53;

/// One number of each of several atoms, `stride` bytes apart.
struct Strided {
  const char* first;
  std::size_t stride;
  bool swapped;

  double operator[](std::size_t i) const { return load<double>(first + i * stride, swapped); }
};

void copy_real(const Strided& from, std::span<double> to) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i];
}

/// How many are whole numbers before the first that is not; all are converted if that is none.
std::size_t copy_whole(const Strided& from, std::span<std::int64_t> to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    const double value = from[i];
    const double in_range = std::abs(value) <= largest_whole ? value : 0.5;  // NaN is not either
    to[i] = static_cast<std::int64_t>(in_range);
    if (static_cast<double>(to[i]) != in_range) return i;
  }
  return to.size();
}

}  // namespace

AtomLayout::AtomLayout(const Header& header, const ColumnSet& wanted)
    : columns_(header.frame.columns.size()),
      swapped_(header.swapped),
      box_(header.frame.box),
      place_(header.frame.place) {
  positions_wanted_ = wanted.has("x") || wanted.has("y") || wanted.has("z");
  if (positions_wanted_) {
    const auto source = position_source(header.frame.columns);
    if (!source)
      throw InputError(fmt::format("{}: no position columns (x y z, xs, xu or xsu)", place_));
    positions_ = *source;
    for (const std::string& name : positions_.columns) add(header.frame, name);
    if (positions_.image_flags)
      for (const char* name : {"ix", "iy", "iz"}) add(header.frame, name);
  }
  for (const std::string& name : wanted.names())
    if (name != "x" && name != "y" && name != "z") add(header.frame, name);
}

void AtomLayout::add(const FrameHeader& header, const std::string& name) {
  const auto it = std::find(header.columns.begin(), header.columns.end(), name);
  if (it == header.columns.end())
    throw InputError(fmt::format("{}: this frame has no column '{}'", place_, name));
  const auto column = static_cast<std::size_t>(it - header.columns.begin());
  for (const Slot& s : slots_)
    if (s.file_column == column) return;
  slots_.push_back({column, name, is_integer_column(name)});
}

void AtomLayout::convert(const Chunk& chunk, AtomBlock& block) const {
  block.reset(chunk.number, chunk.atoms);
  for (std::size_t first = 0; first < chunk.atoms; first += atoms_at_once) {
    const std::size_t last = std::min(first + atoms_at_once, chunk.atoms);
    for (const Slot& slot : slots_) copy(chunk, slot, first, last, block);
  }
  if (positions_wanted_) make_positions(positions_, box_, block);
}

void AtomLayout::copy(const Chunk& chunk, const Slot& slot, std::size_t first, std::size_t last,
                      AtomBlock& block) const {
  const std::size_t atoms = last - first;
  const Strided from{
      chunk.bytes.data() + first * bytes_of_atom() + slot.file_column * sizeof(double),
      bytes_of_atom(), swapped_};
  if (!slot.integer) return copy_real(from, block.make_real(slot.name).subspan(first, atoms));
  const std::size_t whole = copy_whole(from, block.make_integer(slot.name).subspan(first, atoms));
  if (whole < atoms)
    throw InputError(fmt::format("{}: atom {}: {} in column {} is not a whole number in range",
                                 place_, chunk.first_line + first + whole, from[whole], slot.name));
}

}  // namespace mdana::lammps_binary
