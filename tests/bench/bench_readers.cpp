// SPDX-License-Identifier: GPL-3.0-or-later
// Reads dumps to arrays through the whole path of the program (open, cut, convert; hashing included),
// and by a plain loop over std::from_chars; prints a JSON line a way to read, best of several times.
//   bench_readers DUMP...      tests/bench/readers.py makes the files and compares with other programs
#include <charconv>
#include <chrono>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>

#include <fmt/format.h>

#include "analyses/block_pipeline.hpp"
#include "readers/trajectory.hpp"

namespace mdana {
namespace {

double sum;  // of what was read, so that reading cannot be left out

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void report(const std::string& file, std::string_view way, const std::function<void()>& work) {
  double best = 1e300;
  for (int repeat = 0; repeat < 7; ++repeat) best = std::min(best, seconds_of(work));
  fmt::print("{{\"file\": \"{}\", \"way\": \"{}\", \"seconds\": {:.6f}}}\n", file, way, best);
  std::fflush(stdout);
}

void read_by_mdana(const std::string& file, const ColumnSet& wanted, std::size_t threads) {
  const auto source = open_trajectory(file, wanted);
  std::vector<Chunk> chunks(threads == 1 ? 1 : 2 * threads);
  std::vector<AtomBlock> blocks(chunks.size());
  FrameHeader header;
  BlockPipeline pipeline;
  pipeline.threads = threads;
  pipeline.slots = chunks.size();
  pipeline.produce = [&](std::size_t slot) { return source->cut(chunks[slot]); };
  pipeline.work = [&](std::size_t slot) { convert(chunks[slot], blocks[slot]); };
  pipeline.collect = [&](std::size_t slot) {
    if (blocks[slot].atoms() > 0) sum += blocks[slot].real("vx")[0];
  };
  while (source->next(header)) run(pipeline);
}

const char* find(const char* at, const char* end, char wanted) {
  return static_cast<const char*>(std::memchr(at, wanted, static_cast<std::size_t>(end - at)));
}

/// The same numbers by std::from_chars, of a file whose atom lines have nine columns.
void read_by_from_chars(const std::string& text, bool all) {
  const char* at = text.data();
  const char* end = at + text.size();
  std::size_t atoms = 0;
  while (at < end) {
    const char* newline = find(at, end, '\n');
    const std::string_view line(at, static_cast<std::size_t>(newline - at));
    if (atoms > 0) {
      const char* word = at;
      for (int column = 0; column < 9; ++column) {
        double value = 0;
        if (all || column == 0 || column == 5 || column == 6)
          word = std::from_chars(word, newline, value).ptr + 1;
        else
          word = find(word, newline, ' ') + 1;
        sum += value;
      }
      --atoms;
    } else if (line.starts_with("ITEM: NUMBER")) {
      std::from_chars(newline + 1, end, atoms);
      for (int k = 0; k < 6; ++k) newline = find(newline + 1, end, '\n');
    }
    at = newline + 1;
  }
}

void read(const std::string& file) {
  const ColumnSet some{"id", "vx", "vy"};
  const ColumnSet all{"id", "type", "x", "y", "z", "vx", "vy", "vz", "c_pe"};
  for (const std::size_t threads : {1, 2}) {
    report(file, fmt::format("3 columns, {} thread{}", threads, threads > 1 ? "s" : ""),
           [&] { read_by_mdana(file, some, threads); });
    report(file, fmt::format("9 columns, {} thread{}", threads, threads > 1 ? "s" : ""),
           [&] { read_by_mdana(file, all, threads); });
  }
  ColumnSet tenth = all;
  tenth.select(Selection("id:1-22729"));
  report(file, "9 columns, 22729 atoms, 1 thread", [&] { read_by_mdana(file, tenth, 1); });
  if (format_of(file) != "lammps_text" || file.ends_with(".gz") || file.ends_with(".zst")) return;
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  report(file, "3 columns, from_chars", [&] { read_by_from_chars(text, false); });
  report(file, "9 columns, from_chars", [&] { read_by_from_chars(text, true); });
}

}  // namespace
}  // namespace mdana

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) mdana::read(argv[i]);
  return mdana::sum == 0.125 ? 1 : 0;
}
