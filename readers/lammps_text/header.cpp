// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/lammps_text/header.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

#include <Eigen/LU>
#include <fmt/format.h>

#include "readers/column_names.hpp"
#include "readers/input_error.hpp"
#include "readers/shown.hpp"

namespace mdana::lammps_text {
namespace {

std::vector<std::string> words(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

/// Reads the sections of one header; knows where it is for messages.
class HeaderReader {
 public:
  HeaderReader(LineReader& lines, const std::string& path, std::uint64_t index)
      : lines_(lines), path_(path) {
    header_.index = index;
  }

  std::optional<FrameHeader> read() {
    std::optional<std::string> item = first_item();
    if (!item) return std::nullopt;
    while (!item->starts_with("ITEM: ATOMS")) {
      section(*item);
      item = needed_line();
    }
    header_.columns = words(item->substr(11));
    check();
    header_.place =
        fmt::format("{} (frame {}, step {})", here(), header_.index, header_.step);
    return header_;
  }

 private:
  std::string here() const { return fmt::format("{}:{}", path_, lines_.number()); }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}: {}", here(), what));
  }

  /// The first line of the frame; nothing if only blank lines and comments are left.
  std::optional<std::string> first_item() {
    while (const auto line = lines_.line())
      if (!words(*line).empty() && !line->starts_with('#')) return std::string(*line);
    if (lines_.unfinished()) truncated();
    return std::nullopt;
  }

  std::string needed_line() {
    const auto line = lines_.line();
    if (!line) truncated();
    return std::string(*line);
  }

  [[noreturn]] void truncated() const {
    throw TruncatedInput(fmt::format("{}: the file ends in the header of frame {}", here(),
                                     header_.index));
  }

  template <class T>
  T number(const std::string& text) const {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
      fail(fmt::format("'{}' is not {}", shown(text),
                       std::is_integral_v<T> ? "a whole number in range" : "a number"));
    return value;
  }

  std::string only_word(std::string_view section) {
    const auto w = words(needed_line());
    if (w.size() != 1) fail(fmt::format("one value expected below ITEM: {}", section));
    return w[0];
  }

  void section(const std::string& item) {
    if (item.starts_with("ITEM: ")) only_once(item);
    if (item == "ITEM: TIMESTEP") {
      header_.step = number<std::int64_t>(only_word("TIMESTEP"));
      has_step_ = true;
    } else if (item == "ITEM: TIME") {
      header_.time = number<double>(only_word("TIME"));
    } else if (item == "ITEM: UNITS") {
      units(only_word("UNITS"));
    } else if (item == "ITEM: NUMBER OF ATOMS") {
      header_.atoms = number<std::uint64_t>(only_word("NUMBER OF ATOMS"));
      has_atoms_ = true;
    } else if (item.starts_with("ITEM: BOX BOUNDS")) {
      box(words(std::string_view(item).substr(16)));
    } else {
      fail(fmt::format("'{}' is not a section of a LAMMPS dump header; is the number of atoms of "
                       "the frame before right?", shown(item)));
    }
  }

  /// A header that was cut runs into the next frame's.
  void only_once(const std::string& item) {
    const std::string name = section_name(item);
    if (std::ranges::find(seen_, name) != seen_.end())
      fail(fmt::format("'{}' stands twice in one header", shown(item)));
    seen_.push_back(name);
  }

  void units(const std::string& text) {
    header_.units = parse_units(text);
    if (!header_.units) fail(fmt::format("unknown units '{}' (known: {})", shown(text), units_names()));
  }

  void box(const std::vector<std::string>& flags) {
    const bool abc = std::find(flags.begin(), flags.end(), "abc") != flags.end();
    const bool tilted = std::find(flags.begin(), flags.end(), "xy") != flags.end();
    const std::size_t width = abc ? 4 : tilted ? 3 : 2;
    Eigen::Matrix<double, 3, 4> rows = Eigen::Matrix<double, 3, 4>::Zero();
    for (int k = 0; k < 3; ++k) {
      const auto w = words(needed_line());
      if (w.size() != width) fail(fmt::format("{} numbers expected in the box bounds", width));
      for (std::size_t j = 0; j < width; ++j) rows(k, static_cast<int>(j)) = number<double>(w[j]);
      if (!rows.row(k).allFinite() || (!abc && !(rows(k, 1) > rows(k, 0))))
        fail("bounds of a box must be finite, and the upper one above the lower");
    }
    if (abc) {
      header_.box.edges = rows.leftCols<3>().transpose();
      header_.box.origin = rows.col(3);
    } else {
      header_.box = box_from_bounds(rows.col(0), rows.col(1), rows(0, 2), rows(1, 2), rows(2, 2));
    }
    const double volume = header_.box.edges.determinant();
    if (abc ? volume == 0 : !(volume > 0)) fail("the bounds and tilts are no box");
    periodicity(flags);
    has_box_ = true;
  }

  /// Boundary words such as pp, ff, fs, sm are the last three; old dumps have none.
  void periodicity(const std::vector<std::string>& flags) {
    if (flags.size() < 3) return;
    for (std::size_t k = 0; k < 3; ++k)
      header_.box.periodic[k] = flags[flags.size() - 3 + k] == "pp";
  }

  void check() const {
    if (!has_step_) fail("no ITEM: TIMESTEP before ITEM: ATOMS");
    if (!has_atoms_) fail("no ITEM: NUMBER OF ATOMS before ITEM: ATOMS");
    if (!has_box_) fail("no ITEM: BOX BOUNDS before ITEM: ATOMS");
    if (header_.columns.empty())
      fail("ITEM: ATOMS names no columns (dumps of LAMMPS before 2010 are not read)");
    if (const std::string wrong = wrong_names(header_.columns); !wrong.empty())
      fail(wrong + " (ITEM: ATOMS)");
  }

  LineReader& lines_;
  const std::string& path_;
  FrameHeader header_;
  std::vector<std::string> seen_;  ///< sections
  bool has_step_ = false;
  bool has_atoms_ = false;
  bool has_box_ = false;
};

}  // namespace

std::string section_name(std::string_view item) {
  item.remove_prefix(std::min(item.size(), section_start.size()));
  return std::string(item.substr(0, item.find_first_of(" \t")));
}

std::optional<FrameHeader> read_header(LineReader& lines, const std::string& path,
                                       std::uint64_t index) {
  return HeaderReader(lines, path, index).read();
}

}  // namespace mdana::lammps_text
