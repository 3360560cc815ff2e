// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/signals.hpp"

#include <chrono>
#include <csignal>

#include <fmt/format.h>
#include <unistd.h>

#include "readers/ranks.hpp"

namespace mdana::cli {
namespace {

std::atomic<int> stop{0};
bool progress_shown = false;

void on_signal(int number) { stop = number; }

/// The second signal of a kind ends the program; system calls are not restarted. What the caller
/// ignores (nohup) stays ignored.
void catch_signal(int number) {
  struct sigaction action {};
  if (::sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  ::sigaction(number, &action, nullptr);
}

}  // namespace

const std::atomic<int>& stop_signal() { return stop; }

void catch_signals() {
  catch_signal(SIGINT);
  catch_signal(SIGTERM);
}

std::function<void(const Progress&)> progress_printer() {
  if (!::isatty(STDERR_FILENO) || !is_first_rank()) return {};
  return [last = std::chrono::steady_clock::now()](const Progress& progress) mutable {
    const auto now = std::chrono::steady_clock::now();
    if (now - last < std::chrono::milliseconds(200)) return;
    last = now;
    progress_shown = true;
    const std::string share =
        progress.share ? fmt::format(", {:.0f} % of the input", 100 * *progress.share) : "";
    fmt::print(stderr, "\r{} frames read{} \033[K", progress.frames, share);
    std::fflush(stderr);
  };
}

void end_progress() {
  if (progress_shown) fmt::print(stderr, "\r\033[K");
  progress_shown = false;
}

}  // namespace mdana::cli
