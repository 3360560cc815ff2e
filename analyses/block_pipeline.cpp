// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/block_pipeline.hpp"

#include <exception>
#include <vector>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

namespace mdana {
namespace {

void run_serially(const BlockPipeline& p) {
  while (p.produce(0)) {
    p.work(0);
    p.collect(0);
  }
}

void run_in_parallel(const BlockPipeline& p) {
  namespace tbb = oneapi::tbb;
  std::vector<std::exception_ptr> failed(p.slots);
  std::size_t produced = 0;
  const auto produce = [&](tbb::flow_control& control) {
    const std::size_t slot = produced++ % p.slots;  // free: at most `slots` blocks are under way
    if (!p.produce(slot)) control.stop();
    return slot;
  };
  const auto work = [&](std::size_t slot) {
    try {
      p.work(slot);
    } catch (...) {
      failed[slot] = std::current_exception();
    }
    return slot;
  };
  const auto collect = [&](std::size_t slot) {
    if (failed[slot]) std::rethrow_exception(failed[slot]);
    p.collect(slot);
  };
  using tbb::filter_mode;
  tbb::parallel_pipeline(
      p.slots, tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, produce) &
                   tbb::make_filter<std::size_t, std::size_t>(filter_mode::parallel, work) &
                   tbb::make_filter<std::size_t, void>(filter_mode::serial_in_order, collect));
}

}  // namespace

void run(const BlockPipeline& p) {
  if (p.threads <= 1) return run_serially(p);
  using oneapi::tbb::global_control;
  const global_control allowed(global_control::max_allowed_parallelism, p.threads);
  oneapi::tbb::task_arena arena(static_cast<int>(p.threads));
  arena.execute([&] { run_in_parallel(p); });
}

}  // namespace mdana
