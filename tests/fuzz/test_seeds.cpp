// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs that once broke a reader, each by its name: seeds/<reader>/<name>. Read here as the fuzzers read
// them, without libFuzzer.
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>

#include <gtest/gtest.h>

#include "tests/fuzz/targets.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::function<void(std::string_view)>> readers{
    {"amber_netcdf", fuzz::amber_netcdf}, {"document", fuzz::document},
    {"frame_index", fuzz::frame_index},   {"gzip", fuzz::gzip},
    {"h5md", fuzz::h5md},                 {"lammps_binary", fuzz::lammps_binary},
    {"lammps_text", fuzz::lammps_text},   {"lammps_yaml", fuzz::lammps_yaml},
    {"local_dump", fuzz::local_dump},     {"scene", fuzz::scene},
    {"study", fuzz::study},               {"table", fuzz::table},
    {"thermo_log", fuzz::thermo_log},     {"zstd", fuzz::zstd},
};

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Seeds, AreReadOrRefusedClearly) {
  for (const auto& entry : fs::recursive_directory_iterator(MDANA_SOURCE_DIR "/tests/fuzz/seeds")) {
    if (!entry.is_regular_file()) continue;
    const fs::path& file = entry.path();
    SCOPED_TRACE(file);
    EXPECT_NO_THROW(readers.at(file.parent_path().filename().string())(bytes_of(file)));
  }
}

TEST(Seeds, EveryReaderHasAHarness) {
  for (const auto& entry : fs::directory_iterator(MDANA_SOURCE_DIR "/tests/fuzz")) {
    const std::string name = entry.path().stem().string();
    if (!name.starts_with("fuzz_")) continue;
    EXPECT_TRUE(readers.contains(name.substr(5))) << name;
  }
}

}  // namespace
}  // namespace mdana
