// SPDX-License-Identifier: GPL-3.0-or-later
// Reading columns out of atom lines: the kernels against a plain loop over std::from_chars (which in
// this library is fast_float), over the same bytes. Compare ratios within one run.
#include <charconv>
#include <cstring>
#include <random>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "readers/frame.hpp"
#include "readers/line_kernel.hpp"
#include "readers/line_reader.hpp"

namespace mdana {
namespace {

constexpr std::size_t atoms = 1 << 16;
constexpr std::uint32_t columns = 9;

/// id type x y z vx vy vz c_pe as LAMMPS prints them with %.10g, of a cold sphere.
const std::string& text() {
  static const std::string made = [] {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> place(-30, 30), energy(-9, -4);
    std::normal_distribution<double> speed(0, 1e-3);
    std::string lines(LineReader::lead, ' ');
    for (std::size_t i = 0; i < atoms; ++i)
      lines += fmt::format("{} {} {:.10g} {:.10g} {:.10g} {:.10g} {:.10g} {:.10g} {:.10g} \n", i + 1,
                           1 + i % 2, place(random), place(random), place(random), speed(random),
                           speed(random), speed(random), energy(random));
    lines.append(Chunk::padding, ' ');
    return lines;
  }();
  return made;
}

LineShape shape(bool all) {
  if (all) return {columns, {0, 1, 2, 3, 4, 5, 6, 7, 8}};
  return {columns, {0, 2, 5}};  // id, x, vx
}

void count_bytes(benchmark::State& state) {
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(text().size() - Chunk::padding - LineReader::lead));
}

void by_kernel(benchmark::State& state, const LineKernel* kernel, bool all, bool convert) {
  if (!kernel->supported()) return state.SkipWithError("not supported by this processor");
  const LineShape wanted = shape(all);
  std::vector<TokenBatch> batches(wanted.wanted.size());
  std::vector<double> reals(TokenBatch::capacity);
  std::vector<std::int64_t> integers(TokenBatch::capacity);
  for (auto _ : state) {
    const char* at = text().data() + LineReader::lead;
    for (std::size_t done = 0; done < atoms;) {
      const auto scanned = kernel->scan(at, std::min(TokenBatch::capacity, atoms - done), wanted,
                                        batches.data());
      for (std::size_t k = 0; convert && k < batches.size(); ++k) {
        if (wanted.wanted[k] < 2)
          kernel->integers(at, batches[k], scanned.lines, integers.data());
        else
          kernel->reals(at, batches[k], scanned.lines, reals.data());
        benchmark::ClobberMemory();
      }
      benchmark::ClobberMemory();
      at = scanned.end;
      done += scanned.lines;
    }
  }
  count_bytes(state);
}

void by_from_chars(benchmark::State& state, bool all) {
  const LineShape wanted = shape(all);
  for (auto _ : state) {
    const char* at = text().data() + LineReader::lead;
    const char* end = at + text().size() - Chunk::padding - LineReader::lead;
    while (at < end) {
      std::uint32_t column = 0;
      for (const std::uint32_t k : wanted.wanted) {
        for (; column < k; ++column) at = std::strchr(at, ' ') + 1;
        double value = 0;
        at = std::from_chars(at, end, value).ptr + 1;
        ++column;
        benchmark::DoNotOptimize(value);
      }
      at = static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at))) + 1;
    }
  }
  count_bytes(state);
}

const int registered = [] {
  for (const bool all : {false, true}) {
    const std::string which = all ? "all_9_columns" : "3_of_9_columns";
    benchmark::RegisterBenchmark(("from_chars/" + which).c_str(), by_from_chars, all);
    for (const LineKernel* kernel : line_kernels())
      for (const bool convert : {false, true})
        benchmark::RegisterBenchmark(
            (std::string(kernel->name) + (convert ? "/" : "_scan_only/") + which).c_str(), by_kernel,
            kernel, all, convert);
  }
  return 0;
}();

}  // namespace
}  // namespace mdana

BENCHMARK_MAIN();
