// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include "tests/fuzz/reading.hpp"
#include "tests/fuzz/targets.hpp"

namespace mdana::fuzz {
namespace {

/// The text behind as many bytes as make a file that is not mapped: the same lines go another way.
std::string stored(std::string_view text) {
  uLongf size = compressBound(static_cast<uLong>(text.size())) + 64;
  std::string packed(size, '\0');
  z_stream stream{};
  deflateInit2(&stream, Z_NO_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

}  // namespace

void lammps_text(std::string_view bytes) {
  read_dump(input_file("lammps_text.input", bytes));
  read_dump(input_file("lammps_text.gz", stored(bytes)));
}

}  // namespace mdana::fuzz
