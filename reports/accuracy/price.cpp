// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/accuracy/price.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <limits>
#include <string>

namespace mdana {

bool reset_peak_memory() {
  std::ofstream control("/proc/self/clear_refs");
  control << "5\n" << std::flush;  // proc(5): resets VmHWM
  return control.good();
}

double peak_memory() {
  std::ifstream told("/proc/self/status");
  for (std::string line; std::getline(told, line);)
    if (line.starts_with("VmHWM:")) return 1024 * std::stod(line.substr(6));
  return std::numeric_limits<double>::quiet_NaN();
}

Cost price_of(std::size_t repetitions, const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  const bool known = reset_peak_memory();
  std::vector<double> seconds;
  for (std::size_t r = 0; r < repetitions; ++r) {
    const auto start = Clock::now();
    work();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
  }
  std::ranges::sort(seconds);
  return {seconds[seconds.size() / 2], seconds.back() - seconds.front(),
          known ? peak_memory() : std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace mdana
