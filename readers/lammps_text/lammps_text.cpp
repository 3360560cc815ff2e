// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "readers/atom_lines.hpp"
#include "readers/format.hpp"
#include "readers/lammps_text/header.hpp"
#include "readers/lammps_text/writer.hpp"
#include "readers/word_lines.hpp"

namespace mdana {
namespace {

using lammps_text::section_name;
using lammps_text::section_start;

/// From the beginning of a faulty header to that of the next one; false if there is none.
bool to_next_header(LineReader& lines) {
  std::vector<std::string> seen;
  const auto has_seen = [&](std::string_view name) {
    return std::ranges::find(seen, name) != seen.end();
  };
  while (true) {
    lines.skip(std::numeric_limits<std::size_t>::max(), section_start);
    const auto item = lines.peek();
    if (!item) return false;
    const std::string name = section_name(*item);
    const bool early = name == "TIMESTEP" || name == "TIME" || name == "UNITS";
    if (has_seen(name) || has_seen("ATOMS") ||
        (early && (has_seen("NUMBER") || has_seen("BOX"))))
      return true;
    seen.push_back(name);
    lines.line();
  }
}

/// The first line that is neither blank nor a comment begins with ITEM.
bool recognises(std::string_view head) {
  while (!head.empty()) {
    const std::size_t start = head.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos) return false;
    head.remove_prefix(start);
    if (head.front() != '#') return head.starts_with("ITEM: ");
    head.remove_prefix(std::min(head.find('\n'), head.size()));
  }
  return false;
}

std::shared_ptr<const FrameLayout> layout(const FrameHeader& header, const ColumnSet& wanted,
                                          const std::string& path) {
  return std::make_shared<WordLines>(header, wanted, path);
}

std::unique_ptr<FrameSource> open(std::unique_ptr<ByteSource> bytes,
                                  const std::filesystem::path& path, const ColumnSet& wanted) {
  return open_atom_lines(
      {lammps_text::read_header, layout, section_start, to_next_header},
      std::move(bytes), path, wanted);
}

}  // namespace

extern const Format lammps_text_format;
const Format lammps_text_format{
    "lammps_text",
    "LAMMPS text dump (styles atom and custom)",
    recognises,
    open,
    "lammpstrj lammpstrj.gz lammpstrj.zst dump dump.gz dump.zst",
    lammps_text::create_writer};

}  // namespace mdana
