// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/lammps_binary/header.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <Eigen/LU>

#include "readers/column_names.hpp"
#include "readers/lammps_binary/byte_order.hpp"
#include "readers/shown.hpp"

namespace mdana::lammps_binary {
namespace {

// Of the texts in a header, in bytes: more is a sign of damage.
constexpr int longest_name = 32;
constexpr int longest_units = 32;
constexpr int longest_columns = 1 << 20;

constexpr const char* no_header =
    "no header of a LAMMPS binary dump begins here; is the number of atoms of the frame before "
    "right?";
constexpr const char* nameless =
    "this binary dump does not name its columns (LAMMPS before October 2020); write their names, as "
    "in the command dump, to a file of its name and '.columns' beside it";

/// The length of the name at the start of a header, which LAMMPS writes negated where the step was.
std::optional<int> name_length(const char* marker, bool swapped) {
  const auto value = load<std::int64_t>(marker, swapped);
  if (value >= 0 || value < -longest_name) return std::nullopt;
  return static_cast<int>(-value);
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

/// The names of the columns of a dump that does not tell them: of the file <dump>.columns.
std::vector<std::string> stated_columns(const std::string& dump) {
  std::ifstream stream(dump + ".columns");
  std::string text(std::min<std::size_t>(longest_columns, 1 << 16), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return words(text);
}

/// Old header in one byte order: step, atoms, triclinic, six boundaries, six bounds.
constexpr std::size_t old_header_size = 92;

bool is_old_header(const char* head, bool swapped) {
  if (load<std::int64_t>(head, swapped) < 0 || load<std::int64_t>(head + 8, swapped) < 0)
    return false;
  const auto kind = [&](int k) { return load<std::int32_t>(head + 16 + 4 * k, swapped); };
  if (kind(0) < 0 || kind(0) > 1) return false;
  for (int k = 1; k <= 6; ++k)
    if (kind(k) < 0 || kind(k) > 3) return false;
  for (int k = 0; k < 3; ++k) {
    const auto lo = load<double>(head + 44 + 16 * k, swapped);
    const auto hi = load<double>(head + 52 + 16 * k, swapped);
    if (!std::isfinite(lo) || !std::isfinite(hi) || !(hi > lo)) return false;
  }
  return true;
}

/// Reads the fields of one header.
class HeaderReader {
 public:
  HeaderReader(Stretches& file, std::uint64_t index) : file_(file) { header_.frame.index = index; }

  std::optional<Header> read() {
    if (!marker()) return std::nullopt;
    if (name_length_ > 0) {
      name();
      order_and_revision();
      frame().step = number<std::int64_t>();
    }
    atoms();
    box();
    const auto columns_of_atom = number<std::int32_t>();
    if (name_length_ > 0) {
      units();
      time();
      named_columns();
    }
    columns(columns_of_atom);
    header_.ranks = number<std::int32_t>();
    if (header_.ranks < 1)
      file_.fail(fmt::format("the atoms come in {} blocks (one a rank)", header_.ranks));
    frame().place =
        fmt::format("{} (frame {}, step {})", file_.path(), frame().index, frame().step);
    return header_;
  }

 private:
  FrameHeader& frame() { return header_.frame; }

  void needed(std::span<char> into) {
    const std::size_t known = std::min(into.size(), ahead_.size());
    std::copy_n(ahead_.begin(), known, into.begin());
    ahead_.erase(0, known);
    into = into.subspan(known);
    if (file_.read(into) < into.size())
      file_.ended(fmt::format("in the header of frame {}", frame().index));
  }

  template <class T>
  T number() {
    std::array<char, sizeof(T)> bytes;
    needed(bytes);
    return load<T>(bytes.data(), header_.swapped);
  }

  double finite(std::string_view what) {
    const auto value = number<double>();
    if (!std::isfinite(value)) file_.fail(fmt::format("{} is {}", what, value));
    return value;
  }

  std::string text(int length) {
    std::string bytes(static_cast<std::size_t>(length), '\0');
    needed(bytes);
    return bytes;
  }

  std::string text(std::string_view what, int longest) {
    const auto length = number<std::int32_t>();
    if (length < 0 || length > longest)
      file_.fail(fmt::format("{} in {} bytes (0 to {} expected)", what, length, longest));
    return text(length);
  }

  /// False at a clean end of the file.
  bool marker() {
    std::array<char, 8> bytes;
    const std::size_t got = file_.read(bytes);
    if (got == 0) return false;
    if (got < bytes.size()) file_.ended(fmt::format("in the header of frame {}", frame().index));
    header_.swapped = !name_length(bytes.data(), false);
    const auto length = name_length(bytes.data(), header_.swapped);
    if (length)
      name_length_ = *length;
    else
      old_header({bytes.data(), bytes.size()});
    return true;
  }

  /// Its fields are those of the new one from the step on, but for the names and what follows them.
  void old_header(std::string_view first_bytes) {
    frame().columns = stated_columns(file_.path());
    if (frame().columns.empty()) file_.fail(frame().index == 0 ? nameless : no_header);
    std::string head(first_bytes);
    head.resize(old_header_size);
    needed({head.data() + first_bytes.size(), old_header_size - first_bytes.size()});
    header_.swapped = !is_old_header(head.data(), false);
    if (!is_old_header(head.data(), header_.swapped)) file_.fail(no_header);
    frame().step = load<std::int64_t>(head.data(), header_.swapped);
    ahead_ = head.substr(first_bytes.size());
  }

  void name() {
    const std::string name = text(name_length_);
    if (name == "DUMPCUSTOM" || name == "DUMPATOM") return;
    if (!name.starts_with("DUMP")) file_.fail(no_header);
    file_.fail(
        fmt::format("'{}': of LAMMPS' binary dumps only those of the styles custom and atom "
                    "are read",
                    shown(name)));
  }

  void order_and_revision() {
    if (const auto mark = number<std::int32_t>(); mark != 1)
      file_.fail(fmt::format("the mark of the byte order is {:#x}, not 1", mark));
    const auto revision = number<std::int32_t>();
    if (revision < 1) file_.fail(fmt::format("revision {} of the format", revision));
    if (revision == 1) file_.fail(nameless);
    if (revision > 2)
      file_.fail(fmt::format("revision {} of the format; revision 2 is read", revision));
  }

  void atoms() {
    const auto atoms = number<std::int64_t>();
    if (atoms < 0) file_.fail(fmt::format("the number of atoms is {}", atoms));
    frame().atoms = static_cast<std::uint64_t>(atoms);
  }

  void box() {
    const auto triclinic = number<std::int32_t>();
    const auto boundaries = periodicity();
    if (triclinic == 0 || triclinic == 1)
      bounds(triclinic == 1);
    else if (triclinic == 2)
      edges();
    else
      file_.fail(
          fmt::format("the box is of kind {} (0 orthogonal, 1 tilted, 2 general)", triclinic));
    frame().box.periodic = boundaries;
  }

  std::array<bool, 3> periodicity() {
    std::array<bool, 3> periodic;
    for (bool& axis : periodic) {
      const auto low = number<std::int32_t>(), high = number<std::int32_t>();
      if (std::min(low, high) < 0 || std::max(low, high) > 3)
        file_.fail(fmt::format("boundaries of kind {} and {} (0 p, 1 f, 2 s, 3 m)", low, high));
      axis = low == 0 && high == 0;
    }
    return periodic;
  }

  void bounds(bool tilted) {
    Eigen::Vector3d lo, hi, tilts = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      lo[k] = finite("a bound of the box");
      hi[k] = finite("a bound of the box");
      if (!(hi[k] > lo[k]))
        file_.fail(
            fmt::format("the box's upper bound {} is not above the lower one {}", hi[k], lo[k]));
    }
    if (tilted)
      for (double& tilt : tilts) tilt = finite("a tilt of the box");
    frame().box = box_from_bounds(lo, hi, tilts[0], tilts[1], tilts[2]);
    if (!(frame().box.edges.determinant() > 0)) file_.fail("the bounds and tilts are no box");
  }

  void edges() {
    for (int k = 0; k < 3; ++k)
      for (double& component : frame().box.edges.col(k)) component = finite("an edge of the box");
    for (double& component : frame().box.origin) component = finite("the origin of the box");
    if (!(std::abs(frame().box.edges.determinant()) > 0)) file_.fail("the edges are no box");
  }

  void units() {
    const std::string name = text("the name of the units", longest_units);
    if (name.empty()) return;
    frame().units = parse_units(name);
    if (!frame().units)
      file_.fail(fmt::format("unknown units '{}' (known: {})", shown(name), units_names()));
  }

  void time() {
    const auto flag = number<char>();
    if (flag != 0 && flag != 1)
      file_.fail(fmt::format("the mark of a stated time is {}, not 0 or 1", int{flag}));
    if (flag == 1) frame().time = finite("the time");
  }

  void named_columns() {
    frame().columns = words(text("the names of the columns", longest_columns));
    if (frame().columns.empty()) file_.fail(nameless);
  }

  void columns(int columns_of_atom) {
    if (static_cast<std::int64_t>(frame().columns.size()) != columns_of_atom)
      file_.fail(fmt::format("{} columns are named, but an atom has {} numbers",
                             frame().columns.size(), columns_of_atom));
    if (const std::string wrong = wrong_names(frame().columns); !wrong.empty()) file_.fail(wrong);
  }

  Stretches& file_;
  Header header_;
  int name_length_ = 0;  ///< 0: an old header, without
  std::string ahead_;    ///< bytes of it that were read to tell its byte order
};

}  // namespace

std::optional<Header> read_header(Stretches& file, std::uint64_t index) {
  return HeaderReader(file, index).read();
}

bool begins_header(std::string_view head) {
  return head.size() >= 12 && head.substr(8).starts_with("DUMP") &&
         (name_length(head.data(), false) || name_length(head.data(), true));
}

bool begins_old_header(std::string_view head) {
  return head.size() >= old_header_size &&
         (is_old_header(head.data(), false) || is_old_header(head.data(), true));
}

}  // namespace mdana::lammps_binary
