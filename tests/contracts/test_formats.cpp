// SPDX-License-Identifier: GPL-3.0-or-later
// What every file format of the list must keep.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "readers/format.hpp"

namespace mdana {
namespace {

/// The beginning of a file of each format; a new format needs its line here.
const std::map<std::string_view, std::string_view> samples{
    {"lammps_text", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\n"},
    {"lammps_yaml", "---\ncreator: LAMMPS\ntimestep: 0\n"},
    {"lammps_binary", {"\xf6\xff\xff\xff\xff\xff\xff\xff" "DUMPCUSTOM", 18}},
    {"h5md", {"\x89HDF\r\n\x1a\n", 8}},
    {"amber_netcdf", {"CDF\x01\0\0\0\x01", 8}},
};

// Beginnings of files that are no dumps: a LAMMPS log, a data file, xyz, TOML, other YAML, gzip, zeros.
const std::string_view others[] = {"",
                                   "\n",
                                   "LAMMPS (29 Sep 2021)\n",
                                   "2 atoms\n",
                                   "3\ncomment\nAr 0 0 0\n",
                                   "schema = 1\n",
                                   "---\nkeywords: ['Step', 'Temp', ]\ndata:\n",
                                   "---\n",
                                   {"\x1f\x8b\x08\x00", 4},
                                   {"\0\0\0\0", 4},
                                   "ITEM",
                                   "item: timestep\n"};

TEST(Formats, RecogniseTheirOwnAndNothingElse) {
  for (const Format* format : formats()) {
    ASSERT_TRUE(samples.contains(format->name)) << format->name;
    for (const auto& [name, sample] : samples)
      EXPECT_EQ(format->recognises(sample), name == format->name) << format->name << " " << name;
    for (const auto& other : others)
      EXPECT_FALSE(format->recognises(other)) << format->name << ": " << other;
  }
}

TEST(Formats, HaveNamesAndSummaries) {
  std::set<std::string_view> names;
  for (const Format* format : formats()) {
    EXPECT_TRUE(names.insert(format->name).second) << format->name;
    EXPECT_FALSE(format->summary.empty()) << format->name;
  }
  EXPECT_FALSE(names.empty());
}

}  // namespace
}  // namespace mdana
