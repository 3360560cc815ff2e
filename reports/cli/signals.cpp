// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/signals.hpp"

#include <chrono>
#include <csignal>

#include <fmt/format.h>
#include <unistd.h>

namespace mdana::cli {
namespace {

std::atomic<int> stop{0};
bool progress_shown = false;

void on_signal(int number) {
  stop = number;
  std::signal(number, SIG_DFL);
}

}  // namespace

const std::atomic<int>& stop_signal() { return stop; }

void catch_signals() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

std::function<void(std::uint64_t)> progress_printer() {
  if (!::isatty(STDERR_FILENO)) return {};
  return [last = std::chrono::steady_clock::now()](std::uint64_t frames) mutable {
    const auto now = std::chrono::steady_clock::now();
    if (now - last < std::chrono::milliseconds(200)) return;
    last = now;
    progress_shown = true;
    fmt::print(stderr, "\r{} frames read", frames);
    std::fflush(stderr);
  };
}

void end_progress() {
  if (progress_shown) fmt::print(stderr, "\r\033[K");
  progress_shown = false;
}

}  // namespace mdana::cli
