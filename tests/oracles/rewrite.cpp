// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a trajectory anew in the format of the new name's ending: rewrite OLD NEW.h5
#include <iostream>

#include "readers/input_error.hpp"
#include "readers/trajectory.hpp"

namespace mdana {
namespace {

const Format& format_for(const std::filesystem::path& path) {
  for (const Format* format : formats())
    if (format->create && path.extension() == "." + std::string(format->ending)) return *format;
  throw InputError(path.string() + ": no format writes files of this ending");
}

void rewrite(const std::filesystem::path& from, const std::filesystem::path& to) {
  const auto source = open_trajectory(from, ColumnSet::all_as_they_stand());
  const auto writer = format_for(to).create(to);
  FrameHeader header;
  Chunk chunk;
  AtomBlock block;
  while (source->next(header)) {
    writer->begin(header);
    while (source->cut(chunk)) {
      convert(chunk, block);
      writer->add(block);
    }
  }
  writer->finish();
}

}  // namespace
}  // namespace mdana

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  mdana::rewrite(argv[1], argv[2]);
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
