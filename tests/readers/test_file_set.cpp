// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/file_set.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "readers/raw_file.hpp"
#include "tests/readers/gzipped.hpp"
#include "tests/readers/read_all.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

constexpr std::size_t capacity = AtomBlock::capacity;

/// Atoms of one piece: ids from `first` on, and a column q = id/8 with three decimals.
std::string piece(long step, std::size_t first, std::size_t atoms, const std::string& q = "q",
                  const std::string& width = "1") {
  std::string text = "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ATOMS\n" +
                     std::to_string(atoms) + "\nITEM: BOX BOUNDS ff ff ff\n0 " + width +
                     "\n0 1\n0 1\nITEM: ATOMS id " + q + "\n";
  const char* eighths[] = {".000", ".125", ".250", ".375", ".500", ".625", ".750", ".875"};
  for (std::size_t id = first; id < first + atoms; ++id)
    text += std::to_string(id) + " " + std::to_string(id / 8) + eighths[id % 8] + "\n";
  return text;
}

std::vector<std::string> names(const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> all;
  for (const auto& file : files) all.push_back(file.filename().string());
  return all;
}

void expect_same(const test::WholeTrajectory& found, const test::WholeTrajectory& wanted) {
  EXPECT_EQ(found.error, wanted.error);
  ASSERT_EQ(found.frames.size(), wanted.frames.size());
  for (std::size_t k = 0; k < wanted.frames.size(); ++k) {
    SCOPED_TRACE(k);
    const auto &a = found.frames[k], &b = wanted.frames[k];
    EXPECT_EQ(a.header.index, b.header.index);
    EXPECT_EQ(a.header.step, b.header.step);
    EXPECT_EQ(a.header.atoms, b.header.atoms);
    EXPECT_EQ(a.header.columns, b.header.columns);
    EXPECT_EQ(a.block_atoms, b.block_atoms);
    EXPECT_TRUE(a.integer == b.integer);
    EXPECT_TRUE(a.real == b.real);
  }
}

class FileSets : public ::testing::Test {
 protected:
  std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }
  test::WholeTrajectory read(const std::string& name) const {
    return test::read_all(at(name), {"id", "q"});
  }
  test::TemporaryFolder folder_;
};

TEST_F(FileSets, StepsAreInTheOrderOfNumbers) {
  for (const char* name : {"d.10.t", "d.9.t", "d.0100.t", "d.x.t", "d.5.t.gz", "d.-1.t", "d..t",
                           "ad.3.t", "d.18446744073709551616.t", "d.5000000000.t"})
    folder_.write(name, "");
  const auto set = find_file_set(at("d.*.t"));
  ASSERT_TRUE(set);
  std::vector<std::string> found;
  for (const auto& step : *set) {
    ASSERT_EQ(step.size(), 1u);
    found.push_back(names(step)[0]);
  }
  EXPECT_EQ(found, (std::vector<std::string>{"d.9.t", "d.10.t", "d.0100.t", "d.5000000000.t"}));
}

TEST_F(FileSets, PiecesStandTogether) {
  for (int step : {20, 3})
    for (int k = 0; k < 12; ++k)
      folder_.write("d_" + std::to_string(k) + "." + std::to_string(step), "");
  const auto set = find_file_set(at("d_%.*"));
  ASSERT_TRUE(set);
  ASSERT_EQ(set->size(), 2u);
  EXPECT_EQ(set->at(0).size(), 12u);
  EXPECT_EQ(names(set->at(0))[2], "d_2.3");
  EXPECT_EQ(names(set->at(1))[10], "d_10.20");
}

TEST_F(FileSets, AFileOfThatVeryNameIsAFile) {
  folder_.write("d.1.t", "");
  EXPECT_FALSE(find_file_set(folder_.write("d.*.t", "")));
  EXPECT_FALSE(find_file_set(folder_.write("100%", "")));
  EXPECT_FALSE(find_file_set(at("none")));
}

TEST_F(FileSets, NamesThatMeanNothingAreErrors) {
  folder_.write("d.1.t", "");
  EXPECT_INPUT_ERROR(find_file_set(at("e.*.t")), "e.*.t", "no file of this name", "'*'");
  EXPECT_INPUT_ERROR(find_file_set(at("d.*.*")), "'*' may stand once");
  EXPECT_INPUT_ERROR(find_file_set(at("d.*%.t")), "has no end");
  EXPECT_INPUT_ERROR(find_file_set(at("d.*0.t")), "has no end");
  EXPECT_INPUT_ERROR(find_file_set(at("nowhere/d.*")), "cannot list", "nowhere");
  folder_.write("d.01.t", "");
  EXPECT_INPUT_ERROR(find_file_set(at("d.*.t")), "d.1.t", "d.01.t", "same number");
}

TEST_F(FileSets, MissingPiecesAreErrors) {
  folder_.write("a.1", "");
  EXPECT_INPUT_ERROR(find_file_set(at("a.%")), "piece 0 is missing");
  folder_.write("b.0", "");
  folder_.write("b.2", "");
  EXPECT_INPUT_ERROR(find_file_set(at("b.%")), "piece 1 is missing", "pieces 0 to 2");
  for (const char* name : {"c.5.0", "c.5.1", "c.6.0", "c.7.0", "c.7.1"}) folder_.write(name, "");
  EXPECT_INPUT_ERROR(find_file_set(at("c.*.%")), "piece 1 is missing", "c.6.0");
  for (const char* name : {"e.5.0", "e.5.1", "e.6.0"}) folder_.write(name, "");
  EXPECT_INPUT_ERROR(find_file_set(at("e.*.%")), "piece 1 is missing", "e.6.0");
}

TEST_F(FileSets, AFileAStepReadsAsOneFile) {
  folder_.write("d.9.t", piece(9, 1, 5));
  folder_.write("d.10.t", test::gzipped(piece(10, 1, 7)));
  folder_.write("d.200.t", piece(200, 1, 4) + piece(250, 1, 3));
  folder_.write("all", piece(9, 1, 5) + piece(10, 1, 7) + piece(200, 1, 4) + piece(250, 1, 3));
  const auto whole = read("d.*.t");
  expect_same(whole, read("all"));
  EXPECT_EQ(whole.frames.size(), 4u);
  EXPECT_EQ(first_header(at("d.*.t")).step, 9);
  EXPECT_EQ(format_of(at("d.*.t")), "lammps_text");
}

// Blocks are those of one file, wherever the pieces end; a rank may hold no atoms.
TEST_F(FileSets, PiecesReadAsOneFile) {
  const std::vector<std::vector<std::size_t>> shares{
      {capacity - 3, 0, 10, 2 * capacity + 1}, {0, 0, 0, 1}, {capacity, capacity, 1, 0},
      {3, capacity, 2 * capacity - 3, 5}};
  std::string all;
  std::vector<std::string> pieces(4);
  for (std::size_t frame = 0; frame < shares.size(); ++frame) {
    std::size_t atoms = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      pieces[k] += piece(static_cast<long>(frame), 1 + atoms, shares[frame][k]);
      atoms += shares[frame][k];
    }
    all += piece(static_cast<long>(frame), 1, atoms);
  }
  for (std::size_t k = 0; k < 4; ++k)
    folder_.write("d." + std::to_string(k), k == 2 ? test::gzipped(pieces[k]) : pieces[k]);
  folder_.write("all", all);
  expect_same(read("d.%"), read("all"));
}

TEST_F(FileSets, PiecesOfAFileAStep) {
  folder_.write("d.0.5", piece(5, 1, 2));
  folder_.write("d.1.5", piece(5, 3, 3));
  folder_.write("d.0.10", piece(10, 1, 4));
  folder_.write("d.1.10", piece(10, 5, 1));
  folder_.write("all", piece(5, 1, 5) + piece(10, 1, 5));
  expect_same(read("d.%.*"), read("all"));
}

TEST_F(FileSets, RestartOfAFrameInPieces) {
  folder_.write("d.0", piece(1, 1, capacity + 1) + piece(2, 1, 1));
  folder_.write("d.1", test::gzipped(piece(1, capacity + 2, capacity) + piece(2, 2, 1)));
  folder_.write("all", piece(1, 1, 2 * capacity + 1) + piece(2, 1, 2));
  const auto wanted = read("all");
  for (int before = 0; before < 4; ++before) {
    const auto source = open_trajectory(at("d.%"), {"id", "q"});
    test::WholeTrajectory found;
    for (test::WholeFrame frame; source->next(frame.header); frame = {}) {
      Chunk chunk;
      for (int k = 0; k < before; ++k) source->cut(chunk);
      source->restart_frame();
      test::read_blocks(*source, {"id", "q"}, frame);
      found.frames.push_back(frame);
    }
    expect_same(found, wanted);
  }
}

TEST_F(FileSets, FramesMayBePassedOver) {
  folder_.write("d.0", piece(1, 1, 3) + piece(2, 1, 1));
  folder_.write("d.1", piece(1, 4, 3) + piece(2, 2, 4));
  const auto source = open_trajectory(at("d.%"), {"q"});
  FrameHeader header;
  ASSERT_TRUE(source->next(header));
  EXPECT_EQ(header.atoms, 6u);
  ASSERT_TRUE(source->next(header));
  EXPECT_EQ(header.atoms, 5u);
  EXPECT_FALSE(source->next(header));
  EXPECT_FALSE(source->next(header));
}

TEST_F(FileSets, ACutFileIsNamed) {
  const std::string last = piece(30, 1, 3);
  folder_.write("d.10", piece(10, 1, 3));
  folder_.write("d.20", piece(20, 1, 3));
  folder_.write("d.30", last.substr(0, last.size() - 2));
  const auto whole = read("d.*");
  EXPECT_EQ(whole.frames.size(), 2u);
  EXPECT_TRUE(whole.truncated);
  EXPECT_TRUE(test::contains(whole.error, at("d.30").string() + ":")) << whole.error;

  folder_.write("q.0", piece(10, 1, 3) + piece(20, 1, 3));
  folder_.write("q.1", piece(10, 4, 3));
  const auto pieces = read("q.%");
  EXPECT_EQ(pieces.frames.size(), 1u);
  EXPECT_TRUE(pieces.truncated);
  EXPECT_TRUE(test::contains(pieces.error, at("q.1").string() + ": ")) << pieces.error;
  EXPECT_TRUE(test::contains(pieces.error, at("q.0").string() + ":")) << pieces.error;
}

TEST_F(FileSets, ALineOfAPieceIsNamed) {
  folder_.write("d.0", piece(1, 1, 3));
  std::string text = piece(1, 4, 3);
  text.replace(text.rfind("6 "), std::string::npos, "6 x\n");
  folder_.write("d.1", text);
  const auto whole = read("d.%");
  EXPECT_TRUE(test::contains(whole.error, at("d.1").string() + ":12: 'x' in column q"))
      << whole.error;
}

TEST_F(FileSets, PiecesThatDisagreeAreErrors) {
  folder_.write("s.0", piece(1, 1, 3));
  folder_.write("s.1", piece(2, 4, 3));
  folder_.write("c.0", piece(1, 1, 3));
  folder_.write("c.1", piece(1, 4, 3, "fx"));
  folder_.write("b.0", piece(1, 1, 3));
  folder_.write("b.1", piece(1, 4, 3, "q", "2"));
  const std::pair<const char*, const char*> sets[] = {
      {"s", "step 2"}, {"c", "other columns"}, {"b", "another box"}};
  for (const auto& [name, what] : sets) {
    const std::string all(name);
    const auto source = open_trajectory(at(all + ".%"), {"id"});
    FrameHeader header;
    EXPECT_INPUT_ERROR(source->next(header), what, at(all + ".0").string(),
                       at(all + ".1").string());
  }
}

TEST_F(FileSets, EveryFileHasItsRecord) {
  for (int step : {1, 2, 3})
    for (int k : {0, 1})
      folder_.write("d." + std::to_string(k) + "." + std::to_string(step), piece(step, 1, 4 + k));
  const auto set = find_file_set(at("d.%.*"));
  ASSERT_TRUE(set);
  for (int frames = 0; frames <= 4; ++frames) {
    const auto source = open_trajectory(at("d.%.*"), {"q"});
    FrameHeader header;
    for (int k = 0; k < frames; ++k) source->next(header);
    const auto records = source->records();
    ASSERT_EQ(records.size(), 6u);
    for (std::size_t k = 0; k < 6; ++k) {
      const auto wanted = RawFile(set->at(k / 2).at(k % 2)).record();
      EXPECT_EQ(records[k].path, wanted.path);
      EXPECT_EQ(records[k].size, wanted.size);
      EXPECT_EQ(records[k].hash, wanted.hash);
    }
  }
}

TEST_F(FileSets, PrintedPrecisionIsThatOfOneFile) {
  folder_.write("d.0", piece(1, 800, 3));
  folder_.write("d.1", piece(1, 803, 300));
  folder_.write("all", piece(1, 800, 303));
  std::vector<PrintedPrecision> found;
  for (const char* name : {"d.%", "all"}) {
    const auto source = open_trajectory(at(name), {"q"});
    FrameHeader header;
    Chunk chunk;
    ASSERT_TRUE(source->next(header) && source->cut(chunk));
    found.push_back(chunk.layout->printed_precision(chunk, "q"));
    EXPECT_EQ(chunk.layout->printed_precision(chunk, "id").digits, 0);
  }
  EXPECT_EQ(found[0].digits, found[1].digits);
  EXPECT_EQ(found[0].decimals, 3);
  EXPECT_EQ(found[0].fixed, found[1].fixed);
}

std::size_t open_files() {
  const std::filesystem::directory_iterator files("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

TEST_F(FileSets, OneStepIsOpenAtATime) {
  if (!std::filesystem::exists("/proc/self/fd")) GTEST_SKIP();
  for (int step = 0; step < 50; ++step)
    folder_.write("d." + std::to_string(step), piece(step, 1, 2));
  const std::size_t before = open_files();
  const auto source = open_trajectory(at("d.*"), {"q"});
  FrameHeader header;
  while (source->next(header)) EXPECT_LE(open_files(), before + 1);
  EXPECT_EQ(header.step, 49);
}

}  // namespace
}  // namespace mdana
