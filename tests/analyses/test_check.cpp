// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of fault of values, atoms and frames on made-up dumps: told once, at the right line and frame,
// and nothing else.
#include "readers/input_error.hpp"
#include "tests/analyses/faulty_dumps.hpp"

namespace mdana {
namespace {

using namespace test;

TEST_F(Check, WholeDumpHasNoFaults) {
  const CheckResult result = check_lines();
  EXPECT_EQ(told(result), std::vector<Told>{});
  EXPECT_EQ(result.frames, 5u);
  EXPECT_EQ(result.atoms, 20u);
  EXPECT_TRUE(result.ids_compared);
  EXPECT_EQ(result.columns,
            (std::vector<std::string>{"id", "type", "mass", "x", "y", "z", "vx"}));
}

TEST_F(Check, LineEndsCommentsAndBlankLinesBetweenFramesAreNoFaults) {
  EXPECT_EQ(told(check(joined(lines_, "\r\n"))), std::vector<Told>{});
  lines_.insert(lines_.begin() + frame_lines, {"# comment", "", " "});
  expect({});
}

TEST_F(Check, EveryWrongWordOfAFrame) {
  const auto first = replace(1, 0, 6, "0.1x"), second = replace(1, 2, 3, "--1");
  const auto third = replace(4, 3, 1, "one");
  expect({{"word", first, 1}, {"word", second, 1}, {"word", third, 4}});
  const Fault fault = check_lines().faults.kept()[0];
  EXPECT_EQ(fault.file, (folder_.path() / "dump").string());
  EXPECT_EQ(fault.column, "vx");
  EXPECT_EQ(fault.step, 100);
  EXPECT_NE(fault.what.find("'0.1x' in column vx"), std::string::npos) << fault.what;
}

TEST_F(Check, BothWordsOfALine) {
  const auto line = replace(2, 1, 3, "x");
  replace(2, 1, 6, "y");
  expect({{"word", line, 2}, {"word", line, 2}});
}

TEST_F(Check, NumbersThatMustBeWhole) {
  const auto first = replace(0, 0, 0, "10.5"), second = replace(3, 1, 1, "99999999999999999999");
  expect({{"not_whole", first, 0}, {"not_whole", second, 3}});
}

TEST_F(Check, LinesWithAnotherNumberOfColumns) {
  lines_[atom_line(1, 1)] += " 7";
  lines_[atom_line(1, 3)] = "10 1 1.5";
  lines_[atom_line(2, 0)] = "";
  expect({{"line", atom_line(1, 1) + 1u, 1},
          {"line", atom_line(1, 3) + 1u, 1},
          {"line", atom_line(2, 0) + 1u, 2}});
}

TEST_F(Check, ValuesBesideAFaultyLineAreStillLookedAt) {
  const auto bad = replace(1, 1, 6, "?"), type = replace(1, 2, 1, "0");
  replace(1, 1, 1, "-1");  // of the faulty line: not looked at
  expect({{"word", bad, 1}, {"type", type, 1}});
}

TEST_F(Check, TypesAndMasses) {
  const auto type = replace(0, 1, 1, "0"), mass = replace(1, 0, 2, "0");
  const auto negative = replace(1, 3, 2, "-1e-3");
  expect({{"type", type, 0}, {"mass", mass, 1}, {"mass", negative, 1}});
}

TEST_F(Check, NotFiniteIsOneFaultAColumnWithItsFirstPlace) {
  const auto vx = replace(1, 2, 6, "nan");
  replace(3, 0, 6, "-inf");
  const auto x = replace(2, 0, 3, "1e999");
  expect({{"not_finite", vx, 1}, {"not_finite", x, 2}});
  const CheckResult result = check_lines();
  EXPECT_EQ(result.faults.kept()[0].times, 2u);
  EXPECT_EQ(result.faults.count(FaultKind::not_finite), 3u);
}

TEST_F(Check, DuplicateIds) {
  const auto first = replace(0, 3, 0, "10"), later = replace(2, 1, 0, "30");
  const CheckResult result = check_lines();
  const std::vector<Told> wanted{
      {"duplicate_id", first, 0}, {"ids_gained", atom_line(1, 0), 1},
      {"duplicate_id", later + 1, 2}, {"ids_lost", atom_line(2, 0), 2},
      {"ids_gained", atom_line(2, 0), 2}, {"ids_gained", atom_line(3, 0), 3},
      {"ids_gained", atom_line(4, 0), 4}};
  EXPECT_EQ(told(result), wanted);
}

TEST_F(Check, IdsLostAndGained) {
  replace(3, 2, 0, "-7");
  const std::uint64_t place = atom_line(3, 0);
  expect({{"ids_lost", place, 3}, {"ids_gained", place, 3}});
  EXPECT_EQ(check_lines().faults.kept()[0].what, "lost 1 ids: 30");
  EXPECT_EQ(check_lines().faults.kept()[1].what, "gained 1 ids: -7");
}

TEST_F(Check, OrderOfAtomsIsNoFault) {
  std::swap(lines_[atom_line(1, 0)], lines_[atom_line(1, 3)]);
  expect({});
}

TEST_F(Check, FarOutsideAPeriodicBoxIsANote) {
  const auto x = replace(1, 1, 3, "15.5"), y = replace(2, 0, 4, "-10.5");
  replace(2, 1, 5, "1e6");   // z is not periodic
  replace(3, 1, 3, "14.5");  // less than half a box outside
  expect({{"outside_box", x, 1}, {"outside_box", y, 2}});
  EXPECT_EQ(check_lines().faults.count(Severity::error), 0u);
}

TEST_F(Check, ScaledPositions) {
  for (std::string& line : lines_)
    if (line.starts_with("ITEM: ATOMS")) line = "ITEM: ATOMS id type mass xs ys zs vx";
  for (int f = 0; f < frames; ++f)
    for (int a = 0; a < atoms; ++a)
      for (int k = 3; k < 6; ++k) replace(f, a, k, "0.5");
  const auto y = replace(1, 0, 4, "1.75");
  replace(1, 0, 3, "1.25");
  expect({{"outside_box", y, 1}});
}

TEST_F(Check, StepsAndTimes) {
  lines_[header_line(2, 1)] = "100";
  expect({{"step_order", header_line(2, 8) + 1u, 2}});
  lines_ = made_up();
  for (int f = frames - 1; f >= 0; --f)
    lines_.insert(lines_.begin() + header_line(f, 0), {"ITEM: TIME", std::to_string(f)});
  expect({});
  auto stated = lines_;
  lines_[15 * 3 + 1] = "1.5";
  expect({{"time_order", 15 * 3 + 11u, 3}});
  lines_ = stated;
  lines_.erase(lines_.begin() + 15, lines_.begin() + 17);
  expect({{"time_missing", 15 + 9u, 1}});
}

TEST_F(Check, UnitsThatChange) {
  lines_.insert(lines_.begin() + header_line(2, 0), {"ITEM: UNITS", "metal"});
  lines_.insert(lines_.begin(), {"ITEM: UNITS", "metal"});
  expect({});
  lines_[1] = "lj";
  expect({{"units_change", frame_lines * 2 + 2 + 2 + 9u, 2}});
}

TEST_F(Check, AtomsAndColumnsThatChangeAreNotes) {
  lines_[header_line(1, 3)] = "3";
  lines_.erase(lines_.begin() + atom_line(1, 3));
  const std::uint64_t in_one = atom_line(1, 0), in_two = atom_line(2, 0) - 1;
  expect({{"ids_lost", in_one, 1}, {"atoms_change", in_one, 1}, {"atoms_change", in_two, 2}});
  lines_ = made_up();
  lines_[header_line(4, 8)] = "ITEM: ATOMS id type mass x y z vy";
  expect({{"columns_change", header_line(4, 8) + 1u, 4}});
}

}  // namespace
}  // namespace mdana
