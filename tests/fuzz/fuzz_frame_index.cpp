// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/frame_index.hpp"

#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <xxhash.h>

#include "tests/fuzz/reading.hpp"
#include "tests/fuzz/targets.hpp"

namespace mdana::fuzz {
namespace {

/// Three frames of two atoms; their headers begin at bytes 0, 118 and 236.
std::string dump() {
  std::string text;
  for (int step = 0; step < 3; ++step)
    text += fmt::format(
        "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n"
        "ITEM: ATOMS id x y z\n1 1 1 1\n2 2 2 2\n", step);
  return text;
}

std::string hash_text(const std::string& text) {
  const XXH128_hash_t h = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", h.high64, h.low64);
}

/// An index that fits the file up to its line of the file's state, and is whole by its hash; what
/// stands between the two are the bytes.
std::string index_with(const std::filesystem::path& file, std::string_view bytes) {
  save_frame_index({{}, "xxh3:0"}, file);
  std::ifstream stream(frame_index_path(file));
  std::string title, state;
  std::getline(stream, title);
  std::getline(stream, state);
  const std::string body = fmt::format("{}\n{}\n{}", title, state, bytes);
  return body + "check " + hash_text(body) + "\n";
}

}  // namespace

/// An index that does not fit is not used, so that nothing is refused here.
void frame_index(std::string_view bytes) {
  const auto file = input_file("indexed.dump", dump());
  const std::string name = frame_index_path(file).filename().string();
  input_file(name, bytes);
  load_frame_index(file);
  input_file(name, index_with(file, bytes));
  read_dump(file);
}

}  // namespace mdana::fuzz
