// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace mdana {

/// Names of atom columns, sorted and unique. `x y z` mean positions in length units, unscaled and
/// unwrapped as far as the dump allows, however the dump spells them (x, xs, xu, xsu); every other
/// name is that of the dump (vx, fx, id, type, mol, mass, c_pe, ...).
class ColumnSet {
 public:
  ColumnSet() = default;
  ColumnSet(std::initializer_list<std::string_view> names) {
    for (std::string_view name : names) add(name);
  }

  /// Every column that a frame has, as it stands there: positions as the dump spells them.
  static ColumnSet all_as_they_stand() {
    ColumnSet all;
    all.as_they_stand_ = true;
    return all;
  }

  void add(std::string_view name);
  void add(const ColumnSet& other) {
    for (const std::string& name : other.names_) add(name);
  }
  bool has(std::string_view name) const;
  bool empty() const { return names_.empty(); }
  const std::vector<std::string>& names() const { return names_; }
  bool as_they_stand() const { return as_they_stand_; }

 private:
  bool as_they_stand_ = false;
  std::vector<std::string> names_;
};

/// What a column holds, by its name: id, type, mol, proc, procp1, ix, iy, iz are whole numbers,
/// element and typelabel words, all others real numbers.
enum class ColumnKind { real, integer, text };
ColumnKind kind_of_column(std::string_view name);

}  // namespace mdana
