// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/amber_netcdf/atoms.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstring>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::amber_netcdf {
namespace {

/// Beyond it doubles do not tell whole numbers apart.
constexpr double largest_whole = 0x1p53;

/// One number of each of several atoms.
template <class T>
struct Strided {
  const char* first;
  std::size_t stride;  ///< [bytes]
  const std::string& fill;

  T operator[](std::size_t i) const {
    T value;
    std::memcpy(&value, first + i * stride, sizeof value);
    return value;
  }
  bool unwritten(std::size_t i) const {
    return !fill.empty() && std::memcmp(first + i * stride, fill.data(), sizeof(T)) == 0;
  }
};

/// How many are copied before the first that was never written.
template <class T>
std::size_t copy_real(const Strided<T>& from, double scale, std::span<double> to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (from.unwritten(i)) return i;
    to[i] = static_cast<double>(from[i]) * scale;
  }
  return to.size();
}

template <std::floating_point T>
bool is_whole(T value) {
  return std::abs(value) <= largest_whole && std::trunc(value) == value;  // NaN is not
}
template <std::integral T>
bool is_whole(T value) {
  return std::in_range<std::int64_t>(value);
}

/// How many are copied before the first that was never written or is not whole.
template <class T>
std::size_t copy_whole(const Strided<T>& from, std::span<std::int64_t> to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (from.unwritten(i) || !is_whole(from[i])) return i;
    to[i] = static_cast<std::int64_t>(from[i]);
  }
  return to.size();
}

/// Calls `use` with a number of the type.
template <class Use>
auto with_type(Type type, Use&& use) {
  switch (type) {
    case Type::int8:
      return use(std::int8_t{});
    case Type::int16:
      return use(std::int16_t{});
    case Type::int32:
      return use(std::int32_t{});
    case Type::float32:
      return use(float{});
    case Type::float64:
      return use(double{});
    case Type::uint8:
      return use(std::uint8_t{});
    case Type::uint16:
      return use(std::uint16_t{});
    case Type::uint32:
      return use(std::uint32_t{});
    case Type::int64:
      return use(std::int64_t{});
    case Type::uint64:
      return use(std::uint64_t{});
    case Type::character:
      break;
  }
  throw std::logic_error("characters are no columns");
}

/// Of a variable in a chunk, so that the next one begins where any number may stand.
std::size_t bytes_of(const AtomVariable& v, std::size_t atoms) {
  return (atoms * v.numbers * size_of(v.type) + 7) / 8 * 8;
}

}  // namespace

AtomLayout::AtomLayout(const FrameHeader& header, std::shared_ptr<const Content> content,
                       const ColumnSet& wanted)
    : content_(std::move(content)), choice_(header, wanted), place_(header.place) {
  for (const auto& column : choice_.columns()) {
    const auto& variable = content_->columns[column.in_file].variable;
    if (!variable) continue;
    const AtomVariable* needed = &content_->variables[*variable];
    if (std::ranges::find(variables_, needed) == variables_.end()) variables_.push_back(needed);
  }
}

std::vector<AtomLayout::Part> AtomLayout::parts(std::size_t atoms) const {
  std::vector<Part> parts;
  std::size_t offset = 0;
  for (const AtomVariable* variable : variables_) {
    parts.push_back({variable, offset});
    offset += bytes_of(*variable, atoms);
  }
  return parts;
}

std::size_t AtomLayout::bytes(std::size_t atoms) const {
  return std::accumulate(
      variables_.begin(), variables_.end(), std::size_t{0},
      [&](std::size_t sum, const AtomVariable* v) { return sum + bytes_of(*v, atoms); });
}

void AtomLayout::convert(const Chunk& chunk, AtomBlock& block) const {
  block.reset(chunk.number, chunk.atoms);
  const auto all = parts(chunk.atoms);
  for (const auto& column : choice_.columns()) copy(chunk, column, all, block);
  choice_.finish(block);
}

void AtomLayout::copy(const Chunk& chunk, const ColumnChoice::Column& column,
                      const std::vector<Part>& parts, AtomBlock& block) const {
  const AtomColumn& source = content_->columns[column.in_file];
  if (!source.variable) {
    const auto ids = block.make_integer(column.name);
    return std::iota(ids.begin(), ids.end(), static_cast<std::int64_t>(chunk.first_line));
  }
  const AtomVariable& v = content_->variables[*source.variable];
  const std::size_t offset = std::ranges::find(parts, &v, &Part::variable)->offset;
  with_type(v.type, [&]<class T>(T) {
    const Strided<T> from{chunk.bytes.data() + offset + source.place * sizeof(T),
                          v.numbers * sizeof(T), v.fill};
    const bool whole = column.kind == ColumnKind::integer;
    const std::size_t copied = whole ? copy_whole(from, block.make_integer(column.name))
                                     : copy_real(from, v.scale, block.make_real(column.name));
    if (copied == chunk.atoms) return;
    fail(chunk, copied, column.name,
         from.unwritten(copied)
             ? fmt::format("was never written ({} is netCDF's value for that)", from[copied])
             : fmt::format("is {}, not a whole number in range", from[copied]));
  });
}

void AtomLayout::fail(const Chunk& chunk, std::size_t atom, const std::string& column,
                      const std::string& what) const {
  throw InputError(
      fmt::format("{}: atom {}: column {} {}", place_, chunk.first_line + atom, column, what));
}

}  // namespace mdana::amber_netcdf
