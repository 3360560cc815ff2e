// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/lammps_yaml/rows.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "readers/flow_list.hpp"
#include "readers/input_error.hpp"
#include "readers/line_reader.hpp"
#include "readers/word_lines.hpp"

namespace mdana::lammps_yaml {
namespace {

/// What one pass over the values of a row tells.
struct Values {
  std::size_t count = 0;
  bool empty = false;   ///< one of them is
  bool quotes = false;  ///< there are some
};

/// Copies values with blanks in place of their commas.
Values copy_values(std::string_view values, char* out) {
  Values found;
  char last = ',';  // that is no blank
  for (const char c : values) {
    const bool comma = c == ',';
    *out++ = comma ? ' ' : c;
    found.count += comma;
    found.empty |= comma & (last == ',');
    found.quotes |= (c == '\'') | (c == '"');
    last = is_blank(c) ? last : c;
  }
  found.count += last != ',';
  return found;
}

/// The length of a value that may be in quotes, which may hold commas.
std::size_t value_length(std::string_view text) {
  std::size_t from = 0;
  while (from < text.size() && is_blank(text[from])) ++from;
  if (from < text.size() && (text[from] == '\'' || text[from] == '"'))
    from = std::min(text.find(text[from], from + 1), text.size());
  return std::min(text.find(',', from), text.size());
}

/// The same where there are quotes: those around a value are blanked, too.
Values copy_quoted_values(std::string_view values, char* out) {
  Values found{0, false, true};
  for (std::string_view rest = values; !trimmed(rest).empty();) {
    const std::size_t length = value_length(rest);
    const std::string_view value = trimmed(rest.substr(0, length));
    found.empty |= value.empty();
    ++found.count;
    const bool quoted =
        value.size() > 2 && (value[0] == '\'' || value[0] == '"') && value.back() == value[0];
    std::copy(value.begin() + quoted, value.end() - quoted,
              out + (value.data() - values.data()) + quoted);
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
  return found;
}

}  // namespace

Rows::Rows(const FrameHeader& header, const ColumnSet& wanted, std::string path)
    : columns_(header.columns.size()),
      path_(std::move(path)),
      words_(std::make_shared<WordLines>(header, wanted, path_)) {}

/// Copies the values of a row to the same places behind `out`. Returns what is wrong with it.
std::string Rows::copy_row(std::string_view row, char* out) const {
  const auto item = list_item(row);
  const auto values = item ? bracketed(*item) : std::nullopt;
  if (!values)
    return fmt::format("'{}' is not a row '- [ ... ]' of an atom; is natoms right?",
                       trimmed(row.substr(0, 60)));
  out += values->data() - row.data();
  Values found = copy_values(*values, out);
  if (found.quotes) {
    std::fill_n(out, values->size(), ' ');
    found = copy_quoted_values(*values, out);
  }
  if (found.empty) return "a row with an empty value";
  if (found.count != columns_)
    return fmt::format("{} values (the header names {} columns)", found.count, columns_);
  return {};
}

/// The chunk with the same bytes in the same places, but for brackets, commas, quotes and dashes.
Chunk Rows::word_lines(const Chunk& chunk) const {
  Chunk words;
  words.number = chunk.number;
  words.atoms = chunk.atoms;
  words.first_line = chunk.first_line;
  words.storage.assign(LineReader::lead + chunk.bytes.size() + Chunk::padding, ' ');
  char* const out = words.storage.data() + LineReader::lead;
  std::size_t at = 0;
  for (std::size_t i = 0; i < chunk.atoms; ++i) {
    const std::size_t end = chunk.bytes.find('\n', at);
    const std::string wrong = copy_row(chunk.bytes.substr(at, end - at), out + at);
    if (!wrong.empty())
      throw InputError(fmt::format("{}:{}: {}", path_, chunk.first_line + i, wrong));
    out[end] = '\n';
    at = end + 1;
  }
  words.bytes = {out, chunk.bytes.size()};
  return words;
}

void Rows::convert(const Chunk& chunk, AtomBlock& block) const {
  words_->convert(word_lines(chunk), block);
}

PrintedPrecision Rows::printed_precision(const Chunk& chunk, std::string_view column) const {
  return words_->printed_precision(word_lines(chunk), column);
}

}  // namespace mdana::lammps_yaml
