// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "readers/byte_source.hpp"
#include "readers/gzip.hpp"
#include "readers/raw_file.hpp"
#include "tests/fuzz/reading.hpp"
#include "tests/fuzz/targets.hpp"

namespace mdana::fuzz {
namespace {

/// Some, then all from a mark on twice.
void read_bytes(ByteSource& source) {
  std::array<char, 1000> room;
  source.read(std::span(room).first(100));
  source.mark();
  while (source.read(room) == room.size()) continue;
  source.reset();
  while (source.read(room) == room.size()) continue;
  source.damage();
  source.record();
}

}  // namespace

void gzip(std::string_view bytes) {
  const auto file = input_file("gzip.input", bytes);
  read_bytes(*open_gzip(std::make_unique<RawFile>(file), make_zlib_inflate()));
  if (auto isal = make_isal_inflate())
    read_bytes(*open_gzip(std::make_unique<RawFile>(file), std::move(isal)));
  read_dump(file);
}

}  // namespace mdana::fuzz
