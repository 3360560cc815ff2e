// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/signals.hpp"

#include <chrono>
#include <csignal>
#include <string_view>

#include <fmt/format.h>
#include <unistd.h>

#include "readers/ranks.hpp"

namespace mdana::cli {
namespace {

std::atomic<int> stop{0};
bool progress_shown = false;

/// What does not look at the signal, as a fit, is ended after that: outputs are written whole or not at all.
constexpr unsigned grace = 10;  ///< [s], less than the 30 s that batch systems wait between SIGTERM and SIGKILL

void on_signal(int number) {
  stop = number;
  ::alarm(grace);
}

void on_alarm(int) {
  constexpr std::string_view told = "mdana: stopped\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, told.data(), told.size());
  ::_exit(code_after(stop));
}

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

ExitCode code_after(int signal) { return signal == SIGINT ? interrupted : resumable; }

void catch_signals() {
  for (const int number : {SIGINT, SIGTERM, SIGUSR1}) catch_signal(number);
  struct sigaction action {};
  action.sa_handler = on_alarm;
  ::sigaction(SIGALRM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond its limit (ulimit -f) is an error that writing tells
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
