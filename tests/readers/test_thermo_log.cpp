// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "readers/input_error.hpp"
#include "readers/thermo_log.hpp"
#include "tests/readers/gzipped.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

using test::contains;
using Reals = std::vector<double>;

const std::string start = "LAMMPS (29 Sep 2021 - Update 2)\nunits ${system}\nunits metal # echoed\n"
                          "timestep 0.002\nrun 20\n";
const std::string memory = "Per MPI rank memory allocation (min/avg/max) = 3 | 3 | 3 Mbytes\n";
const std::string loop = "Loop time of 0.004 on 1 procs for 20 steps with 108 atoms\n\n"
                         "Performance: 1 tau/day, 2 timesteps/s\n"
                         "Section |  min time  |  avg time  |  max time  |%varavg| %total\n"
                         "---------------------------------------------------------------\n"
                         "Pair    | 0.0044632  | 0.0044632  | 0.0044632  |   0.0 | 97.20\n";

const std::string table = "Step Temp c_p[1] \n       0            1   -5.25\n      10   0.5   1e-3 \n";
const std::string blocks =
    "---------------- Step        0 ----- CPU =      0.0000 (sec) ----------------\n"
    "Temp     =         1.0000 c_p[1]   =        -5.2500 Press    =         3.0000 \n"
    "PotEng   =        -6.0000\n"
    "---------------- Step       10 ----- CPU =      0.0005 (sec) ----------------\n"
    "Temp     =         0.5000 c_p[1]   =         0.0010 Press    =         4.0000 \n"
    "PotEng   =        -6.5000\n";
const std::string yaml = "---\nkeywords: ['Step', 'Temp', 'c_p[1]', ]\ndata:\n"
                         "  - [0, 1, -5.25, ]\n  - [10, 0.5, 1e-3, ]\n...\n";

class ThermoLogs : public ::testing::Test {
 protected:
  ThermoLog read(const std::string& text) { return read_thermo_log(folder_.write("log", text)); }
  void expect_error(const std::string& text, const std::string& what) {
    try {
      read(text);
      ADD_FAILURE() << "no error: " << text;
    } catch (const InputError& error) {
      EXPECT_TRUE(contains(error.what(), what)) << error.what();
    }
  }
  void expect_not_joined(const std::string& second, const std::string& what) {
    const ThermoLog log = read(start + memory + table + loop + second + loop);
    ASSERT_EQ(log.sections.size(), 2u);
    try {
      join_sections(log);
      ADD_FAILURE() << "no error: " << second;
    } catch (const InputError& error) {
      EXPECT_TRUE(contains(error.what(), what)) << error.what();
    }
  }
  test::TemporaryFolder folder_;
};

const Reals& column(const ThermoLog& log, const std::string& name) {
  return log.sections.at(0).table.find(name)->values;
}

TEST_F(ThermoLogs, ThreeStylesGiveTheSameNumbers) {
  for (const std::string& output : {table, blocks, yaml}) {
    const ThermoLog log = read(start + memory + output + loop);
    ASSERT_EQ(log.sections.size(), 1u) << output;
    EXPECT_EQ(column(log, "Step"), (Reals{0, 10}));
    EXPECT_EQ(column(log, "Temp"), (Reals{1, 0.5}));
    EXPECT_EQ(column(log, "c_p[1]"), (Reals{-5.25, 1e-3}));
    EXPECT_EQ(log.sections[0].table.rows(), 2u);
    EXPECT_TRUE(log.sections[0].finished);
    EXPECT_EQ(log.sections[0].timestep, 0.002);
    EXPECT_EQ(log.units, Units::metal);
    EXPECT_EQ(log.version, "29 Sep 2021 - Update 2");
    EXPECT_EQ(log.cut, "");
  }
}

TEST_F(ThermoLogs, BlocksHaveStepAndCpuOfTheirHead) {
  const ThermoLog log = read(start + blocks + loop);
  EXPECT_EQ(log.sections[0].first_line, 6u);
  EXPECT_EQ(column(log, "CPU"), (Reals{0, 0.0005}));
  EXPECT_EQ(column(log, "Press"), (Reals{3, 4}));
  EXPECT_EQ(column(log, "PotEng"), (Reals{-6, -6.5}));
}

TEST_F(ThermoLogs, LastPrintedDigitIsTheFinest) {
  const ThermoLog log = read(start + memory + table + loop);
  const auto digit = [&](const char* name) {
    return log.sections[0].table.find(name)->last_digit;
  };
  EXPECT_DOUBLE_EQ(digit("Step"), 1);
  EXPECT_DOUBLE_EQ(digit("Temp"), 0.1);
  EXPECT_DOUBLE_EQ(digit("c_p[1]"), 1e-3);
}

TEST_F(ThermoLogs, KeywordsNeedNotBeginWithStep) {
  const ThermoLog log = read(start + memory + "   Temp     Press    \n 1 2\n 3 -nan\n" + loop);
  EXPECT_EQ(column(log, "Temp"), (Reals{1, 3}));
  EXPECT_TRUE(std::isnan(column(log, "Press")[1]));
}

TEST_F(ThermoLogs, WithoutMemoryLineStepBeginsTheKeywords) {  // run 20 pre no
  const ThermoLog log = read(start + "Step by step\nStep 1 2\nfoo\n" + table + loop);
  ASSERT_EQ(log.sections.size(), 1u);
  EXPECT_EQ(log.sections[0].first_line, 9u);
  EXPECT_EQ(column(log, "Step"), (Reals{0, 10}));
}

TEST_F(ThermoLogs, WarningsAndWordsBetweenRowsAreCounted) {
  std::string text = table;
  text.insert(text.find("      10"), "WARNING: Lost atoms (src/thermo.cpp:1)\nhello 7 8\n");
  const ThermoLog log = read(start + memory + "WARNING: early\n" + text + loop);
  EXPECT_EQ(column(log, "Step"), (Reals{0, 10}));
  EXPECT_EQ(log.sections[0].other_lines, 2u);
  EXPECT_EQ(log.warnings, 2u);
}

TEST_F(ThermoLogs, ErrorEndsTheRun) {
  const ThermoLog log = read(start + memory + table + "ERROR: Lost atoms: original 108\n");
  EXPECT_EQ(column(log, "Step"), (Reals{0, 10}));
  EXPECT_FALSE(log.sections[0].finished);
  EXPECT_TRUE(log.error.starts_with("ERROR: Lost atoms"));
}

TEST_F(ThermoLogs, TimestepOfEachRun) {
  const ThermoLog log = read(start + memory + table + loop + "timestep 0.25\n" +
                             "  Time step     : 0.5\n  Unit style    : metal\n" + memory + yaml +
                             loop);
  ASSERT_EQ(log.sections.size(), 2u);
  EXPECT_EQ(log.sections[0].timestep, 0.002);
  EXPECT_EQ(log.sections[1].timestep, 0.5);
}

TEST_F(ThermoLogs, WrongRowsNameTheirLine) {
  expect_error(start + memory + table + "20 1\n" + loop,
               "log:10: 2 values (line 7 names 3 columns)");
  expect_error(start + memory + table + "20 1 x\n" + loop, "log:10: 'x' in column c_p[1]");
  expect_error(start + memory + "---\nkeywords: ['Step', 'T', ]\ndata:\n  - [1, ]\n...\n",
               "log:10: 1 values (line 8 names 2 columns)");
  expect_error(start + memory + "---\nkeywords: ['Step', 'T', ]\ndata:\n  - [1, , 2]\n...\n",
               "log:10: a row is not a list");
  std::string text = blocks;
  text.replace(text.rfind("PotEng"), 6, "KinEng");
  expect_error(start + memory + text + loop, "the block that ends here");
  text.replace(text.rfind("-6.5000"), 7, "-6.5x00");
  expect_error(start + memory + text + loop, "'-6.5x00' of KinEng is not a number");
}

TEST_F(ThermoLogs, UnitsMayNotChange) {
  expect_error(start + "clear\nunits lj\n", "log:7: units change from metal to lj");
  EXPECT_FALSE(read("LAMMPS (1 Jan 2020)\nrun 0\n").units);
}

TEST_F(ThermoLogs, OtherFilesAreNoLogs) {
  EXPECT_TRUE(is_lammps_log(folder_.write("log", start)));
  EXPECT_TRUE(is_lammps_log(folder_.write("log.gz", test::gzipped(start))));
  for (const std::string other : {"", "LAMMPS", "ITEM: TIMESTEP\n0\n", "# LAMMPS (\n"})
    EXPECT_FALSE(is_lammps_log(folder_.write("other", other))) << other;
  EXPECT_FALSE(is_lammps_log("/does/not/exist"));
  for (const std::string other : {"ITEM: TIMESTEP\n0\n", "2 atoms", "LAMMPS ("})
    expect_error(other, "not a log of LAMMPS");
}

/// What is read of a log that is cut: rows of the whole log, and a word on it if a run is cut.
void expect_beginning(const ThermoLog& cut, const ThermoLog& whole, std::size_t least_rows) {
  std::size_t rows = 0;
  for (std::size_t s = 0; s < cut.sections.size(); ++s) {
    rows += cut.sections[s].table.rows();
    for (std::size_t k = 0; k < cut.sections[s].table.columns.size(); ++k) {
      const auto& part = cut.sections[s].table.columns[k];
      const auto& all = whole.sections[s].table.columns[k];
      EXPECT_EQ(part.name, all.name);
      ASSERT_LE(part.values.size(), all.values.size());
      EXPECT_TRUE(std::equal(part.values.begin(), part.values.end(), all.values.begin()));
    }
    EXPECT_TRUE(cut.sections[s].finished || !cut.cut.empty());
  }
  EXPECT_GE(rows, least_rows);
}

TEST_F(ThermoLogs, CutAtEveryByteGivesTheWholeRowsAndSaysSo) {
  const std::string head = start + memory;
  for (const std::string& output : {table, yaml, blocks}) {
    const std::string text = head + output + loop;
    const ThermoLog whole = read(text);
    const std::size_t second = text.find("10", head.size());  // of the second row
    const std::size_t first_row_ends = text.rfind('\n', second) + 1;
    for (std::size_t bytes = start.size(); bytes <= text.size(); ++bytes) {
      SCOPED_TRACE(bytes);
      // The first block's length is known when the second begins.
      const std::size_t known =
          output == blocks ? text.find('\n', second) + 1 : first_row_ends;
      const ThermoLog cut = read(text.substr(0, bytes));
      expect_beginning(cut, whole, bytes >= known ? 1 : 0);
      EXPECT_TRUE(text[bytes - 1] == '\n' || !cut.cut.empty());
    }
    const std::string packed = test::gzipped(text);
    EXPECT_FALSE(read(packed.substr(0, packed.size() - 9)).cut.empty());
  }
}

TEST_F(ThermoLogs, SectionsAreJoinedAtTheirCommonStep) {
  const ThermoLog log = read(start + memory + table + loop + memory +
                             "Step Temp c_p[1]\n 10 0.5 0.001\n 20 0.25 2\n" + loop);
  ASSERT_EQ(log.sections.size(), 2u);
  EXPECT_EQ(log.sections[1].table.rows(), 2u);
  const ThermoTable joined = join_sections(log);
  EXPECT_EQ(joined.find("Step")->values, (Reals{0, 10, 20}));
  EXPECT_EQ(joined.find("c_p[1]")->values, (Reals{-5.25, 1e-3, 2}));
}

TEST_F(ThermoLogs, CpuStartsAnewAndMayDiffer) {
  std::string again = blocks.substr(blocks.find("---------------- Step       10"));
  again.replace(again.find("0.0005"), 6, "0.0000");
  const ThermoLog log = read(start + memory + blocks + loop + memory + again + loop);
  EXPECT_EQ(join_sections(log).find("Step")->values, (Reals{0, 10}));
}

TEST_F(ThermoLogs, SectionsThatContradictEachOtherAreNotJoined) {
  expect_not_joined("Step Temp c_p[1]\n 10 0.75 0.001\n", "Temp at step 10 is 0.75, but 0.5");
  expect_not_joined("Step Temp c_p[1]\n 10 1 0.001\n", "Temp at step 10 is 1, but 0.5");
  expect_not_joined("Step Temp c_p[1]\n 10 nan 0.001\n", "Temp at step 10");
  expect_not_joined("Step Temp c_p[1]\n 0 1 -5.25\n", "the steps go back from 10 to 0");
  expect_not_joined("Step Temp Press\n 10 0.5 0.001\n", "other columns");
}

}  // namespace
}  // namespace mdana
