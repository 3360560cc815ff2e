// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "analyses/sweep.hpp"
#include "readers/faults.hpp"
#include "readers/input_record.hpp"

namespace mdana {

struct CheckOptions {
  std::size_t limit = 20;                       ///< faults of a kind that are kept; all are counted
  std::size_t threads = 1;                      ///< for the blocks of a frame; at least 1
  std::size_t memory = std::size_t{128} << 20;  ///< bytes for ids; beyond it they are not compared
  const std::atomic<int>* stop = nullptr;       ///< set to a signal number to stop
  std::function<void(const Progress&)> progress;  ///< called after each frame
};

/// What is wrong with a dump, and what was looked at.
struct CheckResult {
  Faults faults;
  std::uint64_t frames = 0;          ///< whose atoms were read
  std::uint64_t atoms = 0;           ///< in all these frames
  std::vector<std::string> columns;  ///< of these frames, each once
  bool ids_compared = false;         ///< in at least two frames
  bool to_the_end = false;           ///< else what follows the last fault could not be read
  std::vector<InputRecord> inputs;
  double seconds = 0;
};

/// Reads every column of every atom of every frame and goes on after faults as far as the format
/// allows. Memory: the blocks under way, 8 bytes for each atom of the first whole frame and, while
/// it is read, 16 more; both only if there are ids.
/// Throws InputError if the dump cannot be opened at all, Interrupted if `stop` is set.
CheckResult check_dump(const std::filesystem::path& dump, const CheckOptions& options = {});

}  // namespace mdana
