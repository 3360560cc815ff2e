// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/csv_table.hpp"
#include "reports/observations.hpp"
#include "tests/fuzz/reading.hpp"
#include "tests/fuzz/targets.hpp"

namespace mdana::fuzz {

void table(std::string_view bytes) {
  const auto file = input_file("table.csv", bytes);
  read_or_refuse(file, [&] { read_csv_table(file); });
  for (const Wanted wanted : {Wanted::restitution, Wanted::compression, Wanted::motion}) {
    ObservationSettings settings;
    settings.wanted = wanted;
    read_or_refuse(file, [&] { read_observations({&file, 1}, settings); });
  }
}

}  // namespace mdana::fuzz
