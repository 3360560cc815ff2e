// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study.hpp"
#include "tests/fuzz/reading.hpp"
#include "tests/fuzz/targets.hpp"

namespace mdana::fuzz {

void study(std::string_view bytes) {
  const auto file = input_file("study.toml", bytes);
  read_or_refuse(file, [&] { study_toml(read_study(file)); });
}

}  // namespace mdana::fuzz
