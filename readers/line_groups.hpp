// SPDX-License-Identifier: GPL-3.0-or-later
//
// Batches of tokens by a kernel that converts `at_once` of them. To be included by the kernel, after it
// has defined MDANA_TARGET and MDANA_INLINE (see line_scan.hpp), `at_once`, and
//   std::uint64_t reals_of(const char* text, const std::uint32_t* offset, const std::uint8_t* length,
//                          double* values)        a bit for each token that it cannot convert
//   std::uint64_t integers_of(...)                the same for whole numbers
#include <cstddef>
#include <cstdint>

#include "readers/line_kernel.hpp"

namespace mdana {
namespace {

/// All tokens in groups; the last group is filled up with its first token.
template <class T, class Convert>
MDANA_INLINE std::uint64_t in_groups(const char* text, const TokenBatch& tokens, std::size_t lines,
                                     T* values, Convert&& convert) {
  std::uint64_t failed = 0;
  std::size_t i = 0;
  for (; i + at_once <= lines; i += at_once)
    failed |= convert(text, &tokens.offset[i], &tokens.length[i], values + i) << i;
  if (i == lines) return failed;
  std::uint32_t offset[at_once];
  std::uint8_t length[at_once];
  T last[at_once];
  for (std::size_t k = 0; k < at_once; ++k) {
    const std::size_t from = i + k < lines ? i + k : i;
    offset[k] = tokens.offset[from];
    length[k] = tokens.length[from];
  }
  const std::uint64_t rest = convert(text, offset, length, last);
  for (std::size_t k = 0; i + k < lines; ++k) values[i + k] = last[k];
  return failed | (rest & ((1u << (lines - i)) - 1)) << i;
}

MDANA_TARGET std::uint64_t reals(const char* text, const TokenBatch& tokens, std::size_t lines,
                                 double* values) {
  return in_groups(text, tokens, lines, values,
                   [](const char* t, const std::uint32_t* offset, const std::uint8_t* length,
                      double* to) MDANA_TARGET { return reals_of(t, offset, length, to); });
}

MDANA_TARGET std::uint64_t integers(const char* text, const TokenBatch& tokens, std::size_t lines,
                                    std::int64_t* values) {
  return in_groups(text, tokens, lines, values,
                   [](const char* t, const std::uint32_t* offset, const std::uint8_t* length,
                      std::int64_t* to) MDANA_TARGET { return integers_of(t, offset, length, to); });
}

}  // namespace
}  // namespace mdana
