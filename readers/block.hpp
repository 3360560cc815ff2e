// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mdana {

/// Atoms of one block of a frame, a plain array for each column. A frame is cut into blocks of a
/// fixed number of atoms in file order, so that block numbers do not depend on threads or memory.
class AtomBlock {
 public:
  /// Atoms in every block but a frame's last one.
  static constexpr std::size_t capacity = std::size_t{1} << 15;

  /// Starts anew with `atoms` atoms; the arrays of earlier columns are kept for reuse.
  void reset(std::uint64_t number, std::size_t atoms);

  std::uint64_t number() const { return number_; }  ///< 0, 1, 2 ... within the frame
  std::size_t atoms() const { return atoms_; }

  /// Values of a column that was asked for; asking for another one is a programming error.
  std::span<const double> real(std::string_view name) const;
  std::span<const std::int64_t> integer(std::string_view name) const;

  std::span<const std::string> text(std::string_view name) const;

  /// The same for writing; makes the column if it is missing.
  std::span<double> make_real(std::string_view name);
  std::span<std::int64_t> make_integer(std::string_view name);
  std::span<std::string> make_text(std::string_view name);

  /// Copies all columns of another block to the atoms from `first` on; makes those that are missing.
  void put(const AtomBlock& part, std::size_t first);

  /// Keeps the atoms of these ascending indices only.
  void keep(std::span<const std::uint32_t> atoms);

  /// Keeps the first `atoms` atoms only.
  void shorten(std::size_t atoms) { reset(number_, atoms); }

  std::size_t bytes() const;  ///< memory held by the arrays

 private:
  template <class T>
  struct Column {
    std::string name;
    std::vector<T> values;
  };
  std::uint64_t number_ = 0;
  std::size_t atoms_ = 0;
  std::vector<Column<double>> reals_;
  std::vector<Column<std::int64_t>> integers_;
  std::vector<Column<std::string>> texts_;
};

}  // namespace mdana
