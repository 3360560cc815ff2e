// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/line_kernel.hpp"

#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>

namespace mdana {

extern const LineKernel avx512_kernel;
extern const LineKernel avx2_kernel;

namespace {

/// Passes over one line and notes its wanted columns; null if it does not have the shape.
const char* scan_line(const char* at, const char* start, const LineShape& shape, std::size_t line,
                      TokenBatch* batches) {
  std::uint32_t column = 0;
  std::size_t next = 0;  // of the wanted ones
  while (true) {
    while (is_gap(*at)) ++at;
    if (*at == '\n') return column == shape.columns ? at + 1 : nullptr;
    const char* token = at;
    while (static_cast<unsigned char>(*at) > ' ') ++at;
    if (next < shape.wanted.size() && column == shape.wanted[next]) {
      const auto length = static_cast<std::size_t>(at - token);
      if (length > std::numeric_limits<std::uint8_t>::max()) return nullptr;
      batches[next].offset[line] = static_cast<std::uint32_t>(token - start);
      batches[next].length[line] = static_cast<std::uint8_t>(length);
      ++next;
    }
    ++column;
  }
}

LineKernel::Scanned scan(const char* text, std::size_t lines, const LineShape& shape,
                         TokenBatch* batches) {
  const char* at = text;
  for (std::size_t i = 0; i < lines; ++i) {
    const char* end = scan_line(at, text, shape, i, batches);
    if (!end) return {i, at};
    at = end;
  }
  return {lines, at};
}

template <class T>
std::uint64_t convert(const char* text, const TokenBatch& tokens, std::size_t lines, T* values) {
  std::uint64_t failed = 0;
  for (std::size_t i = 0; i < lines; ++i)
    if (!parse_number({text + tokens.offset[i], tokens.length[i]}, values[i]))
      failed |= std::uint64_t{1} << i;
  return failed;
}

const LineKernel portable_kernel{"portable", [] { return true; }, scan, convert<double>,
                                 convert<std::int64_t>};

}  // namespace

std::span<const LineKernel* const> line_kernels() {
#if defined(__x86_64__)
  static constexpr const LineKernel* kernels[] = {&avx512_kernel, &avx2_kernel, &portable_kernel};
#else
  static constexpr const LineKernel* kernels[] = {&portable_kernel};
#endif
  return kernels;
}

const LineKernel& best_line_kernel() {
  static const LineKernel& best = []() -> const LineKernel& {
    for (const LineKernel* kernel : line_kernels())
      if (kernel->supported()) return *kernel;
    return portable_kernel;
  }();
  return best;
}

bool parse_number(std::string_view token, double& value) {
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (stop != end) return false;
  if (error == std::errc::result_out_of_range)  // 1e-400, 1e400
    value = std::strtod(std::string(token).c_str(), nullptr);
  return error == std::errc{} || error == std::errc::result_out_of_range;
}

bool parse_number(std::string_view token, std::int64_t& value) {
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  return error == std::errc{} && stop == end;
}

}  // namespace mdana
