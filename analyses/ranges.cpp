// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/ranges.hpp"

#include <algorithm>
#include <exception>
#include <vector>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace mdana {

void for_ranges(std::size_t count, std::size_t size, std::size_t threads,
                const std::function<void(std::size_t first, std::size_t end)>& use) {
  const std::size_t ranges = (count + size - 1) / size;
  std::vector<std::exception_ptr> failed(ranges);
  const auto one = [&](std::size_t k) {
    try {
      use(k * size, std::min(count, (k + 1) * size));
    } catch (...) {
      failed[k] = std::current_exception();
    }
  };
  if (threads <= 1) {
    for (std::size_t k = 0; k < ranges; ++k) one(k);
  } else {
    using oneapi::tbb::global_control;
    const global_control allowed(global_control::max_allowed_parallelism, threads);
    oneapi::tbb::task_arena arena(static_cast<int>(threads));
    arena.execute([&] { oneapi::tbb::parallel_for(std::size_t{0}, ranges, one); });
  }
  for (const auto& error : failed)
    if (error) std::rethrow_exception(error);
}

}  // namespace mdana
