// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/error_option.hpp"

#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana::cli {

namespace po = boost::program_options;

void add_error_option(Options& options, const char* knobs) {
  const std::string text = fmt::format("wanted error of the numbers, as a part of them: chooses {} as mdana accuracy "
                                       "recommends (exit code 4 if it cannot be met)", knobs);
  options.add_options()("error", po::value<double>()->value_name("E"), text.c_str());
}

std::optional<double> wanted_error(const Values& values) { return positive_option(values, "error"); }

std::optional<Recommendation> choose_stride(const Values& values, const AccuracySubject& subject, SweepOptions& sweeping) {
  const std::optional<double> wanted = wanted_error(values);
  if (!wanted) return std::nullopt;
  if (sweeping.choice.stride > 1) throw UsageError("--error chooses the stride: leave --stride and K of --frames out");
  const Knob& knob = subject.knob("stride");
  const Recommendation chosen = choose(subject, knob, *wanted);
  sweeping.choice.stride *= static_cast<std::uint64_t>(knob.values[chosen.choice.of("stride")].number);
  return chosen;
}

std::optional<Recommendation> choose_starts(const Values& values, const AccuracySubject& subject, ContactFitSettings& settings) try {
  const std::optional<double> wanted = wanted_error(values);
  if (!wanted) return std::nullopt;
  if (!values["starts"].defaulted()) throw UsageError("--error chooses the starts: leave --starts out");
  const Knob& knob = subject.knob("starts");
  const Recommendation chosen = choose(subject, knob, *wanted);
  settings.starts = static_cast<int>(std::lround(1 / knob.values[chosen.choice.of("starts")].number));
  return chosen;
} catch (const InputError&) {
  return std::nullopt;
}

void tell_choice(Document& document, const std::optional<Recommendation>& chosen) {
  if (chosen) add_choice(document, *chosen);
}

int choice_code(const std::optional<Recommendation>& chosen, int code) {
  return code == done && chosen && !chosen->met() ? not_converged : code;
}

}  // namespace mdana::cli
