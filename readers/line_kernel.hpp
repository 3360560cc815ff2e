// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace mdana {

/// The columns of a line and those of them that are wanted, ascending.
struct LineShape {
  std::uint32_t columns = 0;
  std::vector<std::uint32_t> wanted;
};

/// Where one wanted column stands in each of a batch of lines.
struct TokenBatch {
  static constexpr std::size_t capacity = 64;
  std::array<std::uint32_t, capacity> offset;  ///< from the start of the batch's first line
  std::array<std::uint8_t, capacity> length;   ///< bytes, at least 1
};

/// The two halves of reading numbers out of lines, written for one kind of processor. Texts must be
/// whole lines with Chunk::padding readable bytes behind and
/// LineReader::lead before them.
struct LineKernel {
  struct Scanned {
    std::size_t lines;
    const char* end;  ///< behind the last of them
  };

  std::string_view name;
  bool (*supported)();  ///< by the processor that runs it

  /// Finds the wanted columns of at most TokenBatch::capacity lines, one batch a wanted column.
  /// Stops before a line that has another number of columns or is too long for it.
  Scanned (*scan)(const char* text, std::size_t lines, const LineShape& shape,
                  TokenBatch* batches);

  /// Converts tokens, correctly rounded; bit i of the result is set where token i is no number in
  /// the kernel's reach, and its value is then undefined.
  std::uint64_t (*reals)(const char* text, const TokenBatch& tokens, std::size_t lines,
                         double* values);
  std::uint64_t (*integers)(const char* text, const TokenBatch& tokens, std::size_t lines,
                            std::int64_t* values);
};

/// All kernels of this build, fastest first; the last one runs everywhere.
std::span<const LineKernel* const> line_kernels();

/// The fastest one that this processor supports.
const LineKernel& best_line_kernel();

/// A blank between columns: everything up to the space but the line end.
constexpr bool is_gap(char c) { return static_cast<unsigned char>(c) <= ' ' && c != '\n'; }

/// The whole token as a number, correctly rounded; false if it is none.
bool parse_number(std::string_view token, double& value);
bool parse_number(std::string_view token, std::int64_t& value);

}  // namespace mdana
