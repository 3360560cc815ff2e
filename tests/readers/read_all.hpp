// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "readers/input_error.hpp"
#include "readers/trajectory.hpp"

namespace mdana::test {

/// One frame as read, its blocks put together.
struct WholeFrame {
  FrameHeader header;
  std::map<std::string, std::vector<double>> real;
  std::map<std::string, std::vector<std::int64_t>> integer;
  std::vector<std::size_t> block_atoms;
};

/// Frames of a dump up to its end or its first error.
struct WholeTrajectory {
  std::vector<WholeFrame> frames;
  std::string error;       ///< empty if it ended cleanly
  bool truncated = false;  ///< the error was TruncatedInput
};

inline void append(const AtomBlock& block, const ColumnSet& wanted, WholeFrame& frame) {
  frame.block_atoms.push_back(block.atoms());
  for (const std::string& name : wanted.names()) {
    if (kind_of_column(name) == ColumnKind::integer) {
      const auto values = block.integer(name);
      frame.integer[name].insert(frame.integer[name].end(), values.begin(), values.end());
    } else {
      const auto values = block.real(name);
      frame.real[name].insert(frame.real[name].end(), values.begin(), values.end());
    }
  }
}

inline void read_blocks(FrameSource& source, const ColumnSet& wanted, WholeFrame& frame) {
  Chunk chunk;
  AtomBlock block;
  while (source.cut(chunk)) {
    convert(chunk, block);
    append(block, wanted, frame);
  }
}

inline WholeTrajectory read_all(const std::filesystem::path& path, const ColumnSet& wanted) {
  WholeTrajectory whole;
  try {
    const auto source = open_trajectory(path, wanted);
    WholeFrame frame;
    while (source->next(frame.header)) {
      read_blocks(*source, wanted, frame);
      whole.frames.push_back(frame);
      frame = {};
    }
  } catch (const TruncatedInput& error) {
    whole.error = error.what();
    whole.truncated = true;
  } catch (const InputError& error) {
    whole.error = error.what();
  }
  return whole;
}

}  // namespace mdana::test
