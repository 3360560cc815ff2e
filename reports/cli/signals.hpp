// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>

#include "analyses/sweep.hpp"
#include "reports/cli/command.hpp"

namespace mdana::cli {

/// Set to the signal number by SIGINT, SIGTERM and SIGUSR1 after `catch_signals`; the second one of a kind
/// ends the program at once, and what does not look at it for ten seconds is ended, too.
const std::atomic<int>& stop_signal();
void catch_signals();

/// What the program ends with after a signal.
ExitCode code_after(int signal);

/// Prints frames read and the share of the input on a terminal a few times a second; nothing if the standard error is none.
std::function<void(const Progress&)> progress_printer();

/// Clears the progress line.
void end_progress();

}  // namespace mdana::cli
