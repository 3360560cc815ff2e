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

  void add(std::string_view name);
  void add(const ColumnSet& other) {
    for (const std::string& name : other.names_) add(name);
  }
  bool has(std::string_view name) const;
  bool empty() const { return names_.empty(); }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

/// Columns that hold whole numbers: id, type, mol, proc, procp1, ix, iy, iz.
bool is_integer_column(std::string_view name);

}  // namespace mdana
