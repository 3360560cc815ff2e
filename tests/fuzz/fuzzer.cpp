// SPDX-License-Identifier: GPL-3.0-or-later
// What libFuzzer calls; MDANA_FUZZED is the reader.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.hpp"

/// HDF5 (1.10.8) does not free what it has read of an object header that it then refuses; what mdana holds of
/// HDF5 stands in that library's tables, where no sanitizer sees a leak anyway.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5\n"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mdana::fuzz::MDANA_FUZZED({reinterpret_cast<const char*>(data), size});
  return 0;
}
