// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mdana {

/// Where the time of all sweeps of this process went so far [s of wall time in each step], as getrusage tells of the
/// whole. The steps of one sweep overlap on several threads.
struct StageSeconds {
  double cut = 0;      ///< blocks read or found in the file, one after the other
  double work = 0;     ///< numbers converted, analysed: blocks on any thread, all threads together
  double collect = 0;  ///< partials merged and closed, one after the other
  double whole = 0;    ///< analyses of whole frames, each on all threads (of small frames: part of the work)
  double sweeps = 0;   ///< from the begin of each stream of blocks to its end
};
StageSeconds stage_seconds();

enum class Stage { cut, work, collect, whole, sweeps };

/// Counts its own life for a stage, but not within another one of this thread: small frames are a pipeline within the
/// work of a larger one.
class StageClock {
 public:
  explicit StageClock(Stage stage);
  ~StageClock();
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

 private:
  Stage stage_;
  bool counts_;
  long long start_;
};

}  // namespace mdana
