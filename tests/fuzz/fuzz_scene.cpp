// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/scene.hpp"
#include "tests/fuzz/reading.hpp"
#include "tests/fuzz/targets.hpp"

namespace mdana::fuzz {

void scene(std::string_view bytes) {
  const auto file = input_file("scene.toml", bytes);
  read_or_refuse(file, [&] { load_scene(file); });
  read_or_refuse(file, [&] { scene_beside(file.parent_path() / "dump"); });
}

}  // namespace mdana::fuzz
