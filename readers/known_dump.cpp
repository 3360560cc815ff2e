// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/known_dump.hpp"

#include "readers/scratch_file.hpp"
#include "readers/trajectory.hpp"

namespace mdana {

void TiltedPair::add(std::string what, double computed, double exact) {
  answers.push_back({std::move(what), computed, exact, 16});
}

TiltedPair read_tilted_pair(std::string_view bytes) {
  const ScratchFile file(bytes);
  TiltedPair pair;
  pair.header = for_first_frame(file.path(), {"id", "x", "y", "z"}, [&](const AtomBlock& block) {
    const auto x = block.real("x"), y = block.real("y"), z = block.real("z");
    pair.add("x inside a tilted box", x[0], -4 + 0.5 * 8 + 0.25 * 2 + 0.125 * -1);
    pair.add("y inside a tilted box", y[0], -2 + 0.25 * 4 + 0.125 * 1);
    pair.add("z inside a tilted box", z[0], 0.125 * 16);
    pair.add("x with image flags", x[1], -4 + 8 + 2 - 1 + 8 + 2);
    pair.add("y with image flags", y[1], -2 + 4 + 1 - 2);
    pair.add("z with image flags", z[1], 16 - 32);
    pair.add("id", static_cast<double>(block.integer("id")[1]), 3);
  });
  pair.add("step", static_cast<double>(pair.header.step), 5e9);
  pair.add("origin, x", pair.header.box.origin.x(), -4);
  return pair;
}

}  // namespace mdana
