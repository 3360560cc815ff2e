// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <random>

#include <fmt/format.h>

#include "readers/known_answer.hpp"
#include "readers/trajectory.hpp"

namespace mdana {

std::vector<KnownAnswer> lammps_yaml_known();

namespace {

// Edges a = (8, 0, 0), b = (2, 4, 0), c = (-1, 1, 16) from the corner (-4, -2, 0); the bounds are
// those of the box around it: x from -4 - 1 to 4 + 2, y from -2 to 2 + 1.
constexpr const char* dump = R"(---
creator: LAMMPS
timestep: 5000000000
units: metal
time: 0.125
natoms: 2
boundary: [ p, p, p, p, f, f, ]
thermo:
  - keywords: [ Step, Temp, ]
  - data: [ 5000000000, 1.5, ]
box:
  - [ -5, 6 ]
  - [ -2, 3 ]
  - [ 0, 16 ]
  - [ 2, -1, 1 ]
keywords: [ id, xs, ys, zs, type, element, ix, iy, iz,  ]
data:
  - [ 7, 0.5, 0.25, 0.125, 1, Si, 0, 0, 0, ]
  - [ 3, 1, 1, 1, 2, 'O', 1, 0, -2, ]
...
)";

/// Writes the dump to a file of its own, which is gone afterwards.
class DumpFile {
 public:
  DumpFile()
      : path(std::filesystem::temp_directory_path() /
             fmt::format("mdana-known-{:08x}.yaml", std::random_device{}())) {
    std::ofstream(path) << dump;
  }
  ~DumpFile() { std::filesystem::remove(path); }
  DumpFile(const DumpFile&) = delete;
  DumpFile& operator=(const DumpFile&) = delete;

  const std::filesystem::path path;
};

}  // namespace

std::vector<KnownAnswer> lammps_yaml_known() {
  const DumpFile file;
  std::vector<KnownAnswer> answers;
  const auto add = [&](std::string what, double computed, double exact) {
    answers.push_back({std::move(what), computed, exact, 16});
  };
  const FrameHeader header =
      for_first_frame(file.path, {"id", "x", "y", "z"}, [&](const AtomBlock& block) {
        const auto x = block.real("x"), y = block.real("y"), z = block.real("z");
        add("x inside a tilted box", x[0], -4 + 0.5 * 8 + 0.25 * 2 + 0.125 * -1);
        add("y inside a tilted box", y[0], -2 + 0.25 * 4 + 0.125 * 1);
        add("z inside a tilted box", z[0], 0.125 * 16);
        add("x with image flags", x[1], -4 + 8 + 2 - 1 + 8 + 2);
        add("y with image flags", y[1], -2 + 4 + 1 - 2);
        add("z with image flags", z[1], 16 - 32);
        add("id", static_cast<double>(block.integer("id")[1]), 3);
      });
  add("step", static_cast<double>(header.step), 5e9);
  add("time", header.time.value_or(0), 0.125);
  add("origin, x", header.box.origin.x(), -4);
  return answers;
}

}  // namespace mdana
