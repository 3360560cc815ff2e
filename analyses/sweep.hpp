// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "analyses/analysis.hpp"
#include "readers/input_record.hpp"
#include "readers/masses.hpp"

namespace mdana {

struct SweepOptions {
  std::uint64_t stride = 1;                     ///< use frames 0, stride, 2 stride, ...
  std::optional<std::uint64_t> frames;          ///< stop after so many
  std::size_t threads = 1;                      ///< for the blocks of a frame; at least 1
  std::size_t memory = std::size_t{128} << 20;  ///< bytes for blocks kept between two rounds
  /// Moves every converted real number at random within its last printed digit (see
  /// readers/last_digit.hpp); the number is the seed.
  std::optional<std::uint64_t> last_digit_seed;
  const std::atomic<int>* stop = nullptr;       ///< set to a signal number to stop
  std::function<void(std::uint64_t frames)> progress;  ///< called after each frame
};

/// The sweep was stopped by a signal.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(int number)
      : std::runtime_error("stopped by a signal"), signal(number) {}
  int signal;
};

/// One row a frame in each table, in the order of the analyses.
struct SweepResult {
  std::vector<Table> tables;
  std::vector<std::int64_t> steps;   ///< of the frames used
  std::vector<double> stated_times;  ///< [time] as the dump states them; empty if it does not
  bool positions_may_jump = false;   ///< wrapped at periodic faces, without image flags
  std::vector<std::string> columns_read;      ///< of the first frame used, as the dump names them
  std::vector<std::string> columns_not_read;  ///< the others: nothing in them was looked at
  std::string damage;                ///< why reading ended before the end of the file, else empty
  std::vector<InputRecord> inputs;   ///< of the whole files; none if `frames` stopped the sweep
  double seconds = 0;
};

/// The one loop over frames: reads a trajectory once, only the columns that the analyses need, and
/// gives every block of atoms to all of them. Analyses that need the bodies' motion see the blocks
/// of a frame a second time (from memory if they fit, else read again); for them the list must hold
/// a motion analysis, by convention its first.
/// Frames from one that is damaged on are left out and `damage` says why; throws InputError if
/// nothing can be used at all, Interrupted if `stop` is set, std::invalid_argument at stride 0.
SweepResult sweep(const std::filesystem::path& dump, const Bodies& bodies, const Masses& masses,
                  std::span<const std::unique_ptr<Analysis>> analyses,
                  const SweepOptions& options = {});

}  // namespace mdana
