// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/block.hpp"

#include <algorithm>
#include <stdexcept>

namespace mdana {
namespace {

template <class Columns>
auto find(Columns& columns, std::string_view name) {
  return std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.name == name; });
}

template <class Columns>
auto& existing(Columns& columns, std::string_view name) {
  const auto it = find(columns, name);
  if (it == columns.end())
    throw std::logic_error("column " + std::string(name) + " was not declared in Needs");
  return it->values;
}

template <class Columns>
auto& made(Columns& columns, std::string_view name, std::size_t atoms) {
  auto it = find(columns, name);
  if (it == columns.end()) it = columns.insert(columns.end(), {std::string(name), {}});
  it->values.resize(atoms);
  return it->values;
}

}  // namespace

void AtomBlock::reset(std::uint64_t number, std::size_t atoms) {
  number_ = number;
  atoms_ = atoms;
  for (auto& c : reals_) c.values.resize(atoms);
  for (auto& c : integers_) c.values.resize(atoms);
  for (auto& c : texts_) c.values.resize(atoms);
}

std::span<const double> AtomBlock::real(std::string_view name) const {
  return existing(reals_, name);
}
std::span<const std::int64_t> AtomBlock::integer(std::string_view name) const {
  return existing(integers_, name);
}
std::span<const std::string> AtomBlock::text(std::string_view name) const {
  return existing(texts_, name);
}
std::span<double> AtomBlock::make_real(std::string_view name) { return made(reals_, name, atoms_); }
std::span<std::int64_t> AtomBlock::make_integer(std::string_view name) {
  return made(integers_, name, atoms_);
}
std::span<std::string> AtomBlock::make_text(std::string_view name) {
  return made(texts_, name, atoms_);
}

void AtomBlock::put(const AtomBlock& part, std::size_t first) {
  for (const auto& c : part.reals_)
    std::ranges::copy(c.values, make_real(c.name).subspan(first).begin());
  for (const auto& c : part.integers_)
    std::ranges::copy(c.values, make_integer(c.name).subspan(first).begin());
  for (const auto& c : part.texts_)
    std::ranges::copy(c.values, make_text(c.name).subspan(first).begin());
}

void AtomBlock::keep(std::span<const std::uint32_t> atoms) {
  const auto keep_in = [&](auto& columns) {
    for (auto& column : columns) {
      for (std::size_t i = 0; i < atoms.size(); ++i)
        if (atoms[i] != i) column.values[i] = std::move(column.values[atoms[i]]);
      column.values.resize(atoms.size());
    }
  };
  keep_in(reals_);
  keep_in(integers_);
  keep_in(texts_);
  atoms_ = atoms.size();
}

std::size_t AtomBlock::bytes() const {
  return atoms_ * (reals_.size() * sizeof(double) + integers_.size() * sizeof(std::int64_t) +
                   texts_.size() * sizeof(std::string));
}

}  // namespace mdana
