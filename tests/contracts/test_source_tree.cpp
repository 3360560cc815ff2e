// SPDX-License-Identifier: GPL-3.0-or-later
// Rules about the source files themselves: include direction, what public headers show, licences.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace mdana {
namespace {

namespace fs = std::filesystem;

const fs::path root = MDANA_SOURCE_DIR;
const std::vector<std::string> rooms{"readers", "analyses", "fits", "reports"};

bool is_source(const fs::path& file) {
  return file.extension() == ".cpp" || file.extension() == ".hpp";
}

/// All files below a folder, without hidden and build folders.
std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (auto it = fs::recursive_directory_iterator(folder); it != fs::end(it); ++it) {
    const std::string name = it->path().filename().string();
    const bool skip = name[0] == '.' || name.starts_with("build") || name == "__pycache__";
    if (skip && it->is_directory()) it.disable_recursion_pending();
    if (!skip && it->is_regular_file()) files.push_back(it->path());
  }
  return files;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

struct Include {
  std::string name;
  bool own;  ///< in quotes
};

std::vector<Include> includes_of(const fs::path& file) {
  static const std::regex pattern(R"(\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::vector<Include> includes;
  for (const std::string& line : lines_of(file))
    if (std::smatch match; std::regex_match(line, match, pattern))
      includes.push_back({match[2], match[1] == "\""});
  return includes;
}

TEST(SourceTree, RoomsIncludeNothingToTheirRight) {
  std::size_t seen = 0;
  for (std::size_t room = 0; room < rooms.size(); ++room)
    for (const fs::path& file : files_below(root / rooms[room])) {
      if (!is_source(file)) continue;
      ++seen;
      for (const Include& include : includes_of(file)) {
        for (std::size_t right = room + 1; right < rooms.size(); ++right)
          EXPECT_FALSE(include.name.starts_with(rooms[right] + "/"))
              << file << ": " << include.name;
        EXPECT_FALSE(include.name.starts_with("tests/")) << file << ": " << include.name;
        EXPECT_FALSE(include.name.starts_with(".")) << file << ": " << include.name;
      }
    }
  EXPECT_GT(seen, 50u);
}

/// The room and the folder in it of a file, whatever is below that.
fs::path member_of(const fs::path& file) { return *file.begin() / *std::next(file.begin()); }

// A header in a member's folder, or below it, is private to that member.
TEST(SourceTree, MembersHeadersAreTheirOwn) {
  for (const std::string& room : rooms)
    for (const fs::path& file : files_below(root / room)) {
      if (!is_source(file)) continue;
      for (const Include& include : includes_of(file)) {
        const fs::path header = include.name;
        const bool member_header = include.own && std::distance(header.begin(), header.end()) > 2;
        if (!member_header || !fs::exists(root / header)) continue;
        EXPECT_EQ(member_of(header), member_of(fs::relative(file, root))) << file << ": " << include.name;
      }
    }
}

const std::set<std::string> posix{"unistd.h", "fcntl.h", "signal.h"};

TEST(SourceTree, PublicHeadersShowOnlyTheStandardLibraryAndEigen) {
  for (const std::string room : {"readers", "analyses", "fits"})
    for (const auto& entry : fs::directory_iterator(root / room)) {
      if (entry.path().extension() != ".hpp") continue;
      for (const Include& include : includes_of(entry.path())) {
        const bool standard = !include.own && include.name.find_first_of("./") == std::string::npos;
        const bool eigen = !include.own && include.name.starts_with("Eigen/");
        EXPECT_TRUE(include.own || standard || eigen) << entry.path() << ": " << include.name;
        EXPECT_FALSE(posix.contains(include.name)) << entry.path() << ": " << include.name;
      }
    }
}

bool needs_licence(const fs::path& file) {
  const std::string extension = file.extension().string();
  if (is_source(file) || extension == ".py" || extension == ".sh" || extension == ".cmake" ||
      file.filename() == "CMakeLists.txt")
    return true;
  const auto lines = lines_of(file);
  return extension.empty() && !lines.empty() && lines[0].starts_with("#!");
}

TEST(SourceTree, SourcesStateTheirLicence) {
  std::size_t seen = 0;
  for (const std::string folder :
       {"readers", "analyses", "fits", "reports", "sample-data", "tests"})
    for (const fs::path& file : files_below(root / folder)) {
      if (!needs_licence(file)) continue;
      ++seen;
      const auto lines = lines_of(file);
      const bool stated = std::any_of(
          lines.begin(), lines.begin() + static_cast<long>(std::min<std::size_t>(3, lines.size())),
          [](const std::string& line) {
            return line.find("SPDX-License-Identifier: GPL-3.0-or-later") != std::string::npos;
          });
      EXPECT_TRUE(stated) << file;
    }
  EXPECT_GT(seen, 100u);
}

TEST(SourceTree, BuildFileStatesItsLicence) {
  EXPECT_NE(lines_of(root / "CMakeLists.txt").at(0).find("SPDX-License-Identifier"),
            std::string::npos);
}

}  // namespace
}  // namespace mdana
