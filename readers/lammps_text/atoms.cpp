// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/lammps_text/atoms.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::lammps_text {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
constexpr bool ends_token(char c) { return is_blank(c) || c == '\n'; }

/// A place in the chunk's text, which always ends with a newline.
struct Cursor {
  const char* at;
  const char* end;

  void skip_blanks() {
    while (is_blank(*at)) ++at;
  }
  bool at_line_end() const { return *at == '\n'; }
  std::string_view token() const {
    const char* stop = at;
    while (!ends_token(*stop)) ++stop;
    return {at, static_cast<std::size_t>(stop - at)};
  }
  void skip_token() {
    while (!ends_token(*at)) ++at;
  }
  /// Passes over `count` columns and the blanks before the next; false if the line ends first.
  bool skip_columns(std::size_t count) {
    skip_blanks();
    for (; count > 0 && !at_line_end(); --count) {
      skip_token();
      skip_blanks();
    }
    return !at_line_end();
  }
  void next_line() {
    at = static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at))) + 1;
  }
};

/// Moves the cursor behind the number; false if the token is none.
template <class T>
bool parse(Cursor& c, T& value) {
  const auto [stop, error] = std::from_chars(c.at, c.end, value);
  if (error == std::errc{} && ends_token(*stop)) {
    c.at = stop;
    return true;
  }
  if constexpr (std::is_same_v<T, double>) {
    if (error == std::errc::result_out_of_range && ends_token(*stop)) {  // 1e-400, 1e400
      value = std::strtod(std::string(c.token()).c_str(), nullptr);
      c.at = stop;
      return true;
    }
  }
  return false;
}

struct Target {
  std::size_t skip;  ///< columns between the slot before and this one
  double* real;
  std::int64_t* integer;
};

std::size_t count_columns(std::string_view line) {
  std::size_t count = 0;
  bool inside = false;
  for (const char c : line) {
    if (c == '\n') break;
    count += !is_blank(c) && !inside;
    inside = !is_blank(c);
  }
  return count;
}

/// Digits of one printed number.
struct Digits {
  int significant = 0;
  int decimals = 0;
  bool exponent = false;
};

Digits digits_of(std::string_view token) {
  Digits digits;
  bool leading = true, fraction = false;
  for (const char c : token) {
    if (c == 'e' || c == 'E') {
      digits.exponent = true;
      break;
    }
    if (c == '.') fraction = true;
    if (c < '0' || c > '9') continue;
    if (c != '0') leading = false;
    if (!leading) ++digits.significant;
    if (fraction) ++digits.decimals;
  }
  return digits;
}

}  // namespace

AtomLayout::AtomLayout(const FrameHeader& header, const ColumnSet& wanted)
    : columns_(header.columns.size()), box_(header.box) {
  positions_wanted_ = wanted.has("x") || wanted.has("y") || wanted.has("z");
  if (positions_wanted_) {
    const auto source = position_source(header.columns);
    if (!source)
      throw InputError(fmt::format("{}: no position columns (x y z, xs, xu or xsu)", header.place));
    positions_ = *source;
    for (const std::string& name : positions_.columns) add(header, name);
    if (positions_.image_flags)
      for (const char* name : {"ix", "iy", "iz"}) add(header, name);
  }
  for (const std::string& name : wanted.names())
    if (name != "x" && name != "y" && name != "z") add(header, name);
  std::sort(slots_.begin(), slots_.end(),
            [](const Slot& a, const Slot& b) { return a.file_column < b.file_column; });
}

void AtomLayout::add(const FrameHeader& header, const std::string& name) {
  const auto it = std::find(header.columns.begin(), header.columns.end(), name);
  if (it == header.columns.end())
    throw InputError(fmt::format("{}: this frame has no column '{}'", header.place, name));
  const auto column = static_cast<std::size_t>(it - header.columns.begin());
  for (const Slot& s : slots_)
    if (s.file_column == column) return;
  slots_.push_back({column, name, is_integer_column(name)});
}

void AtomLayout::convert(const Chunk& chunk, const std::string& path, AtomBlock& block) const {
  block.reset(chunk.number, chunk.atoms);
  std::vector<Target> targets;
  std::size_t next_column = 0;
  for (const Slot& s : slots_) {
    targets.push_back({s.file_column - next_column,
                       s.integer ? nullptr : block.make_real(s.name).data(),
                       s.integer ? block.make_integer(s.name).data() : nullptr});
    next_column = s.file_column + 1;
  }

  Cursor c{chunk.bytes.data(), chunk.bytes.data() + chunk.bytes.size()};
  for (std::size_t i = 0; i < chunk.atoms; ++i) {
    const char* line = c.at;
    for (std::size_t k = 0; k < targets.size(); ++k) {
      const Target& t = targets[k];
      const auto where = [&] { return fmt::format("{}:{}", path, chunk.first_line + i); };
      if (!c.skip_columns(t.skip))
        throw InputError(fmt::format("{}: {} columns (the header names {})", where(),
                                     count_columns({line, static_cast<std::size_t>(c.end - line)}),
                                     columns_));
      if (!(t.real ? parse(c, t.real[i]) : parse(c, t.integer[i])))
        throw InputError(fmt::format("{}: '{}' in column {} is not {}", where(),
                                     c.token().substr(0, 40), slots_[k].name,
                                     t.real ? "a number" : "a whole number in range"));
    }
    c.next_line();
  }
  if (positions_wanted_) make_positions(positions_, box_, block);
}

PrintedPrecision printed_precision(const Chunk& chunk, std::size_t file_column) {
  Cursor c{chunk.bytes.data(), chunk.bytes.data() + chunk.bytes.size()};
  PrintedPrecision printed;
  bool exponents = false;
  int least_decimals = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < chunk.atoms; ++i) {
    if (c.skip_columns(file_column)) {
      const Digits digits = digits_of(c.token());
      printed.digits = std::max(printed.digits, digits.significant);
      printed.decimals = std::max(printed.decimals, digits.decimals);
      least_decimals = std::min(least_decimals, digits.decimals);
      exponents = exponents || digits.exponent;
    }
    c.next_line();
  }
  if (printed.decimals == 0 && !exponents) return {};
  printed.fixed = !exponents && least_decimals == printed.decimals;
  return printed;
}

}  // namespace mdana::lammps_text
