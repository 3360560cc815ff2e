// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace mdana {

/// What a process of its own does: a crash, or memory that runs out, ends that process alone.
using Work = std::function<void()>;

/// How it ended.
struct WorkDone {
  std::size_t index = 0;
  std::string failure;  ///< empty if it is done
  double seconds = 0;
};

/// Does each work in a process, `jobs` at a time, in their order, and tells of each as it ends. No thread
/// may be running. `stop`, or a signal that a work was stopped by, ends those that are running, and throws Interrupted. If this process is killed, they
/// are, too.
void run_in_processes(const std::vector<Work>& works, std::size_t jobs, const std::atomic<int>* stop,
                      const std::function<void(const WorkDone&)>& done);

}  // namespace mdana
