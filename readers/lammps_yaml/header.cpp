// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/lammps_yaml/header.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include <fmt/format.h>

#include "readers/flow_list.hpp"
#include "readers/column_names.hpp"
#include "readers/input_error.hpp"
#include "readers/shown.hpp"

namespace mdana::lammps_yaml {
namespace {

bool blank_or_comment(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.empty() || text.front() == '#';
}

/// "keywords: [ ... ]", "data: [ ... ]": what LAMMPS lists of its thermo output.
bool is_named_list(std::string_view item) {
  const std::size_t colon = item.find(':');
  return colon != std::string_view::npos && bracketed(item.substr(colon + 1));
}

const std::set<std::string_view> known{"creator",  "timestep", "units", "time",    "natoms",
                                       "boundary", "thermo",   "box",   "keywords"};

/// Reads the entries of one header; knows where it is for messages.
class HeaderReader {
 public:
  HeaderReader(LineReader& lines, const std::string& path, std::uint64_t index)
      : lines_(lines), path_(path) {
    header_.index = index;
  }

  std::optional<FrameHeader> read() {
    if (!begin()) return std::nullopt;
    for (std::string line = needed_line(); line != "data:"; line = needed_line()) entry(line);
    finish();
    header_.place = fmt::format("{} (frame {}, step {})", here(), header_.index, header_.step);
    return header_;
  }

 private:
  std::string here() const { return fmt::format("{}:{}", path_, lines_.number()); }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}: {}", here(), what));
  }

  [[noreturn]] void truncated() const {
    throw TruncatedInput(
        fmt::format("{}: the file ends in the header of frame {}", here(), header_.index));
  }

  /// Passes over the end of the frame before and the "---" of this one; false if there is none.
  bool begin() {
    bool ended = header_.index == 0;
    while (const auto line = lines_.line()) {
      if (blank_or_comment(*line)) continue;
      const std::string_view text = trimmed(*line);
      if (text == "---") return true;
      if (text != "..." || ended)
        fail(fmt::format("'{}' where a frame should begin with '---'; is natoms of the frame "
                         "before right?", shown(text)));
      ended = true;
    }
    if (lines_.unfinished()) truncated();
    if (!ended)
      throw TruncatedInput(fmt::format("{}: the file ends behind the atoms of frame {}, without "
                                       "'...'; the frame is whole", here(), header_.index - 1));
    return false;
  }

  std::string needed_line() {
    const auto line = lines_.line();
    if (!line) truncated();
    std::string text(*line);
    while (!text.empty() && is_blank(text.back())) text.pop_back();
    return text;
  }

  /// "name: value", or an item of the entry before.
  void entry(const std::string& line) {
    if (const auto item = list_item(line)) return list(*item);
    const std::size_t colon = std::min(line.find(':'), line.size());
    entry_ = line.substr(0, colon);
    if (colon == line.size() || !known.contains(entry_))
      fail(fmt::format("'{}' is not a line of a LAMMPS YAML dump's header; is natoms of the frame "
                       "before right?", shown(line)));
    if (!seen_.insert(entry_).second) fail(fmt::format("'{}' stands twice", entry_));
    value(std::string(trimmed(std::string_view(line).substr(colon + 1))));
  }

  void value(const std::string& text) {
    if (entry_ == "timestep") {
      header_.step = number<std::int64_t>(text);
    } else if (entry_ == "natoms") {
      header_.atoms = number<std::uint64_t>(text);
    } else if (entry_ == "time") {
      header_.time = number<double>(text);
    } else if (entry_ == "units") {
      header_.units = parse_units(text);
      if (!header_.units) fail(fmt::format("unknown units '{}' (known: {})", shown(text), units_names()));
    } else if (entry_ == "boundary") {
      periodicity(words(text));
    } else if (entry_ == "keywords") {
      columns(words(text));
    } else if (entry_ != "creator" && !text.empty()) {
      fail(fmt::format("a list expected below '{}:'", entry_));
    }
  }

  void list(std::string_view item) {
    if (entry_ == "box" && box_.size() < 4) {
      box_.push_back(words(item));
    } else if (entry_ != "thermo" || !is_named_list(item)) {
      fail(fmt::format("'- {}' is not an item of '{}:'", shown(item), entry_));
    }
  }

  std::vector<std::string> words(std::string_view text) const {
    auto found = flow_list(text);
    if (!found) fail(fmt::format("'{}' is not a list [ ... ] on one line", shown(text)));
    return *std::move(found);
  }

  template <class T>
  T number(const std::string& text) const {
    T result{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
    if (error != std::errc{} || end != text.data() + text.size())
      fail(fmt::format("'{}' of '{}:' is not {}", shown(text), entry_,
                       std::is_integral_v<T> ? "a whole number in range" : "a number"));
    return result;
  }

  /// Lower and upper boundary of x, y, z: p(eriodic), f(ixed), s(hrink-wrapped), m(inimum).
  void periodicity(const std::vector<std::string>& faces) {
    if (faces.size() != 6) fail("six letters expected in 'boundary:'");
    for (std::size_t k = 0; k < 3; ++k)
      header_.box.periodic[k] = faces[2 * k] == "p" && faces[2 * k + 1] == "p";
  }

  void columns(std::vector<std::string> names) {
    if (const std::string wrong = wrong_names(names); !wrong.empty()) fail(wrong + " ('keywords:')");
    if (names.empty()) fail("'keywords:' names no columns");
    header_.columns = std::move(names);
  }

  /// Row k of the box as numbers.
  template <int count>
  Eigen::Vector<double, count> box_row(std::size_t k) const {
    if (box_[k].size() != count)
      fail(fmt::format("row {} of 'box:' has {} numbers, not {}", k + 1, box_[k].size(), count));
    Eigen::Vector<double, count> row;
    for (int j = 0; j < count; ++j) row[j] = number<double>(box_[k][static_cast<std::size_t>(j)]);
    if (!row.allFinite()) fail("the bounds and tilts of a box must be finite");
    return row;
  }

  void make_box() {
    if (box_.size() < 3) fail(fmt::format("{} of 3 rows of bounds in 'box:'", box_.size()));
    Eigen::Vector3d lo, hi, tilt = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const auto bounds = box_row<2>(static_cast<std::size_t>(k));
      lo[k] = bounds[0];
      hi[k] = bounds[1];
    }
    if (box_.size() == 4) tilt = box_row<3>(3);
    const auto periodic = header_.box.periodic;
    header_.box = box_from_bounds(lo, hi, tilt[0], tilt[1], tilt[2]);
    header_.box.periodic = periodic;
    const Eigen::Matrix3d& edges = header_.box.edges;
    if (!edges.allFinite() || !(edges.diagonal().array() > 0).all())
      fail("the bounds and tilts are no box");
  }

  void finish() {
    for (const char* name : {"timestep", "natoms", "boundary", "box", "keywords"})
      if (!seen_.contains(name)) fail(fmt::format("no '{}:' before 'data:'", name));
    entry_ = "box";
    make_box();
  }

  LineReader& lines_;
  const std::string& path_;
  FrameHeader header_;
  std::string entry_;  ///< whose items may follow
  std::set<std::string> seen_;
  std::vector<std::vector<std::string>> box_;  ///< three bounds, and the tilts if any
};

}  // namespace

std::optional<FrameHeader> read_header(LineReader& lines, const std::string& path,
                                       std::uint64_t index) {
  return HeaderReader(lines, path, index).read();
}

bool begins_header(std::string_view head) {
  bool begun = false;
  while (!head.empty()) {
    const std::size_t end = std::min(head.find('\n'), head.size());
    const std::string_view line = head.substr(0, end);
    if (begun) return trimmed(line).starts_with("creator: LAMMPS");
    begun = trimmed(line) == "---";
    if (!begun && !blank_or_comment(line)) return false;
    head.remove_prefix(std::min(end + 1, head.size()));
  }
  return false;
}

}  // namespace mdana::lammps_yaml
