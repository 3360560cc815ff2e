// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "analyses/check.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana::test {

inline constexpr int atoms = 4, header_lines = 9, frame_lines = header_lines + atoms, frames = 5;

/// Five frames of four atoms in a periodic box; frame f begins at line 13 f + 1.
inline std::vector<std::string> made_up() {
  std::vector<std::string> lines;
  for (int f = 0; f < frames; ++f) {
    for (const char* line : {"ITEM: TIMESTEP", "", "ITEM: NUMBER OF ATOMS", "4",
                             "ITEM: BOX BOUNDS pp pp ff", "0 10", "-5 5", "0 20",
                             "ITEM: ATOMS id type mass x y z vx"})
      lines.push_back(line);
    lines[lines.size() - 8] = std::to_string(100 * f);
    for (int a = 0; a < atoms; ++a)
      lines.push_back(fmt::format("{} 1 1.5 {}.25 {}.5 {}.125 -0.5", 10 * (a + 1), a, a, f));
  }
  return lines;
}

/// From 0, as an index: a line of the frame's header, or of its atoms.
inline int header_line(int frame, int line) { return frame_lines * frame + line; }
inline int atom_line(int frame, int atom) { return frame_lines * frame + header_lines + atom; }

inline std::string joined(const std::vector<std::string>& lines, const std::string& end = "\n") {
  std::string text;
  for (const std::string& line : lines) text += line + end;
  return text;
}

struct Told {
  std::string kind;
  std::optional<std::uint64_t> line;
  std::optional<std::uint64_t> frame;

  bool operator==(const Told&) const = default;
};

inline std::ostream& operator<<(std::ostream& out, const Told& told) {
  return out << told.kind << " line " << told.line.value_or(0) << " frame "
             << told.frame.value_or(999);
}

inline std::vector<Told> told(const CheckResult& result) {
  std::vector<Told> all;
  for (const Fault& fault : result.faults.kept())
    all.push_back({std::string(words_of(fault.kind).name), fault.line, fault.frame});
  return all;
}

class Check : public ::testing::Test {
 protected:
  CheckResult check(const std::string& text, const CheckOptions& options = {},
                    const std::string& name = "dump") {
    return check_dump(folder_.write(name, text), options);
  }

  CheckResult check_lines(const CheckOptions& options = {}) { return check(joined(lines_), options); }

  /// Exactly these faults.
  void expect(const std::vector<Told>& wanted) {
    for (const std::size_t threads : {1u, 3u}) {
      CheckOptions options;
      options.threads = threads;
      const CheckResult result = check_lines(options);
      EXPECT_EQ(told(result), wanted);
      EXPECT_TRUE(result.to_the_end);
    }
  }

  /// Another word in a column of an atom line; the line's number.
  std::uint64_t replace(int frame, int atom, int column, const std::string& word) {
    std::string& line = lines_[atom_line(frame, atom)];
    std::size_t start = 0;
    for (int k = 0; k < column; ++k) start = line.find(' ', start) + 1;
    line.replace(start, std::min(line.find(' ', start), line.size()) - start, word);
    return atom_line(frame, atom) + 1u;
  }

  test::TemporaryFolder folder_;
  std::vector<std::string> lines_ = made_up();
};

}  // namespace mdana::test
