// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analyses/analysis.hpp"
#include "analyses/frame_run.hpp"
#include "readers/frame_choice.hpp"
#include "readers/input_record.hpp"
#include "readers/masses.hpp"

namespace mdana {

/// How far a sweep is.
struct Progress {
  std::uint64_t frames = 0;     ///< done
  std::optional<double> share;  ///< of the input, 0 to 1, if it is known
};

struct SweepOptions {
  FrameChoice choice;                           ///< of frames
  std::optional<Selection> selection;           ///< of atoms
  std::optional<std::uint64_t> frames;          ///< stop after so many
  std::size_t threads = 1;                      ///< at least 1
  std::size_t memory = std::size_t{128} << 20;  ///< bytes for blocks kept between two rounds
  /// Bytes for the atoms of a frame that are needed together, besides; what needs more is done in
  /// parts, by way of temporary files. Default: half of what the machine has free, shared by its ranks.
  std::optional<std::size_t> frame_memory;
  bool strict = false;                          ///< damaged input is an error, not a result
  /// Moves every converted real number at random within its last printed digit (see
  /// readers/last_digit.hpp); the number is the seed.
  std::optional<std::uint64_t> last_digit_seed;
  int dropped_digits = 0;  ///< rounds every converted real number to so many decimal digits fewer
  const std::atomic<int>* stop = nullptr;  ///< set to a signal number to stop
  std::function<void(const Progress&)> progress;  ///< called after each frame
};

/// One row a frame in each table, in the order of the analyses.
struct SweepResult {
  std::vector<Table> tables;
  std::vector<std::int64_t> steps;   ///< of the frames used
  std::vector<double> stated_times;  ///< [time] as the dump states them; empty if it does not
  bool unwrapped = false;            ///< positions, by continuity: there are no image flags
  std::uint64_t uncertain_images = 0;  ///< most atoms of a frame whose image is uncertain
  std::vector<std::string> columns_read;      ///< of the first frame used, as the dump names them
  std::vector<std::string> columns_not_read;  ///< the others: nothing in them was looked at
  std::string damage;                ///< why reading ended before the end of the file, else empty
  std::vector<InputRecord> inputs;   ///< of the whole files; none if `frames` stopped the sweep, or on another rank
  double seconds = 0;
};

/// The one loop over frames: reads a trajectory once, only the columns that the analyses need, and
/// gives every block of atoms to all of them. Analyses that need the bodies' motion see the blocks
/// of a frame a second time (from memory if they fit, else read again); for them the list must hold
/// a motion analysis, by convention its first. Analyses of whole frames get the atoms of the bodies
/// together (see analyses/frame_atoms.hpp), and what they have to write is given on in the order of
/// the frames, one frame late. Threads share the blocks of large frames, and small
/// frames, and so do ranks (readers/ranks.hpp; analyses/rank_sweep.hpp): all of them call it and get the whole result, but
/// products and `inputs` are given to the first one only. The bits of the result depend on neither.
/// Wrapped positions without image flags are unwrapped by continuity (see analyses/box_centres.hpp).
/// Frames from one that is damaged on are left out, and one right before it that has another number of
/// atoms than the frame before, and `damage` says why; throws InputError if
/// nothing can be used at all, Interrupted if `stop` is set, std::invalid_argument at stride 0.
SweepResult sweep(const std::filesystem::path& dump, const Bodies& bodies, const Masses& masses,
                  std::span<const std::unique_ptr<Analysis>> analyses,
                  const SweepOptions& options = {});

}  // namespace mdana
