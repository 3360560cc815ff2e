// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <string>

#include "readers/known_dump.hpp"

namespace mdana {

std::vector<KnownAnswer> lammps_binary_known();

namespace {

/// A number as a big-endian machine writes it.
template <class T>
std::string big_endian(T value) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  if (std::endian::native == std::endian::little) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string whole(std::initializer_list<std::int32_t> numbers) {
  std::string bytes;
  for (const auto number : numbers) bytes += big_endian(number);
  return bytes;
}

std::string doubles(std::initializer_list<double> numbers) {
  std::string bytes;
  for (const double number : numbers) bytes += big_endian(number);
  return bytes;
}

// Edges a = (8, 0, 0), b = (2, 4, 0), c = (-1, 1, 16) from the corner (-4, -2, 0); the bounds are
// those of the box around it: x from -4 - 1 to 4 + 2, y from -2 to 2 + 1. Three ranks, one of them
// without atoms.
std::string dump() {
  const std::string columns = "id xs ys zs type ix iy iz";
  std::string bytes = big_endian(std::int64_t{-10}) + "DUMPCUSTOM" + whole({1, 2});
  bytes += big_endian(std::int64_t{5'000'000'000}) + big_endian(std::int64_t{2});
  bytes += whole({1, 0, 0, 0, 0, 1, 1});
  bytes += doubles({-5, 6, -2, 3, 0, 16, 2, -1, 1});
  bytes += whole({8, 4}) + "real" + '\1' + doubles({0.375});
  bytes += whole({static_cast<std::int32_t>(columns.size())}) + columns;
  bytes += whole({3, 8}) + doubles({7, 0.5, 0.25, 0.125, 1, 0, 0, 0});
  bytes += whole({0, 8}) + doubles({3, 1, 1, 1, 2, 1, 0, -2});
  return bytes;
}

}  // namespace

std::vector<KnownAnswer> lammps_binary_known() {
  TiltedPair pair = read_tilted_pair(dump());
  pair.add("time", pair.header.time.value_or(-1), 0.375);
  return pair.answers;
}

}  // namespace mdana
