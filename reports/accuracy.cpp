// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/accuracy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr std::array<std::uint64_t, 4> strides{1, 2, 4, 8};
constexpr int repetitions = 3;

std::string stride_text(std::uint64_t stride) {
  return stride == 1 ? "all frames" : fmt::format("1 of {} frames", stride);
}

double relative_error(double value, double reference) {
  return reference == 0 ? std::abs(value) : std::abs(value / reference - 1);
}

struct Timed {
  AnalysedRun result;
  double seconds;
};

Timed timed_run(const Run& run, const RunWishes& wishes, SweepOptions options, std::uint64_t stride) {
  options.choice.stride *= stride;
  std::array<double, repetitions> seconds;
  Timed timed;
  for (double& s : seconds) {
    timed.result = analyse_run(run, wishes, options);
    s = timed.result.seconds;
  }
  std::sort(seconds.begin(), seconds.end());
  timed.seconds = seconds[repetitions / 2];
  return timed;
}

/// The other fit method on the same points.
void add_methods(std::vector<AccuracyRow>& rows, const AnalysedRun& full, const Timed& timed,
                 const std::string& setting) {
  HertzSettings settings;
  settings.method = HertzMethod::linear;
  const HertzFit fit = fit_hertz(hertz_data(timed.result.curve, timed.result.radii), settings);
  const double modulus = full.hertz->modulus.value, radius = full.hertz->radius.value;
  rows.push_back({setting + ", method linear", "E_star", fit.modulus.value,
                  relative_error(fit.modulus.value, modulus), timed.seconds});
  rows.push_back({setting + ", method linear", "R", fit.radius.value,
                  relative_error(fit.radius.value, radius), timed.seconds});
}

}  // namespace

std::pair<double, double> accuracy_passes() {
  double share = 0;
  for (const std::uint64_t stride : strides) share += 1 / static_cast<double>(stride);
  return {static_cast<double>(repetitions * strides.size()), repetitions * share};
}

std::vector<AccuracyRow> accuracy_rows(const Run& run, const AnalysedRun& full,
                                       const SweepOptions& options) {
  std::vector<AccuracyRow> rows;
  const std::vector<PublishedValue> reference = full.numbers();
  const RunWishes wishes = same_numbers(full);
  for (const std::uint64_t stride : strides) {
    const std::string setting = stride_text(stride);
    try {
      const Timed timed = timed_run(run, wishes, options, stride);
      for (const PublishedValue& number : timed.result.numbers())
        if (const auto known = std::ranges::find(reference, number.name, &PublishedValue::name); known != reference.end())
          rows.push_back({setting, number.name, number.value.value,
                          relative_error(number.value.value, known->value.value), timed.seconds});
      if (full.hertz) add_methods(rows, full, timed, setting);
    } catch (const InputError&) {
      break;  // too few frames are left at this stride and at larger ones
    }
  }
  return rows;
}

}  // namespace mdana
