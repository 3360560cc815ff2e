// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace mdana {

/// Three steps over a stream of blocks, in `slots` places that are used again and again.
struct BlockPipeline {
  std::size_t threads = 1;
  std::size_t slots = 1;                     ///< blocks under way at most
  std::function<bool(std::size_t)> produce;  ///< fills the place; one by one in order; false: no more
  std::function<void(std::size_t)> work;     ///< on any thread, blocks in any order
  std::function<void(std::size_t)> collect;  ///< one by one in order
};

/// Runs the pipeline to its end (oneTBB; a plain loop on one thread). What a step throws is thrown
/// here: from `work`, that of the first block in order that failed, whatever the threads.
void run(const BlockPipeline& pipeline);

}  // namespace mdana
