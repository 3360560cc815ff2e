// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/logged_energy.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using Steps = std::vector<std::int64_t>;

/// What is joined of a log of these lines.
LoggedEnergy joined(const std::string& lines, const Steps& steps, const std::vector<double>& kinetic,
                    double atoms) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("log.lammps", "LAMMPS (29 Sep 2021)\n" + lines);
  return logged_energy(read_thermo_log(path), steps, kinetic, atoms);
}

std::string table(const std::string& head, const std::string& rows) {
  return head + "\n" + rows + "Loop time of 1 on 1 procs for 1 steps with 10 atoms\n";
}

const std::string two_rows = table("Step KinEng PotEng", "0 20.000 -700.25\n10 10.000 -690.25\n");

TEST(LoggedEnergy, IsJoinedByTheStep) {
  const LoggedEnergy e = joined(two_rows, {0, 5, 10}, {20, 15, 10}, 10);
  EXPECT_EQ(e.potential[0], -700.25);
  EXPECT_TRUE(std::isnan(e.potential[1]));
  EXPECT_EQ(e.potential[2], -690.25);
  EXPECT_EQ(e.frames, 2u);
  EXPECT_FALSE(e.per_atom);
  EXPECT_DOUBLE_EQ(e.rounding, 0.01);
}

TEST(LoggedEnergy, PerAtomIsTold) {
  const LoggedEnergy e = joined(two_rows, {0, 10}, {200, 100}, 10);
  EXPECT_TRUE(e.per_atom);
  EXPECT_EQ(e.potential, (std::vector<double>{-7002.5, -6902.5}));
  EXPECT_DOUBLE_EQ(e.rounding, 0.1);
}

// The default of LAMMPS, thermo_style one: 2 is -7 - 1 + 10.
TEST(LoggedEnergy, OfTheDefaultColumns) {
  const std::string lines = table("Step Temp E_pair E_mol TotEng Press", "0 1 -7.0000 -1.0000 -6.0000 0\n");
  EXPECT_EQ(joined(lines, {0}, {2}, 10).potential, (std::vector<double>{-8}));
  EXPECT_EQ(joined(lines, {0}, {20}, 10).potential, (std::vector<double>{-80}));
}

TEST(LoggedEnergy, OfTheRunsAfterTheClockWasSetBack) {
  const std::string lines = table("Step PotEng KinEng", "0 -1 9\n10 -2 9\n") +
                            table("Step PotEng KinEng", "0 -3 5\n10 -4 6\n") +
                            table("Step PotEng KinEng", "10 -4 6\n20 -5 7\n");
  EXPECT_EQ(joined(lines, {0, 10, 20}, {5, 6, 7}, 10).potential, (std::vector<double>{-3, -4, -5}));
}

TEST(LoggedEnergy, OfAnotherRunIsRefused) {
  EXPECT_INPUT_ERROR(joined(two_rows, {0, 10}, {20, 11}, 10), "log.lammps: ", "is not that of the dump");
  EXPECT_INPUT_ERROR(joined(two_rows, {1, 11}, {20, 10}, 10), "none of its steps");
  EXPECT_INPUT_ERROR(joined(table("Step KinEng PotEng", "0 0 -7\n"), {0}, {0}, 10), "not");
}

TEST(LoggedEnergy, TooFewDigitsAreRefused) {
  EXPECT_INPUT_ERROR(joined(table("Step KinEng PotEng", "0 0 -7\n"), {0}, {0.05}, 10),
                     "too few digits");
}

TEST(LoggedEnergy, ColumnsThatAreMissingAreNamed) {
  EXPECT_INPUT_ERROR(joined(table("Step KinEng Temp", "0 1 2\n"), {0}, {1}, 10), "PotEng");
  EXPECT_INPUT_ERROR(joined(table("Step PotEng Temp", "0 1 2\n"), {0}, {1}, 10), "KinEng");
}

}  // namespace
}  // namespace mdana
