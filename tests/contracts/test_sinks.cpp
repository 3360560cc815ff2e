// SPDX-License-Identifier: GPL-3.0-or-later
// What every sink of the list must keep.
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "reports/sink.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana {
namespace {

TEST(Sinks, HaveNamesSummariesAndEndingsOfTheirOwn) {
  std::set<std::string_view> names, endings;
  for (const Sink* sink : sinks()) {
    EXPECT_TRUE(names.insert(sink->name).second) << sink->name;
    EXPECT_TRUE(endings.insert(sink->ending).second) << sink->ending;
    EXPECT_TRUE(sink->ending.starts_with('.')) << sink->ending;
    EXPECT_FALSE(sink->summary.empty()) << sink->name;
  }
  EXPECT_FALSE(names.empty());
}

// A table without rows, and a folder in the way: a file whole, or an error and nothing besides.
TEST(Sinks, WriteWholeOrNotAtAll) {
  const test::TemporaryFolder folder;
  const Document document("test");
  const Table table({{"a", dimension::length}, {"phase", dimension::none, {"loading", "unloading"}}});
  for (const Sink* sink : sinks()) {
    const auto path = folder.path() / ("a" + std::string(sink->ending));
    sink->write(path, document, &table);
    EXPECT_GT(std::filesystem::file_size(path), 0u) << sink->name;
    std::filesystem::remove(path);
    std::filesystem::create_directory(path);
    EXPECT_THROW(sink->write(path, document, &table), std::runtime_error) << sink->name;
    std::filesystem::remove(path);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << sink->name;
  }
}

}  // namespace
}  // namespace mdana
