// SPDX-License-Identifier: GPL-3.0-or-later
// What libFuzzer calls; MDANA_FUZZED is the reader.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mdana::fuzz::MDANA_FUZZED({reinterpret_cast<const char*>(data), size});
  return 0;
}
