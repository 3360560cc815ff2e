// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/word_lines.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "readers/shown.hpp"

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
    selecting_ = faults ? std::nullopt : selecting_column();
    batches_.resize(targets_.size());
  }

  void run() {
    Cursor c{chunk_.bytes.data()};
    for (std::size_t done = 0; done < chunk_.atoms;) {
      const std::size_t lines = std::min(TokenBatch::capacity, chunk_.atoms - done);
      const LineKernel::Scanned scanned = layout_.kernel_.scan(c.at, lines, shape_, batches_.data());
      batch(c.at, done, scanned.lines);
      if (!met_.empty()) tell_met();
      c.at = scanned.end;
      done += scanned.lines;
      if (scanned.lines < lines) line(c, done++);
    }
    if (!met_.empty()) tell_met();
  }

  /// That were converted, one behind the other: all, or those that are selected.
  std::size_t atoms() const { return atoms_; }

 private:
  std::optional<std::size_t> selecting_column() const {
    const auto& columns = layout_.choice_.columns();
    if (!layout_.choice_.selection()) return std::nullopt;
    const auto it = std::ranges::find(columns, layout_.choice_.selection()->column(),
                                      &ColumnChoice::Column::name);
    return static_cast<std::size_t>(it - columns.begin());
  }

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

  /// Lines of the chunk from `first` on, whose tokens are in the batches.
  void batch(const char* text, std::size_t first, std::size_t lines) {
    for (std::size_t i = 0; i < lines; ++i) lines_[i] = first + i;
    if (selecting_) lines = select(text, lines);
    for (std::size_t k = 0; k < targets_.size() && lines > 0; ++k) column(text, k, lines);
    atoms_ += lines;
  }

  /// Moves the tokens of selected atoms to the front of the batches. Returns how many there are.
  std::size_t select(const char* text, std::size_t lines) {
    column(text, *selecting_, lines);
    const Selection& selection = *layout_.choice_.selection();
    std::size_t selected = 0;
    for (std::size_t i = 0; i < lines; ++i) {
      if (!selection.holds(targets_[*selecting_].integer[atoms_ + i])) continue;
      for (TokenBatch& tokens : batches_) {
        tokens.offset[selected] = tokens.offset[i];
        tokens.length[selected] = tokens.length[i];
      }
      lines_[selected++] = lines_[i];
    }
    return selected;
  }

  void column(const char* text, std::size_t k, std::size_t lines) {
    const Target& t = targets_[k];
    const TokenBatch& tokens = batches_[k];
    std::uint64_t left = lines == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << lines) - 1;
    if (t.real) left = layout_.kernel_.reals(text, tokens, lines, t.real + atoms_);
    if (t.integer) left = layout_.kernel_.integers(text, tokens, lines, t.integer + atoms_);
    for (; left; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      token({text + tokens.offset[i], tokens.length[i]}, k, lines_[i], atoms_ + i);
    }
  }

  void line(Cursor& c, std::size_t line) {
    const std::vector<std::string_view> tokens = take_line(c);
    const std::size_t atom = atoms_;
    if (tokens.size() != shape_.columns) {
      wrong(FaultKind::line, line, {},
            fmt::format("{} columns (the header names {})", tokens.size(), shape_.columns));
    } else {
      if (selecting_ && !is_selected(tokens, line)) return;
      for (std::size_t k = 0; k < targets_.size(); ++k)
        token(tokens[shape_.wanted[k]], k, line, atom);
    }
    ++atoms_;
  }

  bool is_selected(const std::vector<std::string_view>& tokens, std::size_t line) {
    token(tokens[shape_.wanted[*selecting_]], *selecting_, line, atoms_);
    return layout_.choice_.selection()->holds(targets_[*selecting_].integer[atoms_]);
  }

  void token(std::string_view text, std::size_t k, std::size_t line, std::size_t atom) {
    const Target& t = targets_[k];
    if (t.text) {
      t.text[atom] = text;
      return;
    }
    if (t.real ? parse_number(text, t.real[atom]) : parse_number(text, t.integer[atom])) return;
    double number = 0;
    const bool real = t.real || !parse_number(text, number);
    const std::string& name = layout_.choice_.columns()[k].name;
    wrong(real ? FaultKind::word : FaultKind::not_whole, line, name,
          fmt::format("'{}' in column {} is not {}", shown(text, 40), name,
                      t.real ? "a number" : "a whole number in range"));
  }

  /// In a line of the chunk, from 0.
  void wrong(FaultKind kind, std::size_t in_chunk, const std::string& column, std::string what) {
    const std::uint64_t line = chunk_.first_line + in_chunk;
    if (!faults_) throw InputError(fmt::format("{}:{}: {}", layout_.path_, line, what));
    faults_->spoil(in_chunk, chunk_.atoms);
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
  std::array<std::size_t, TokenBatch::capacity> lines_{};  ///< of the tokens of a batch, in the chunk
  std::optional<std::size_t> selecting_;  ///< the target that the selection looks at
  std::size_t atoms_ = 0;
};

void WordLines::convert(const Chunk& chunk, AtomBlock& block) const {
  block.reset(chunk.number, chunk.atoms);
  Conversion conversion(*this, chunk, block);
  conversion.run();
  block.shorten(conversion.atoms());
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
