// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mdana {

class Selection;

/// What is wanted of the atoms: names of columns, sorted and unique, and which atoms, if not all. `x y z` mean positions in length units, unscaled and
/// unwrapped as far as the dump allows, however the dump spells them (x, xs, xu, xsu); every other
/// name is that of the dump (vx, fx, id, type, mol, mass, c_pe, ...).
class ColumnSet {
 public:
  ColumnSet() = default;
  ColumnSet(std::initializer_list<std::string_view> names) {
    for (std::string_view name : names) add(name);
  }

  /// Columns as they stand in the dump, positions as it spells them: those that are added, or all
  /// that a frame has if none is.
  static ColumnSet all_as_they_stand() {
    ColumnSet all;
    all.as_they_stand_ = true;
    return all;
  }

  /// Only these atoms are wanted; the column that the selection looks at is then read besides.
  void select(const Selection& atoms);
  const Selection* selection() const { return selection_.get(); }  ///< null: all atoms

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
  std::shared_ptr<const Selection> selection_;
};

/// What a column holds, by its name: id, type, mol, proc, procp1, ix, iy, iz are whole numbers,
/// element and typelabel words, all others real numbers.
enum class ColumnKind { real, integer, text };
ColumnKind kind_of_column(std::string_view name);

}  // namespace mdana
