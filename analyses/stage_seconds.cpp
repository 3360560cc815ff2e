// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/stage_seconds.hpp"

#include <array>
#include <atomic>
#include <chrono>

namespace mdana {
namespace {

std::array<std::atomic<long long>, 5> nanoseconds{};
thread_local bool within_stage = false;

std::atomic<long long>& of(Stage stage) { return nanoseconds[static_cast<std::size_t>(stage)]; }

long long now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

StageSeconds stage_seconds() {
  const auto seconds = [](Stage stage) { return 1e-9 * static_cast<double>(of(stage)); };
  return {seconds(Stage::cut), seconds(Stage::work), seconds(Stage::collect), seconds(Stage::whole), seconds(Stage::sweeps)};
}

// A pipeline's own clock does not hide those of its steps.
StageClock::StageClock(Stage stage) : stage_(stage), counts_(!within_stage), start_(now()) {
  if (stage != Stage::sweeps) within_stage = true;
}

StageClock::~StageClock() {
  if (!counts_) return;
  of(stage_) += now() - start_;
  within_stage = false;
}

}  // namespace mdana
