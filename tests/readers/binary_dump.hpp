// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mdana::test {

/// The bytes of a number.
template <class T>
std::string bytes_of(T value, std::endian order) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// A frame of a LAMMPS binary dump, every field of which may be made wrong.
struct BinaryFrame {
  std::string name = "DUMPCUSTOM";
  std::optional<std::int64_t> marker;  ///< default: minus the length of the name
  std::int32_t order_mark = 1, revision = 2;
  std::int64_t step = 0;
  std::optional<std::int64_t> natoms;  ///< default: those of the ranks
  std::int32_t triclinic = 0;
  std::array<std::int32_t, 6> boundary{1, 1, 1, 1, 1, 1};
  std::vector<double> box{0, 1, 0, 1, 0, 1};  ///< and tilts; or edges and origin
  std::int32_t size_one = 0;                  ///< 0: as many as `columns` has words
  std::string units;
  std::optional<std::int32_t> units_length;
  char time_flag = 0;
  double time = 0;
  std::string columns = "id x y z";
  std::optional<std::int32_t> columns_length;
  std::optional<std::int32_t> nchunk;          ///< default: the number of ranks
  std::vector<std::vector<double>> ranks{{}};  ///< the numbers of each rank's atoms
  std::vector<std::int32_t> lengths;           ///< default: of the ranks

  std::int32_t words() const {
    return columns.empty()
               ? 0
               : 1 + static_cast<std::int32_t>(std::count(columns.begin(), columns.end(), ' '));
  }
  std::int32_t numbers_of_atom() const { return size_one ? size_one : words(); }
  std::int64_t atoms() const {
    std::size_t numbers = 0;
    for (const auto& rank : ranks) numbers += rank.size();
    return static_cast<std::int64_t>(numbers) / std::max(1, numbers_of_atom());
  }

  std::string header(std::endian order = std::endian::little) const {
    const auto put = [&](auto value) { return bytes_of(value, order); };
    std::string bytes = put(marker.value_or(-static_cast<std::int64_t>(name.size()))) + name;
    bytes += put(order_mark) + put(revision) + old_header(order);
    bytes += put(units_length.value_or(static_cast<std::int32_t>(units.size()))) + units;
    bytes += time_flag;
    if (time_flag) bytes += put(time);
    bytes += put(columns_length.value_or(static_cast<std::int32_t>(columns.size()))) + columns;
    return bytes + put(nchunk.value_or(static_cast<std::int32_t>(ranks.size())));
  }

  /// From the step to the numbers of an atom: all that LAMMPS wrote before October 2020.
  std::string old_header(std::endian order = std::endian::little) const {
    const auto put = [&](auto value) { return bytes_of(value, order); };
    std::string bytes = put(step) + put(natoms.value_or(atoms())) + put(triclinic);
    for (const auto side : boundary) bytes += put(side);
    for (const double number : box) bytes += put(number);
    return bytes + put(numbers_of_atom());
  }

  std::string bytes(std::endian order = std::endian::little) const {
    std::string all = header(order);
    for (std::size_t k = 0; k < ranks.size(); ++k) {
      all += bytes_of(k < lengths.size() ? lengths[k] : static_cast<std::int32_t>(ranks[k].size()),
                      order);
      for (const double number : ranks[k]) all += bytes_of(number, order);
    }
    return all;
  }
};

}  // namespace mdana::test
