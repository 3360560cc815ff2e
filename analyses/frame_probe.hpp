// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "analyses/frame_run.hpp"
#include "analyses/sweep.hpp"
#include "readers/format.hpp"

namespace mdana {

/// How many frames a dump has, and what it takes to pass over one without looking at its atoms.
struct FrameCount {
  std::uint64_t frames = 0;  ///< all of the dump; as many as were met if they are not `counted` nor extrapolated
  std::uint64_t met = 0;     ///< passed over to find out
  bool counted = false;      ///< else taken from how much of the file the first frames are
  std::string source;        ///< "counted", "by the index of frames", "from the size of the first 12"
  double seconds = 0;        ///< of a processor, for one frame
};

/// That this process has used up to now, of all processors: what else the machine does is not in it.
double processor_seconds();

/// Passes over frames for no longer than that (but over one), unless an index tells. Throws InputError.
FrameCount count_quickly(const std::filesystem::path& dump, double most_seconds);

/// A few frames of a dump as they stand in the file, to time analyses on.
class FrameProbe {
 public:
  /// Keeps frames of these numbers (ascending), of each no more than `most_atoms` in blocks that are spread
  /// over it. `columns` are converted. Throws InputError.
  FrameProbe(const std::filesystem::path& dump, const Bodies& bodies, const Masses& masses, const SweepOptions& options,
             const ColumnSet& columns, std::span<const std::uint64_t> numbers, std::uint64_t most_atoms);

  std::size_t frames() const { return frames_.size(); }
  std::uint64_t atoms() const;  ///< that were kept
  double share() const;         ///< of the atoms of these frames

  /// Seconds of all processors for the atoms of a frame, the mean over the frames. Analyses that follow the motion need one
  /// before them. `moved`: with the last digits of all numbers moved. Throws InputError.
  double seconds(std::span<const std::unique_ptr<Analysis>> analyses, bool moved = false) const;

 private:
  struct Frame {
    FrameHeader header;
    std::uint64_t atoms = 0;  ///< of the whole frame
    std::vector<Chunk> chunks;
  };

  void keep(const FrameHeader& header, std::uint64_t most_atoms);
  double once(const FramePlan& plan) const;

  const Bodies& bodies_;
  const Masses& masses_;
  const SweepOptions& options_;
  std::unique_ptr<FrameSource> source_;  ///< whose bytes the chunks are
  std::vector<Frame> frames_;
};

}  // namespace mdana
