// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/word_lines.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

/// A place in the chunk's text, which always ends with a newline.
struct Cursor {
  const char* at;

  void skip_blanks() {
    while (is_gap(*at)) ++at;
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

WordLines::WordLines(const FrameHeader& header, const ColumnSet& wanted, std::string path,
                       const LineKernel& kernel)
    : choice_(header, wanted), names_(header.columns), path_(std::move(path)), kernel_(kernel) {}

/// Converts the lines of one chunk: batches of lines by the kernel, the lines and tokens that it
/// leaves one by one, which also finds the words for what is wrong with them.
class WordLines::Conversion {
 public:
  /// With `faults` it notes what is wrong and goes on, else it throws.
  Conversion(const WordLines& layout, const Chunk& chunk, AtomBlock& block,
             BlockFaults* faults = nullptr)
      : layout_(layout), chunk_(chunk), faults_(faults) {
    shape_.columns = static_cast<std::uint32_t>(layout.names_.size());
    for (const auto& column : layout.choice_.columns()) {
      shape_.wanted.push_back(static_cast<std::uint32_t>(column.in_file));
      targets_.push_back(target(column, block));
    }
    batches_.resize(targets_.size());
  }

  void run() {
    Cursor c{chunk_.bytes.data()};
    for (std::size_t done = 0; done < chunk_.atoms;) {
      const std::size_t lines = std::min(TokenBatch::capacity, chunk_.atoms - done);
      const LineKernel::Scanned scanned = layout_.kernel_.scan(c.at, lines, shape_, batches_.data());
      for (std::size_t k = 0; k < targets_.size(); ++k) column(c.at, k, done, scanned.lines);
      if (!met_.empty()) tell_met();
      c.at = scanned.end;
      done += scanned.lines;
      if (scanned.lines < lines) line(c, done++);
    }
    if (!met_.empty()) tell_met();
  }

 private:
  /// Where a column goes: one of the three.
  struct Target {
    double* real = nullptr;
    std::int64_t* integer = nullptr;
    std::string* text = nullptr;
  };

  static Target target(const ColumnChoice::Column& column, AtomBlock& block) {
    switch (column.kind) {
      case ColumnKind::integer: return {nullptr, block.make_integer(column.name).data(), nullptr};
      case ColumnKind::text: return {nullptr, nullptr, block.make_text(column.name).data()};
      case ColumnKind::real: break;
    }
    return {block.make_real(column.name).data(), nullptr, nullptr};
  }

  void column(const char* text, std::size_t k, std::size_t first, std::size_t lines) {
    const Target& t = targets_[k];
    const TokenBatch& tokens = batches_[k];
    std::uint64_t left = lines == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << lines) - 1;
    if (t.real) left = layout_.kernel_.reals(text, tokens, lines, t.real + first);
    if (t.integer) left = layout_.kernel_.integers(text, tokens, lines, t.integer + first);
    for (; left; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      token({text + tokens.offset[i], tokens.length[i]}, k, first + i);
    }
  }

  void line(Cursor& c, std::size_t atom) {
    const std::vector<std::string_view> tokens = take_line(c);
    if (tokens.size() != shape_.columns)
      return wrong(FaultKind::line, atom, {},
                   fmt::format("{} columns (the header names {})", tokens.size(), shape_.columns));
    for (std::size_t k = 0; k < targets_.size(); ++k) token(tokens[shape_.wanted[k]], k, atom);
  }

  void token(std::string_view text, std::size_t k, std::size_t atom) {
    const Target& t = targets_[k];
    if (t.text) {
      t.text[atom] = text;
      return;
    }
    if (t.real ? parse_number(text, t.real[atom]) : parse_number(text, t.integer[atom])) return;
    double number = 0;
    const bool real = t.real || !parse_number(text, number);
    const std::string& name = layout_.choice_.columns()[k].name;
    wrong(real ? FaultKind::word : FaultKind::not_whole, atom, name,
          fmt::format("'{}' in column {} is not {}", text.substr(0, 40), name,
                      t.real ? "a number" : "a whole number in range"));
  }

  void wrong(FaultKind kind, std::size_t atom, const std::string& column, std::string what) {
    const std::uint64_t line = chunk_.first_line + atom;
    if (!faults_) throw InputError(fmt::format("{}:{}: {}", layout_.path_, line, what));
    faults_->spoil(atom, chunk_.atoms);
    Fault fault;
    fault.kind = kind;
    fault.what = std::move(what);
    fault.file = layout_.path_;
    fault.line = line;
    fault.column = column;
    met_.push_back(std::move(fault));
  }

  /// Faults of a batch, which were met column by column, in the order of lines.
  void tell_met() {
    std::ranges::stable_sort(met_, {}, [](const Fault& fault) { return *fault.line; });
    for (Fault& fault : met_) faults_->faults.add(std::move(fault));
    met_.clear();
  }

  const WordLines& layout_;
  const Chunk& chunk_;
  BlockFaults* faults_;
  std::vector<Fault> met_;  ///< in the lines of a batch
  LineShape shape_;
  std::vector<Target> targets_;
  std::vector<TokenBatch> batches_;
};

void WordLines::convert(const Chunk& chunk, AtomBlock& block) const {
  block.reset(chunk.number, chunk.atoms);
  Conversion(*this, chunk, block).run();
  choice_.finish(block);
}

void WordLines::check(const Chunk& chunk, AtomBlock& block, BlockFaults& faults) const {
  block.reset(chunk.number, chunk.atoms);
  Conversion(*this, chunk, block, &faults).run();
  choice_.finish(block);
}

PrintedPrecision WordLines::printed_precision(const Chunk& chunk, std::string_view column) const {
  const auto file_column =
      static_cast<std::size_t>(std::ranges::find(names_, column) - names_.begin());
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

}  // namespace mdana
