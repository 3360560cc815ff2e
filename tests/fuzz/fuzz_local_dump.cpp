// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/local_dump.hpp"
#include "tests/fuzz/reading.hpp"
#include "tests/fuzz/targets.hpp"

namespace mdana::fuzz {

void local_dump(std::string_view bytes) {
  const auto file = input_file("contacts.dump", bytes);
  read_or_refuse(file, [&] {
    LocalDump dump(file, {"c_ids[1]", "c_ids[2]", "c_force"});
    while (dump.next()) continue;
    dump.record();
  });
}

}  // namespace mdana::fuzz
