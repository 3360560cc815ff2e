// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/sweep.hpp"

#include <chrono>
#include <limits>
#include <stdexcept>

#include "analyses/frame_walk.hpp"
#include "analyses/free_memory.hpp"
#include "analyses/rank_sweep.hpp"
#include "analyses/sweep_rows.hpp"
#include "readers/input_error.hpp"
#include "readers/ranks.hpp"

namespace mdana {
namespace {

/// Adds all frames that there are.
void add_frames(const std::string& path, const FramePlan& plan, const SweepOptions& options, FrameWalk& walk,
                SweepRows& rows) {
  if (rank_count() > 1) return RankSweep(path, plan, options, walk, rows).run();
  if (!walk.go_to(0)) return;
  walk.run(std::numeric_limits<std::uint64_t>::max(),
           [&](const FrameHeader& header, FrameOutcome&& outcome, std::optional<double> share) {
             rows.add(header, std::move(outcome), share, rank());
           });
}

SweepResult run(const std::string& path, const FramePlan& plan, const SweepOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  FrameWalk walk(path, plan, options);
  SweepRows rows(plan, options);
  SweepResult& result = rows.result();
  try {
    add_frames(path, plan, options, walk, rows);
  } catch (const InputError& error) {
    if (result.steps.empty() || options.strict) throw;
    result.damage = error.what();
    rows.damaged_behind();
  }
  rows.give_products();
  if (result.steps.empty()) throw InputError(path + ": no frame in the file, or none chosen");
  result.unwrapped = walk.unwraps();
  if (!options.frames && is_first_rank()) {
    if (rank_count() > 1 && result.damage.empty() && !options.choice.end) walk.pass_rest();
    result.inputs = walk.records();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::move(result);
}

}  // namespace

SweepResult sweep(const std::filesystem::path& dump, const Bodies& bodies, const Masses& masses,
                  std::span<const std::unique_ptr<Analysis>> analyses,
                  const SweepOptions& options) {
  if (options.choice.stride == 0)
    throw std::invalid_argument("sweep: the stride must be at least 1");
  FramePlan plan(bodies, masses, analyses, options.selection);
  plan.memory = options.memory;
  plan.frame_memory = options.frame_memory.value_or(free_memory() / 2 / static_cast<std::size_t>(ranks_here()));
  plan.last_digit_seed = options.last_digit_seed;
  plan.dropped_digits = options.dropped_digits;
  plan.stop = options.stop;
  return run(dump.string(), plan, options);
}

}  // namespace mdana
