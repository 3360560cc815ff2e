// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/plan.hpp"

namespace mdana {

/// What a part of a plan takes, or what parts share.
struct PartCost {
  std::string what;
  double passes = 1;   ///< over the frames
  double seconds = 0;  ///< of processors, in all
  double bytes = 0;    ///< of memory
  std::string shared;  ///< what it is for, if it is none of the plan's parts
};

/// What a plan takes, how that was found, and how far it may be off.
struct PlanCost {
  std::uint64_t frames = 0;  ///< that are used
  std::string frames_source;
  std::uint64_t atoms = 0;   ///< of the first frame
  std::uint64_t input_bytes = 0;  ///< on disk
  std::uint64_t tokens = 0;  ///< numbers converted in a pass
  std::vector<PartCost> parts;
  double processor_seconds = 0;
  double seconds = 0;        ///< from start to end with these threads, on a machine that does nothing else
  double bytes = 0;          ///< greatest memory
  double factor = 1;         ///< the times may be that much longer or shorter
  std::string source;        ///< "5 of 49 frames, spread over the run, were analysed in 0.02 s"
};

/// Analyses a few frames of the run and takes all others for alike. Reads for about half a second. Throws
/// InputError.
PlanCost estimate_cost(const Run& run, const Plan& plan, const PlanWishes& wishes, const SweepOptions& sweeping);

}  // namespace mdana
