// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/block_pipeline.hpp"

#include <exception>
#include <vector>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include "analyses/stage_seconds.hpp"

namespace mdana {
namespace {

bool produce(const BlockPipeline& p, std::size_t slot) {
  const StageClock clock(Stage::cut);
  return p.produce(slot);
}

void work(const BlockPipeline& p, std::size_t slot) {
  const StageClock clock(Stage::work);
  p.work(slot);
}

void collect(const BlockPipeline& p, std::size_t slot) {
  const StageClock clock(Stage::collect);
  p.collect(slot);
}

void run_serially(const BlockPipeline& p) {
  while (produce(p, 0)) {
    work(p, 0);
    collect(p, 0);
  }
}

void run_in_parallel(const BlockPipeline& p) {
  namespace tbb = oneapi::tbb;
  std::vector<std::exception_ptr> failed(p.slots);
  std::size_t produced = 0;
  const auto first = [&](tbb::flow_control& control) {
    const std::size_t slot = produced++ % p.slots;  // free: at most `slots` blocks are under way
    if (!produce(p, slot)) control.stop();
    return slot;
  };
  const auto second = [&](std::size_t slot) {
    try {
      work(p, slot);
    } catch (...) {
      failed[slot] = std::current_exception();
    }
    return slot;
  };
  const auto third = [&](std::size_t slot) {
    if (failed[slot]) std::rethrow_exception(failed[slot]);
    collect(p, slot);
  };
  using tbb::filter_mode;
  tbb::parallel_pipeline(
      p.slots, tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, first) &
                   tbb::make_filter<std::size_t, std::size_t>(filter_mode::parallel, second) &
                   tbb::make_filter<std::size_t, void>(filter_mode::serial_in_order, third));
}

}  // namespace

void run(const BlockPipeline& p) {
  const StageClock clock(Stage::sweeps);
  if (p.threads <= 1) return run_serially(p);
  using oneapi::tbb::global_control;
  const global_control allowed(global_control::max_allowed_parallelism, p.threads);
  oneapi::tbb::task_arena arena(static_cast<int>(p.threads));
  arena.execute([&] { run_in_parallel(p); });
}

}  // namespace mdana
