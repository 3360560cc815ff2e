// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/reading.hpp"

#include "readers/trajectory.hpp"

namespace mdana::fuzz {
namespace {

constexpr std::size_t longest_message = 4096;

void read_blocks(FrameSource& source) {
  Chunk chunk;
  AtomBlock block;
  while (source.cut(chunk)) {
    convert(chunk, block);
    place_of(chunk, 0);
  }
}

void read_frames(const std::filesystem::path& file, const ColumnSet& wanted) {
  const auto source = open_trajectory(file, wanted);
  FrameHeader header;
  while (source->next(header)) {
    read_blocks(*source);
    source->restart_frame();
  }
  source->records();
}

void read_precision(const std::filesystem::path& file) {
  const auto source = open_trajectory(file, ColumnSet::all_as_they_stand());
  FrameHeader header;
  Chunk chunk;
  while (source->next(header))
    while (source->cut(chunk, 7))
      for (const std::string& column : header.columns)
        chunk.layout->printed_precision(chunk, column);
}

void seek_frames(const std::filesystem::path& file) {
  const auto source = open_trajectory(file, {"x", "y", "z"});
  FrameHeader header;
  for (std::uint64_t frame = 2; frame < 10; frame += 3) {
    source->seek(frame);
    if (!source->next(header)) return;
    read_blocks(*source);
  }
}

/// One frame, and what is wrong with its atoms. False behind the last.
bool check_frame(FrameSource& source) {
  FrameHeader header;
  if (!source.next(header)) return false;
  Chunk chunk;
  AtomBlock block;
  while (source.cut(chunk)) {
    BlockFaults faults;
    faults.reset();
    chunk.layout->check(chunk, block, faults);
  }
  return true;
}

void check_frames(const std::filesystem::path& file) {
  const auto source = open_trajectory(file, ColumnSet::all_as_they_stand());
  source->expect_faults();
  for (bool more = true; more;)
    try {
      more = check_frame(*source);
    } catch (const InputError& error) {
      expect_clear(error, file);
      more = source->recover();
    }
}

}  // namespace

std::filesystem::path input_file(const std::string& name, std::string_view bytes) {
  static const test::TemporaryFolder folder;
  return folder.write(name, bytes);
}

void expect_clear(const InputError& error, const std::filesystem::path& file) {
  const std::string_view text = error.what();
  if (text.find(file.filename().string()) == std::string_view::npos || text.size() > longest_message)
    throw std::logic_error("not a clear message: " + std::string(text.substr(0, longest_message)));
}

void read_dump(const std::filesystem::path& file) {
  const ColumnSet everything = ColumnSet::all_as_they_stand();
  ColumnSet selected{"x", "y", "z", "type"};
  selected.select(Selection("id:2-5"));
  read_or_refuse(file, [&] { count_frames(file); });
  read_or_refuse(file, [&] { read_frames(file, everything); });
  read_or_refuse(file, [&] { read_frames(file, selected); });
  read_or_refuse(file, [&] { read_precision(file); });
  read_or_refuse(file, [&] { seek_frames(file); });
  read_or_refuse(file, [&] { check_frames(file); });
}

}  // namespace mdana::fuzz
