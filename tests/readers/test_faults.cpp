// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/faults.hpp"

#include <gtest/gtest.h>

#include "readers/trajectory.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana {
namespace {

void expect(const Fault& fault, const std::string& file, std::optional<std::uint64_t> line,
            const std::string& what) {
  EXPECT_EQ(fault.file, file);
  EXPECT_EQ(fault.line, line);
  EXPECT_EQ(fault.what, what);
}

TEST(Faults, PlacesOutOfMessages) {
  const auto of = [](const char* message, const char* dump) {
    return located(FaultKind::header, message, dump);
  };
  expect(of("a/dump:12: 'x': no", "a/dump"), "a/dump", 12, "'x': no");
  expect(of("a/dump: no: 5", "a/dump"), "a/dump", std::nullopt, "no: 5");
  expect(of("dump:9 (frame 0, step 1)", "dump"), "dump", 9, "(frame 0, step 1)");
  expect(of("dump:9 (frame 0, step 1): no", "dump"), "dump", 9, "(frame 0, step 1): no");
  expect(of("dump (frame 0, step 1): atom 2: no", "dump"), "dump", std::nullopt, "atom 2: no");
  expect(of("a:1/b: c:7: no", "a:1/b: c"), "a:1/b: c", 7, "no");
  expect(of("run/d.10.gz:7: no", "run/d.*.gz"), "run/d.10.gz", 7, "no");
  expect(of("elsewhere:7: no", "dump"), "dump", std::nullopt, "elsewhere:7: no");
  expect(of("no", "*.dump"), "*.dump", std::nullopt, "no");
}

TEST(Faults, EveryKindHasItsWords) {
  std::size_t k = 0;
  for (const FaultKindWords& words : fault_kinds()) {
    EXPECT_EQ(static_cast<std::size_t>(words.kind), k++);
    EXPECT_EQ(&words_of(words.kind), &words);
    EXPECT_FALSE(words.name.empty() || words.meaning.empty());
  }
  EXPECT_EQ(k, static_cast<std::size_t>(FaultKind::no_atoms) + 1);
}

TEST(Faults, ListsThatAreJoinedCountAllAndKeepTheFirst) {
  const auto fault = [](const char* what, FaultKind kind, std::uint64_t times) {
    Fault f;
    f.kind = kind;
    f.what = what;
    f.times = times;
    return f;
  };
  Faults first(2), later(2);
  first.add(fault("a", FaultKind::word, 1));
  for (const char* what : {"b", "c", "d"}) later.add(fault(what, FaultKind::word, 2));
  later.add(fault("e", FaultKind::no_atoms, 1));
  first.add(later);
  EXPECT_EQ(first.count(FaultKind::word), 7u);
  EXPECT_EQ(first.count(Severity::error), 7u);
  EXPECT_EQ(first.count(Severity::note), 1u);
  ASSERT_EQ(first.kept().size(), 3u);
  EXPECT_EQ(first.kept()[1].what, "b");
  EXPECT_EQ(first.kept()[2].what, "e");
}

// The atoms beside a faulty line are converted as ever.
TEST(Faults, TextLinesBesideAFaultyOneAreConverted) {
  const test::TemporaryFolder folder;
  std::string text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n200\nITEM: BOX BOUNDS ff ff ff\n"
                     "0 1\n0 1\n0 1\nITEM: ATOMS id x element\n";
  for (int a = 0; a < 200; ++a)
    text += std::to_string(a) + (a % 50 == 7 ? " x Ag\n" : a % 50 == 9 ? " 1\n" : " 0.5 Ag\n");
  const auto source =
      open_trajectory(folder.write("dump", text), ColumnSet::all_as_they_stand());
  FrameHeader header;
  Chunk chunk;
  AtomBlock block;
  BlockFaults faults;
  ASSERT_TRUE(source->next(header) && source->cut(chunk));
  chunk.layout->check(chunk, block, faults);
  EXPECT_EQ(faults.faults.count(FaultKind::word), 4u);
  EXPECT_EQ(faults.faults.count(FaultKind::line), 4u);
  for (int a = 0; a < 200; ++a) {
    EXPECT_EQ(faults.usable(a), a % 50 != 7 && a % 50 != 9) << a;
    if (!faults.usable(a)) continue;
    EXPECT_EQ(block.integer("id")[a], a);
    EXPECT_EQ(block.real("x")[a], 0.5);
    EXPECT_EQ(block.text("element")[a], "Ag");
  }
  EXPECT_EQ(place_of(chunk, 7).line, 17u);
}

}  // namespace
}  // namespace mdana
