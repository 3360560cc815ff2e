// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/extreme/judged.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "readers/input_error.hpp"
#include "readers/known_answer.hpp"

namespace mdana {

using Verdict = ExtremeCase::Verdict;

std::string_view name(Verdict verdict) {
  constexpr std::string_view names[] = {"kept", "LOST", "refused", "ACCEPTED"};
  return names[static_cast<std::size_t>(verdict)];
}

void Judged::number(const std::string& name, double computed, double exact, double needed) {
  const double digits = std::isfinite(computed) ? correct_digits({"", computed, exact, 0}) : 0;
  if (any_ && digits - needed >= result_.digits - result_.needed) return;
  any_ = true;
  result_.quantity = name;
  result_.computed = computed;
  result_.exact = exact;
  result_.digits = digits;
  result_.needed = needed;
  result_.verdict = digits >= needed ? Verdict::kept : Verdict::lost;
}

void Judged::within_error(const std::string& name, const Value& computed, double exact) {
  constexpr double without_error = 12;
  if (std::isnan(computed.value)) return;
  const double scale = exact == 0 ? 1 : std::abs(exact);
  const double needed = computed.error ? std::clamp(-std::log10(2 * *computed.error / scale), 0.0, without_error) : without_error;
  number(name, computed.value, exact, needed);
}

void Judged::must_be_refused(const std::string& words, double computed) {
  const bool refused = !words.empty() && result_.told.find(words) != std::string::npos;
  result_.computed = computed;
  result_.verdict = refused ? Verdict::refused : Verdict::accepted;
}

ExtremeCase judge(std::string member, std::string what, const std::string& words, const std::function<Judged()>& work) {
  const auto start = std::chrono::steady_clock::now();
  ExtremeCase result;
  try {
    result = work().result();
  } catch (const InputError& error) {
    result.told = error.what();
    const bool right = !words.empty() && result.told.find(words) != std::string::npos;
    result.verdict = right ? Verdict::refused : Verdict::lost;
  }
  if (result.verdict == Verdict::kept && result.quantity.empty()) {
    result.told = "not determined";
    result.verdict = words == result.told ? Verdict::refused : Verdict::lost;
  }
  result.member = std::move(member);
  result.what = std::move(what);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace mdana
