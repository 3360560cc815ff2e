// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/lammps_text/atoms.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::lammps_text {
namespace {

/// A place in the chunk's text, which always ends with a newline.
struct Cursor {
  const char* at;

  void skip_blanks() {
    while (is_blank(*at)) ++at;
  }
  bool at_line_end() const { return *at == '\n'; }
  std::string_view take_token() {
    const char* start = at;
    while (static_cast<unsigned char>(*at) > ' ') ++at;
    return {start, static_cast<std::size_t>(at - start)};
  }
};

/// The columns of the line that begins at the cursor, which is left behind the line.
std::vector<std::string_view> take_line(Cursor& c) {
  std::vector<std::string_view> tokens;
  for (c.skip_blanks(); !c.at_line_end(); c.skip_blanks()) tokens.push_back(c.take_token());
  ++c.at;
  return tokens;
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

/// Converts the lines of one chunk: batches of lines by the kernel, the lines and tokens that it
/// leaves one by one, which also finds the words for what is wrong with them.
class AtomLayout::Conversion {
 public:
  Conversion(const AtomLayout& layout, const Chunk& chunk, const std::string& path,
             AtomBlock& block, const LineKernel& kernel)
      : layout_(layout), chunk_(chunk), path_(path), kernel_(kernel) {
    shape_.columns = static_cast<std::uint32_t>(layout.columns_);
    for (const Slot& s : layout.slots_) {
      shape_.wanted.push_back(static_cast<std::uint32_t>(s.file_column));
      targets_.push_back({s.integer ? nullptr : block.make_real(s.name).data(),
                          s.integer ? block.make_integer(s.name).data() : nullptr});
    }
    batches_.resize(targets_.size());
  }

  void run() {
    Cursor c{chunk_.bytes.data()};
    for (std::size_t done = 0; done < chunk_.atoms;) {
      const std::size_t lines = std::min(TokenBatch::capacity, chunk_.atoms - done);
      const LineKernel::Scanned scanned = kernel_.scan(c.at, lines, shape_, batches_.data());
      for (std::size_t k = 0; k < targets_.size(); ++k) column(c.at, k, done, scanned.lines);
      c.at = scanned.end;
      done += scanned.lines;
      if (scanned.lines < lines) line(c, done++);
    }
  }

 private:
  struct Target {
    double* real;
    std::int64_t* integer;
  };

  void column(const char* text, std::size_t k, std::size_t first, std::size_t lines) {
    const Target& t = targets_[k];
    const TokenBatch& tokens = batches_[k];
    std::uint64_t failed = t.real ? kernel_.reals(text, tokens, lines, t.real + first)
                                  : kernel_.integers(text, tokens, lines, t.integer + first);
    for (; failed; failed &= failed - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(failed));
      token({text + tokens.offset[i], tokens.length[i]}, k, first + i);
    }
  }

  void line(Cursor& c, std::size_t atom) {
    const std::vector<std::string_view> tokens = take_line(c);
    if (tokens.size() != layout_.columns_)
      throw InputError(fmt::format("{}: {} columns (the header names {})", where(atom),
                                   tokens.size(), layout_.columns_));
    for (std::size_t k = 0; k < targets_.size(); ++k) token(tokens[shape_.wanted[k]], k, atom);
  }

  void token(std::string_view text, std::size_t k, std::size_t atom) {
    const Target& t = targets_[k];
    if (t.real ? parse_number(text, t.real[atom]) : parse_number(text, t.integer[atom])) return;
    throw InputError(fmt::format("{}: '{}' in column {} is not {}", where(atom), text.substr(0, 40),
                                 layout_.slots_[k].name,
                                 t.real ? "a number" : "a whole number in range"));
  }

  std::string where(std::size_t atom) const {
    return fmt::format("{}:{}", path_, chunk_.first_line + atom);
  }

  const AtomLayout& layout_;
  const Chunk& chunk_;
  const std::string& path_;
  const LineKernel& kernel_;
  LineShape shape_;
  std::vector<Target> targets_;
  std::vector<TokenBatch> batches_;
};

void AtomLayout::convert(const Chunk& chunk, const std::string& path, AtomBlock& block,
                         const LineKernel& kernel) const {
  block.reset(chunk.number, chunk.atoms);
  Conversion(*this, chunk, path, block, kernel).run();
  if (positions_wanted_) make_positions(positions_, box_, block);
}

PrintedPrecision printed_precision(const Chunk& chunk, std::size_t file_column) {
  Cursor c{chunk.bytes.data()};
  PrintedPrecision printed;
  bool exponents = false;
  int least_decimals = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < chunk.atoms; ++i) {
    const std::vector<std::string_view> tokens = take_line(c);
    if (file_column >= tokens.size()) continue;
    const Digits digits = digits_of(tokens[file_column]);
    printed.digits = std::max(printed.digits, digits.significant);
    printed.decimals = std::max(printed.decimals, digits.decimals);
    least_decimals = std::min(least_decimals, digits.decimals);
    exponents = exponents || digits.exponent;
  }
  if (printed.decimals == 0 && !exponents) return {};
  printed.fixed = !exponents && least_decimals == printed.decimals;
  return printed;
}

}  // namespace mdana::lammps_text
