// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/observations.hpp"
#include "tests/fuzz/reading.hpp"
#include "tests/fuzz/targets.hpp"

namespace mdana::fuzz {

void document(std::string_view bytes) {
  const auto file = input_file("document.json", bytes);
  for (const Wanted wanted : {Wanted::restitution, Wanted::compression, Wanted::motion})
    read_or_refuse(file, [&] { parse_observed_document(bytes, file.string(), wanted); });
}

}  // namespace mdana::fuzz
