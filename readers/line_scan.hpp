// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines by masks: a comparison of 64 bytes gives a bit for every blank and line end, from which the
// starts and ends of all columns follow without a loop over bytes. To be included by the kernel of
// one kind of processor, after it has defined
//   MDANA_TARGET                    the instructions that its functions may use (BMI2 at least)
//   MDANA_INLINE                    the same, always inlined
//   Masks masks_of(const char*)     a bit for each of 64 bytes
#include <cstddef>
#include <cstdint>

#include "readers/line_kernel.hpp"

namespace mdana {
namespace {

/// Starts and ends of the columns of one line within Words * 64 bytes.
template <int Words>
struct LineMasks {
  std::uint64_t starts[Words], ends[Words];
  std::uint32_t length;   ///< without the line end; Words * 64 if there is none
  std::uint32_t columns;  ///< that begin before the line end

  MDANA_INLINE explicit LineMasks(const char* text) : length(Words * 64), columns(0) {
    std::uint64_t before = 1;  // the line begins behind a blank
    for (int w = 0; w < Words; ++w) {
      const Masks m = masks_of(text + 64 * w);
      const std::uint64_t behind_blank = m.blank << 1 | before;
      starts[w] = ~m.blank & behind_blank;
      ends[w] = m.blank & ~behind_blank;
      before = m.blank >> 63;
      if (length < static_cast<std::uint32_t>(64 * w)) continue;
      const std::uint64_t in_line = m.newline ? _blsmsk_u64(m.newline) : ~std::uint64_t{0};
      columns += static_cast<std::uint32_t>(_mm_popcnt_u64(starts[w] & in_line));
      if (m.newline) length = static_cast<std::uint32_t>(64 * w + _tzcnt_u64(m.newline));
    }
  }

  /// Position of the k-th set bit.
  MDANA_INLINE static std::uint32_t select(const std::uint64_t (&words)[Words], std::uint32_t k) {
    std::uint64_t word = words[0];
    std::uint32_t base = 0;
    for (int w = 1; w < Words; ++w) {  // without branches: where lines break words is random
      const auto count = static_cast<std::uint32_t>(_mm_popcnt_u64(words[w - 1]));
      const bool beyond = base == static_cast<std::uint32_t>(64 * (w - 1)) && k >= count;
      k -= beyond ? count : 0;
      base += beyond ? 64 : 0;
      word = beyond ? words[w] : word;
    }
    return base + static_cast<std::uint32_t>(_tzcnt_u64(_pdep_u64(std::uint64_t{1} << k, word)));
  }
};

template <int Words>
MDANA_TARGET LineKernel::Scanned scan_lines(const char* text, std::size_t lines,
                                            const LineShape& shape, TokenBatch* batches) {
  const char* at = text;
  const std::size_t wanted = shape.wanted.size();
  const std::uint32_t* columns = shape.wanted.data();
  for (std::size_t i = 0; i < lines; ++i) {
    const LineMasks<Words> line(at);
    if (line.columns != shape.columns || line.length >= Words * 64) return {i, at};
    const auto offset = static_cast<std::uint32_t>(at - text);
    for (std::size_t k = 0; k < wanted; ++k) {
      const std::uint32_t start = LineMasks<Words>::select(line.starts, columns[k]);
      const std::uint32_t end = LineMasks<Words>::select(line.ends, columns[k]);
      batches[k].offset[i] = offset + start;
      batches[k].length[i] = static_cast<std::uint8_t>(end - start);
    }
    at += line.length + 1;
  }
  return {lines, at};
}

/// Short lines first; where they are longer, twice as many bytes a line.
MDANA_TARGET LineKernel::Scanned scan(const char* text, std::size_t lines, const LineShape& shape,
                                      TokenBatch* batches) {
  if (shape.columns > 64) return {0, text};
  const LineKernel::Scanned scanned = scan_lines<2>(text, lines, shape, batches);
  return scanned.lines > 0 ? scanned : scan_lines<4>(text, lines, shape, batches);
}

}  // namespace
}  // namespace mdana
