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

/// There are no words in binary dumps: where text would have one there is a number.
void copy_words(const Strided& from, std::span<std::string> to) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = fmt::format("{}", from[i]);
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

AtomLayout::AtomLayout(const Header& header, const ColumnSet& wanted, std::string path)
    : choice_(header.frame, wanted),
      columns_in_file_(header.frame.columns.size()),
      swapped_(header.swapped),
      place_(header.frame.place),
      path_(std::move(path)) {}

void AtomLayout::convert(const Chunk& chunk, AtomBlock& block) const {
  block.reset(chunk.number, chunk.atoms);
  for (std::size_t first = 0; first < chunk.atoms; first += atoms_at_once) {
    const std::size_t last = std::min(first + atoms_at_once, chunk.atoms);
    for (const auto& column : choice_.columns()) copy(chunk, column, first, last, block);
  }
  choice_.finish(block);
}

void AtomLayout::copy(const Chunk& chunk, const ColumnChoice::Column& column, std::size_t first,
                      std::size_t last, AtomBlock& block) const {
  const std::size_t atoms = last - first;
  const Strided from{chunk.bytes.data() + first * bytes_of_atom() + column.in_file * sizeof(double),
                     bytes_of_atom(), swapped_};
  if (column.kind == ColumnKind::text)
    return copy_words(from, block.make_text(column.name).subspan(first, atoms));
  if (column.kind == ColumnKind::real)
    return copy_real(from, block.make_real(column.name).subspan(first, atoms));
  const std::size_t whole = copy_whole(from, block.make_integer(column.name).subspan(first, atoms));
  if (whole < atoms)
    throw InputError(fmt::format("{}: atom {}: {} in column {} is not a whole number in range",
                                 place_, chunk.first_line + first + whole, from[whole],
                                 column.name));
}

}  // namespace mdana::lammps_binary
