// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "analyses/value.hpp"
#include "reports/extreme.hpp"

namespace mdana {

/// Collects the numbers of one case; the one with the fewest digits to spare stands for all.
class Judged {
 public:
  explicit Judged(std::string warnings = {}) { result_.told = std::move(warnings); }

  /// A number that must agree to so many digits; NaN does not.
  void number(const std::string& name, double computed, double exact, double needed);

  /// A number that must agree within twice its stated error. One that is not determined (NaN) says so itself,
  /// one without an error must be exact to 12 digits.
  void within_error(const std::string& name, const Value& computed, double exact);

  /// Right only if a warning has these words.
  void must_be_refused(const std::string& words, double computed);

  void condition(double value) { result_.condition = value; }
  const ExtremeCase& result() const { return result_; }

 private:
  ExtremeCase result_;
  bool any_ = false;
};

/// Runs one case. An InputError is a refusal, right if `words` says that there must be one and what it holds.
ExtremeCase judge(std::string member, std::string what, const std::string& words, const std::function<Judged()>& work);

}  // namespace mdana
