// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyses/sweep.hpp"
#include "readers/format.hpp"
#include "readers/frame_choice.hpp"
#include "readers/input_record.hpp"
#include "readers/selection.hpp"
#include "reports/added_columns.hpp"

namespace mdana {

/// A dump to be written anew, and how.
struct Conversion {
  std::filesystem::path dump;
  std::filesystem::path output;
  const Format* format = nullptr;     ///< of the output; it has `create`
  std::vector<std::string> columns;   ///< of the dump, in this order; empty: all as they stand
  std::vector<AddedColumns> added;    ///< behind them
  std::string sort;                   ///< by this column of whole numbers; empty: order of the dump
  FrameChoice choice;                 ///< of frames
  std::optional<Selection> selection; ///< of atoms
  bool strict = false;                ///< damaged input is an error
  std::optional<Units> units;         ///< stated in the output
  std::optional<double> timestep;     ///< [time] states times as step * timestep; else the dump's
  bool omit_units = false, omit_time = false;
  std::size_t threads = 1;            ///< for the blocks of a frame
  const std::atomic<int>* stop = nullptr;              ///< set to a signal number to stop
  std::function<void(const Progress&)> progress;       ///< called after each frame
};

struct Converted {
  std::uint64_t frames = 0;
  std::int64_t first_step = 0, last_step = 0;
  std::uint64_t least_atoms = 0, most_atoms = 0;
  std::vector<std::string> columns;  ///< written, of the first frame
  bool columns_change = false;
  bool positions_may_jump = false;   ///< of the dump: wrapped at periodic faces, without image flags
  std::string damage;                ///< why reading ended before the end of the dump, else empty
  std::vector<InputRecord> inputs;
  std::uint64_t size = 0;            ///< of the output [bytes]
  double seconds = 0;
};

/// Throws InputError if the output is there and no file, or is one of the files of the dump.
void check_new_file(const std::filesystem::path& dump, const std::filesystem::path& output);

/// Writes the dump anew, block by block in bounded memory; a frame that is sorted, or of which atoms
/// are selected, is in memory as a whole. The output is made whole or not at all. Of a dump that is damaged the frames before are
/// written, and `damage` says why: if the damage is met within a frame, the dump is read once more
/// up to it. Throws InputError if no frame can be used or the output is one of the inputs, Interrupted
/// if `stop` is set, std::runtime_error if the output cannot be written or cannot hold the frames.
Converted convert_dump(const Conversion& conversion);

}  // namespace mdana
