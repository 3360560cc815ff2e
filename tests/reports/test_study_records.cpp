// SPDX-License-Identifier: GPL-3.0-or-later
// What a study keeps of its runs, and the processes that they are analysed in.
#include <bit>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <new>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>
#include <unistd.h>

#include "analyses/frame_run.hpp"
#include "readers/input_error.hpp"
#include "reports/study/cache.hpp"
#include "reports/study/workers.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;

constexpr double inf = std::numeric_limits<double>::infinity();
const std::vector<double> hard{0.1, -0.0, 1.0 / 3, 5e-324, 1.7976931348623157e308, 1e21, 123456789012345678.0, 0x1.fffffffffffffp-1,
                               std::numeric_limits<double>::quiet_NaN(), inf, -inf};

class StudyRecords : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "mdana-records-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    directory_ = name;
  }
  void TearDown() override { fs::remove_all(directory_); }

  fs::path directory_;
};

/// Bit patterns, but one for all NaN.
std::vector<std::uint64_t> bits(std::span<const double> values) {
  std::vector<std::uint64_t> all;
  for (const double v : values) all.push_back(v == v ? std::bit_cast<std::uint64_t>(v) : 0x7ff8000000000000u);
  return all;
}

RunRecord a_record() {
  RunRecord record;
  record.document = {{"command", "report"}, {"frames", 7}, {"name", "σ \"quoted\"\n"}};
  record.numbers = {{"delta_max", {0.1, 1.0 / 3, dimension::length}}, {"e", {std::nan(""), {}, {}}}, {"p", {inf, inf, dimension::pressure}}};
  Table table;
  table.add_column({"F", dimension::force}, hard);
  table.add_column({"phase", {}, {"a", "b, c"}}, std::vector<double>(hard.size(), 1));
  record.tables = {{"frames", table}, {"none", Table({{"x", dimension::time}})}};
  record.figures = {{"force", "t", "x", "y", "alt", {{"s", hard, hard, Series::Style::dashed, {}}}, true, false, "delta", "F"}};
  record.parts = {{"mass1", {-0.0, {}, dimension::mass}}};
  record.snapshots = {{"start", 7, std::nan(""), -0.5, 1.1, 9, {{{{1, 2, 0}, {-3, 4.5, 0.5}}, {{0.125, 0, 0}}}}, 2.2, {{{{-1, 2, 3}}, {}}}}};
  record.views = {{"end", {{"hcp atoms", "#e0574f", 0.8, {{1, 2, 3}}}}, {{"Frank partials", "#00b0c0", "b", 2, {{0, 0, 1}, {0, 1, 1}}, true}},
                   {{"twin boundaries", "#3c8fd9", 4, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}, 3, 4}};
  return record;
}

TEST_F(StudyRecords, RecordsKeepEveryBit) {
  const RunCache cache(directory_);
  const nlohmann::ordered_json key{{"program", "x"}, {"files", {{"a", 1}}}};
  const RunRecord record = a_record();
  cache.store("run", key, record);
  EXPECT_EQ(cache.key("run"), key);
  const RunRecord read = cache.load("run");
  EXPECT_EQ(read.document, record.document);
  EXPECT_EQ(bits(read.table("frames")->column("F")), bits(hard));
  EXPECT_EQ(read.table("frames")->columns()[1].labels, record.tables[0].table.columns()[1].labels);
  EXPECT_EQ(read.table("frames")->columns()[0].dimension, dimension::force);
  EXPECT_EQ(read.table("none")->rows(), 0u);
  EXPECT_EQ(read.number("delta_max")->error, record.number("delta_max")->error);
  EXPECT_FALSE(read.number("e")->error);
  EXPECT_EQ(read.number("p")->value, inf);
  EXPECT_TRUE(std::signbit(read.parts[0].value.value));
  EXPECT_EQ(bits(read.figures[0].series[0].x), bits(hard));
  EXPECT_EQ(read.figures[0].series[0].style, Series::Style::dashed);
  EXPECT_TRUE(read.figures[0].log_x);
  EXPECT_TRUE(std::isnan(read.snapshots[0].time));
  EXPECT_EQ(read.snapshots[0].at, record.snapshots[0].at);
  EXPECT_EQ(std::tie(read.snapshots[0].step, read.snapshots[0].delta, read.snapshots[0].row, read.snapshots[0].strips),
            std::tie(record.snapshots[0].step, record.snapshots[0].delta, record.snapshots[0].row, record.snapshots[0].strips));
  EXPECT_EQ(view_json({"", "", "", "", read.views}), view_json({"", "", "", "", record.views}));
}

// Every byte counts: a record that is changed anywhere, or cut anywhere, is no record.
TEST_F(StudyRecords, DamagedRecordsAreNotTaken) {
  const RunCache cache(directory_);
  cache.store("run", {{"program", "x"}}, a_record());
  std::ostringstream stream;
  stream << std::ifstream(directory_ / "run.run", std::ios::binary).rdbuf();
  const std::string whole = stream.str();
  for (std::size_t at = 0; at < whole.size(); at += 7) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    for (const std::string& text : {changed, whole.substr(0, at)}) {
      std::ofstream(directory_ / "run.run", std::ios::binary) << text;
      EXPECT_FALSE(cache.key("run")) << at;
      EXPECT_THROW(cache.load("run"), InputError) << at;
    }
  }
  EXPECT_FALSE(cache.key("another"));
}

TEST_F(StudyRecords, OnlyRunsOfTheStudyAreKept) {
  const RunCache cache(directory_);
  for (const char* name : {"a", "b"}) cache.store(name, {}, a_record());
  std::ofstream(directory_ / ".123.part.a.run") << "left by one that was killed";
  std::ofstream(directory_ / "hashes.json") << "{}";
  cache.keep_only({"a"});
  std::vector<std::string> left;
  for (const auto& entry : fs::directory_iterator(directory_)) left.push_back(entry.path().filename().string());
  std::ranges::sort(left);
  EXPECT_EQ(left, (std::vector<std::string>{"a.run", "hashes.json"}));
}

TEST_F(StudyRecords, OneWorkThatFailsOrCrashesDoesNotStopTheOthers) {
  std::vector<Work> works{[] { throw std::runtime_error("no dump"); }, [] { ::raise(SIGKILL); }, [] { throw std::bad_alloc(); },
                          [] { ::_exit(9); }, [] { throw std::runtime_error(std::string(100000, 'x')); },
                          [this] { std::ofstream(directory_ / "done") << "yes"; }};
  for (const std::size_t jobs : {1, 3}) {
    fs::remove(directory_ / "done");
    std::vector<std::string> failures(works.size(), "not told");
    run_in_processes(works, jobs, nullptr, [&](const WorkDone& done) { failures[done.index] = done.failure; });
    EXPECT_EQ(failures[0], "no dump");
    EXPECT_NE(failures[1].find("signal 9"), std::string::npos) << failures[1];
    EXPECT_EQ(failures[2], "not enough memory");
    EXPECT_FALSE(failures[3].empty());
    EXPECT_EQ(failures[4].substr(0, 10), "xxxxxxxxxx");
    EXPECT_EQ(failures[5], "");
    EXPECT_TRUE(fs::exists(directory_ / "done"));
  }
}

// The first ends by itself, and with it comes the signal, which the second, long one must not outlive.
TEST_F(StudyRecords, AStopEndsTheWorksThatAreRunning) {
  const std::vector<Work> works{[] {}, [] { ::sleep(600); }};
  std::atomic<int> stop{0};
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(run_in_processes(works, 2, &stop, [&](const WorkDone&) { stop = SIGINT; }), Interrupted);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

}  // namespace
}  // namespace mdana
