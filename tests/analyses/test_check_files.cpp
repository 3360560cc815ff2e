// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of files: wrong headers and numbers of lines, cut and compressed ones, sets, binary dumps.
#include <limits>
#include <random>

#include "readers/input_error.hpp"
#include "tests/readers/binary_dump.hpp"
#include "tests/readers/gzipped.hpp"
#include "tests/analyses/faulty_dumps.hpp"

namespace mdana {
namespace {

using namespace test;

TEST_F(Check, TooFewLinesAndTheFramesBehindThem) {
  lines_.erase(lines_.begin() + atom_line(1, 2), lines_.begin() + atom_line(1, 4));
  const std::uint64_t place = atom_line(1, 2) + 1;
  const auto type = replace(1, 1, 1, "0");  // of an atom that is there
  lines_[atom_line(3, 0) - 2] = "10 1 1.5 0 0 0";
  expect({{"type", type, 1}, {"atom_count", place, 1}, {"line", atom_line(3, 0) - 1u, 3}});
}

TEST_F(Check, TooManyLinesAndTheFramesBehindThem) {
  lines_.insert(lines_.begin() + header_line(2, 0), {"50 1 1.5 1 1 1 1", "60 1 1.5 1 1 1 1"});
  lines_.push_back("70 1 1.5 1 1 1 1");
  const CheckResult result = check_lines();
  const std::vector<Told> wanted{{"atom_count", header_line(2, 0) + 1u, 1},
                                 {"atom_count", lines_.size(), 4}};
  EXPECT_EQ(told(result), wanted);
  EXPECT_EQ(result.frames, 5u);
}

TEST_F(Check, AnyFaultyLineOfAHeaderIsOneFault) {
  for (int line = 0; line < header_lines; ++line) {
    SCOPED_TRACE(line);
    lines_ = made_up();
    lines_[header_line(2, line)] = line == 3 ? "4.5" : line % 2 == 0 && line < 5 ? "ITEM: X" : "?";
    if (line == 8) lines_[header_line(2, line)] = "ITEM: ATMS id";
    const auto type = replace(3, 1, 1, "0");
    const CheckResult result = check_lines();
    ASSERT_EQ(result.faults.kept().size(), 2u);
    EXPECT_EQ(told(result)[0], (Told{"header", header_line(2, line) + 1u, 2}));
    EXPECT_EQ(told(result)[1], (Told{"type", type, 3}));
    EXPECT_EQ(result.frames, 4u);
    EXPECT_TRUE(result.to_the_end);
  }
}

TEST_F(Check, HeaderThatRunsIntoTheNextOne) {
  lines_.erase(lines_.begin() + header_line(1, 4), lines_.begin() + header_line(2, 0));
  expect({{"header", header_line(1, 4) + 1u, 1}});
}

TEST_F(Check, CutAtEveryLineOfAFrame) {
  for (int left = 1; left < frame_lines; ++left) {
    SCOPED_TRACE(left);
    std::vector<std::string> lines(lines_.begin(), lines_.begin() + 3 * frame_lines + left);
    const CheckResult result = check(joined(lines));
    EXPECT_EQ(told(result), (std::vector<Told>{{"truncated", lines.size(), 3}}));
    EXPECT_FALSE(result.to_the_end);
    EXPECT_EQ(result.frames, left < header_lines ? 3u : 4u);
  }
}

TEST_F(Check, LastLineWithoutItsEnd) {
  std::string text = joined(lines_);
  text.pop_back();
  EXPECT_EQ(told(check(text)), (std::vector<Told>{{"truncated", lines_.size() - 1, 4}}));
}

TEST_F(Check, DamagedGzip) {
  const std::string packed = test::gzipped(joined(lines_), 0);
  const CheckResult cut = check(packed.substr(0, packed.size() / 2), {}, "cut.gz");
  ASSERT_EQ(cut.faults.kept().size(), 1u);
  EXPECT_EQ(cut.faults.kept()[0].kind, FaultKind::truncated);
  EXPECT_NE(cut.faults.kept()[0].what.find("gzip"), std::string::npos);
  std::string flipped = packed;
  flipped[flipped.size() - 6] = static_cast<char>(flipped[flipped.size() - 6] ^ 1);  // checksum
  const CheckResult result = check(flipped, {}, "flipped.gz");
  EXPECT_EQ(result.frames, 5u);
  EXPECT_EQ(result.faults.count(FaultKind::truncated), 1u);
}

// The place to go back to is found in a stream, too.
TEST_F(Check, GzipGoesOnAsPlainTextDoes) {
  lines_[header_line(1, 3)] = "x";
  lines_.erase(lines_.begin() + atom_line(3, 0));
  replace(4, 1, 1, "0");
  const std::string text = joined(lines_);
  EXPECT_EQ(told(check(test::gzipped(text), {}, "dump.gz")), told(check(text)));
  EXPECT_EQ(check(text).faults.count(Severity::error), 3u);
}

TEST_F(Check, LimitKeepsTheFirstAndCountsAll) {
  for (int a = 0; a < atoms; ++a) replace(1, a, 6, "x");
  replace(2, 0, 1, "0");
  CheckOptions options;
  options.limit = 2;
  const CheckResult result = check_lines(options);
  EXPECT_EQ(told(result), (std::vector<Told>{{"word", atom_line(1, 0) + 1u, 1},
                                             {"word", atom_line(1, 1) + 1u, 1},
                                             {"type", atom_line(2, 0) + 1u, 2}}));
  EXPECT_EQ(result.faults.count(FaultKind::word), 4u);
}

TEST_F(Check, IdsBeyondTheMemoryAreNotCompared) {
  replace(3, 0, 0, "20");
  CheckOptions options;
  options.memory = 3 * 24;
  const CheckResult result = check_lines(options);
  EXPECT_EQ(told(result), (std::vector<Told>{{"ids_unchecked", header_line(0, 8) + 1u, 0}}));
  EXPECT_FALSE(result.ids_compared);
}

// Over more than one block of atoms, and with any number of threads.
TEST_F(Check, LargeFrames) {
  constexpr int many = 70000;
  std::string text;
  std::vector<std::uint64_t> wrong;
  for (int f = 0, line = 0; f < 2; ++f) {
    text += fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS ff ff ff\n"
                        "0 1\n0 1\n0 1\nITEM: ATOMS id x\n", f, many);
    line += header_lines;
    for (int a = 0; a < many; ++a) {
      ++line;
      const bool bad = a % 10007 == 3;
      if (bad) wrong.push_back(line);
      text += fmt::format("{} {}\n", a == 69999 ? 5 : a, bad ? "bad" : "0.5");
    }
  }
  std::vector<Told> wanted;
  for (const std::size_t threads : {1u, 2u, 5u}) {
    CheckOptions options;
    options.threads = threads;
    const CheckResult result = check(text, options);
    std::vector<std::uint64_t> found, twice;
    for (const Fault& fault : result.faults.kept())
      (fault.kind == FaultKind::word ? found : twice).push_back(*fault.line);
    EXPECT_EQ(found, wrong);
    EXPECT_EQ(twice, (std::vector<std::uint64_t>{9 + many, 2 * (9 + many)}));
  }
}

TEST_F(Check, FilesOfASequence) {
  for (int f = 0; f < frames; ++f) {
    const auto start = lines_.begin() + f * frame_lines;
    std::vector<std::string> own(start, start + frame_lines);
    if (f == 1) own[3] = "many";
    if (f == 3) own[header_lines + 1] = "?";
    if (f == 2) own = {"nothing that is a dump"};
    folder_.write(fmt::format("set.{}", 100 * f), joined(own));
  }
  const CheckResult result = check_dump(folder_.path() / "set.*");
  const std::vector<Told> wanted{
      {"header", 4, 1}, {"header", std::nullopt, 2}, {"line", header_lines + 2u, 3}};
  EXPECT_EQ(told(result), wanted);
  EXPECT_EQ(result.faults.kept()[0].file, (folder_.path() / "set.100").string());
  EXPECT_EQ(result.faults.kept()[1].file, (folder_.path() / "set.200").string());
  EXPECT_EQ(result.frames, 3u);
  EXPECT_EQ(result.inputs.size(), 5u);
}

// A file of a set is named by its first step; others may follow in it.
TEST_F(Check, NamesOfFilesThatTellAnotherStepAreNotes) {
  const auto lines = [&](int first, int end) {
    return joined({lines_.begin() + first * frame_lines, lines_.begin() + end * frame_lines});
  };
  folder_.write("set.00000", lines(0, 1));
  folder_.write("set.90", lines(1, 3));
  folder_.write("set.300", lines(3, 5));
  const CheckResult result = check_dump(folder_.path() / "set.*");
  EXPECT_EQ(told(result), (std::vector<Told>{{"file_step", header_lines, 1}}));
  EXPECT_EQ(result.faults.count(Severity::error), 0u);
  EXPECT_EQ(result.faults.kept()[0].what, "the first step is 100, the file's name says 90");
  EXPECT_EQ(result.faults.kept()[0].file, (folder_.path() / "set.90").string());
  EXPECT_EQ(told(check_dump(folder_.path() / "set.90")), std::vector<Told>{});
}

TEST_F(Check, PiecesOfAFrame) {
  auto other = lines_;
  for (int f = 0; f < frames; ++f)
    for (int a = 0; a < atoms; ++a) other[atom_line(f, a)].insert(0, "1");
  const auto type = replace(1, 1, 1, "0");
  other[atom_line(2, 3)] = "10 1 1.5 x 1 1 1";
  folder_.write("piece.0", joined(lines_));
  folder_.write("piece.1", joined(other));
  const CheckResult result = check_dump(folder_.path() / "piece.%");
  EXPECT_EQ(told(result),
            (std::vector<Told>{{"type", type, 1}, {"word", atom_line(2, 3) + 1u, 2}}));
  EXPECT_EQ(result.faults.kept()[1].file, (folder_.path() / "piece.1").string());
}

/// Three atoms each in so many frames.
std::vector<test::BinaryFrame> binary_frames(int count) {
  std::vector<test::BinaryFrame> all(count);
  for (int f = 0; f < count; ++f) {
    all[f].step = f;
    all[f].ranks = {{1, 0.5, 0.5, 0.5, 2, 0.25, 0.5, 0.75}, {3, 0.5, 0.5, 0.5}};
  }
  return all;
}

std::string bytes(const std::vector<test::BinaryFrame>& all) {
  std::string text;
  for (const auto& frame : all) text += frame.bytes();
  return text;
}

TEST_F(Check, BinaryDumps) {
  auto all = binary_frames(4);
  EXPECT_EQ(told(check(bytes(all))), std::vector<Told>{});
  all[1].ranks[0][4] = 2.5;  // an id: nothing of the block can be used, the other frames can
  all[2].ranks[1][2] = std::numeric_limits<double>::quiet_NaN();
  all[3].ranks[1][0] = 1;
  const CheckResult result = check(bytes(all));
  EXPECT_EQ(told(result), (std::vector<Told>{{"block", std::nullopt, 1},
                                             {"duplicate_id", std::nullopt, 3},
                                             {"ids_lost", std::nullopt, 3},
                                             {"not_finite", std::nullopt, 2}}));
  EXPECT_EQ(result.faults.kept()[1].atom, 3u);
  EXPECT_EQ(result.faults.kept()[3].atom, 3u);
  for (const Fault& fault : result.faults.kept())
    EXPECT_EQ(fault.file, (folder_.path() / "dump").string());
}

TEST_F(Check, BinaryDumpThatIsCutEndsThere) {
  const std::string whole = bytes(binary_frames(3));
  for (std::size_t left = 2 * whole.size() / 3 + 1; left < whole.size(); ++left) {
    const CheckResult result = check(whole.substr(0, left));
    ASSERT_EQ(told(result), (std::vector<Told>{{"truncated", std::nullopt, 2}})) << left;
    EXPECT_FALSE(result.to_the_end);
  }
}

TEST_F(Check, WhatIsNoDumpCannotBeChecked) {
  EXPECT_THROW(check("nothing that is a dump\n"), InputError);
  EXPECT_THROW(check_dump(folder_.path() / "missing"), InputError);
}

// One word at random that is no number: exactly its line is told.
TEST_F(Check, AnyWordOfAnyAtomLine) {
  std::mt19937 random(20240611);
  const std::vector<std::string> words{"x", "1.2.3", "--1", "0x1f", "1,5", "+1", "1e", ".", "NA", "1d0"};
  for (int k = 0; k < 300; ++k) {
    lines_ = made_up();
    const std::string& word = words[random() % words.size()];
    const int frame = static_cast<int>(random() % frames), atom = static_cast<int>(random() % atoms);
    const int column = static_cast<int>(random() % 7);
    const auto line = replace(frame, atom, column, word);
    SCOPED_TRACE(fmt::format("'{}' at frame {}, atom {}, column {}", word, frame, atom, column));
    const auto found = told(check_lines());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], (Told{"word", line, frame}));
  }
}

}  // namespace
}  // namespace mdana
