// SPDX-License-Identifier: GPL-3.0-or-later
// The extreme dumps, fits and structures that `mdana stability` computes keep their digits, or are refused in words.
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "readers/input_error.hpp"
#include "reports/extreme.hpp"
#include "reports/extreme/judged.hpp"

namespace mdana {
namespace {

using Verdict = ExtremeCase::Verdict;

void expect_right(const std::vector<ExtremeCase>& cases) {
  std::set<std::string> names;
  for (const ExtremeCase& c : cases) {
    EXPECT_TRUE(c.right()) << c.member << ": " << c.what << ": " << c.quantity << " " << c.computed << " against " << c.exact
                           << ", " << c.digits << " of " << c.needed << " digits " << c.told;
    EXPECT_TRUE(names.insert(c.member + c.what).second) << c.what;
  }
}

TEST(ExtremeCases, DumpsKeepTheirDigits) {
  const std::vector<ExtremeCase> cases = extreme_dumps();
  EXPECT_GE(cases.size(), 50u);
  expect_right(cases);
}

TEST(ExtremeCases, FitsKeepTheirDigits) {
  const std::vector<ExtremeCase> cases = extreme_fits();
  EXPECT_GE(cases.size(), 45u);
  expect_right(cases);
}

TEST(ExtremeCases, StructuresKeepTheirDigits) {
  const std::vector<ExtremeCase> cases = extreme_structures();
  EXPECT_GE(cases.size(), 15u);
  expect_right(cases);
}

TEST(ExtremeCases, NetworksKeepTheirDigits) {
  const std::vector<ExtremeCase> cases = extreme_networks();
  EXPECT_GE(cases.size(), 20u);
  expect_right(cases);
}

Verdict verdict_of(const std::string& words, const std::function<Judged()>& work) {
  return judge("member", "case", words, work).verdict;
}

TEST(ExtremeCases, WrongNumbersAreSeen) {
  const auto of_number = [](double computed, double needed) {
    return verdict_of({}, [=] {
      Judged judged;
      judged.number("right", 1, 1, 10);
      judged.number("doubtful", computed, 2, needed);
      return judged;
    });
  };
  EXPECT_EQ(of_number(2 + 2e-5, 4.9), Verdict::kept);
  EXPECT_EQ(of_number(2 + 2e-5, 5.1), Verdict::lost);
  EXPECT_EQ(of_number(std::nan(""), 1), Verdict::lost);
}

TEST(ExtremeCases, ErrorsThatAreTooSmallAreSeen) {
  const auto of_error = [](std::optional<double> error) {
    return verdict_of({}, [=] {
      Judged judged;
      judged.within_error("number", {10.1, error, {}}, 10);
      return judged;
    });
  };
  EXPECT_EQ(of_error(0.06), Verdict::kept);
  EXPECT_EQ(of_error(0.04), Verdict::lost);
  EXPECT_EQ(of_error({}), Verdict::lost);
}

TEST(ExtremeCases, RefusalsMustNameTheirCause) {
  const auto refuse = [](const std::string& words) {
    return verdict_of(words, []() -> Judged { throw InputError("frame 3: a mass of 0"); });
  };
  EXPECT_EQ(refuse("a mass of 0"), Verdict::refused);
  EXPECT_EQ(refuse("not finite"), Verdict::lost);
  EXPECT_EQ(refuse(""), Verdict::lost);
  const auto accept = [] {
    Judged judged("no such warning");
    judged.must_be_refused("a mass of 0", 1);
    return judged;
  };
  EXPECT_EQ(verdict_of("a mass of 0", accept), Verdict::accepted);
}

}  // namespace
}  // namespace mdana
