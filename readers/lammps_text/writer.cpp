// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/lammps_text/writer.hpp"

#include <algorithm>
#include <stdexcept>
#include <variant>

#include <fmt/compile.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/byte_sink.hpp"
#include "readers/columns.hpp"
#include "readers/input_error.hpp"
#include "readers/lammps_text/box_lines.hpp"

namespace mdana::lammps_text {
namespace {

constexpr std::size_t full = std::size_t{1} << 20;  ///< bytes of text that go to the file at once

/// Words of a dump are told apart by blanks.
bool is_word(std::string_view text) {
  return !text.empty() &&
         std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) > ' '; });
}

/// The values of a column of one block.
using Values = std::variant<std::span<const double>, std::span<const std::int64_t>,
                            std::span<const std::string>>;

Values values_of(const AtomBlock& block, const std::string& name) {
  switch (kind_of_column(name)) {
    case ColumnKind::integer: return block.integer(name);
    case ColumnKind::text: return block.text(name);
    case ColumnKind::real: break;
  }
  return block.real(name);
}

class Writer final : public FrameWriter {
 public:
  explicit Writer(const std::filesystem::path& path) : file_(create_bytes(path)) {}

  void begin(const FrameHeader& header) override {
    expect_whole_frame();
    check_columns(header);
    if (header.units && header.units != units_)
      print("ITEM: UNITS\n{}\n", name(*header.units));
    if (header.units) units_ = header.units;
    if (header.time) print("ITEM: TIME\n{}\n", *header.time);
    print("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n", header.step, header.atoms);
    try {
      print("{}", box_lines(header.box));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", header.place, error.what()));
    }
    print("ITEM: ATOMS {}\n", fmt::join(header.columns, " "));
    columns_ = header.columns;
    atoms_left_ = header.atoms;
    place_ = header.place;
  }

  void add(const AtomBlock& block) override {
    if (block.atoms() > atoms_left_) throw std::logic_error("more atoms than the header names");
    std::vector<Values> values;
    for (const std::string& name : columns_) values.push_back(values_of(block, name));
    for (std::size_t i = 0; i < block.atoms(); ++i) {
      line(values, i);
      if (text_.size() > full) flush();
    }
    atoms_left_ -= block.atoms();
  }

  void finish() override {
    expect_whole_frame();
    flush();
    file_->finish();
  }

 private:
  void expect_whole_frame() const {
    if (atoms_left_ > 0) throw std::logic_error("fewer atoms than the header names");
  }

  static void check_columns(const FrameHeader& header) {
    if (header.columns.empty())
      throw InputError(fmt::format("{}: no columns to write", header.place));
    for (const std::string& name : header.columns)
      if (!is_word(name))
        throw InputError(fmt::format("{}: '{}' cannot be the name of a column in a text dump: it is "
                                     "empty or has blanks", header.place, name));
  }

  template <class... Arguments>
  void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(fmt::appender(text_), format, std::forward<Arguments>(arguments)...);
  }

  void line(const std::vector<Values>& columns, std::size_t atom) {
    for (const Values& column : columns) {
      std::visit([&](const auto& values) { put(values[atom]); }, column);
      text_.push_back(' ');
    }
    text_[text_.size() - 1] = '\n';
  }

  void put(double value) { fmt::format_to(fmt::appender(text_), FMT_COMPILE("{}"), value); }
  void put(std::int64_t value) { fmt::format_to(fmt::appender(text_), FMT_COMPILE("{}"), value); }
  void put(const std::string& word) {
    if (!is_word(word))
      throw InputError(fmt::format("{}: '{}' cannot be a word of a text dump: it is empty or has "
                                   "blanks", place_, word));
    text_.append(word);
  }

  void flush() {
    file_->write({text_.data(), text_.size()});
    text_.clear();
  }

  std::unique_ptr<ByteSink> file_;
  fmt::memory_buffer text_;
  std::vector<std::string> columns_;  ///< of the frame
  std::uint64_t atoms_left_ = 0;      ///< of the frame
  std::string place_;                 ///< of the frame
  std::optional<Units> units_;        ///< as they were stated last
};

}  // namespace

std::unique_ptr<FrameWriter> create_writer(const std::filesystem::path& path) {
  return std::make_unique<Writer>(path);
}

}  // namespace mdana::lammps_text
