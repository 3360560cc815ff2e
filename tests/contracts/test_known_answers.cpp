// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "analyses/analysis.hpp"
#include "fits/force_law.hpp"
#include "readers/format.hpp"
#include "readers/known_answer.hpp"

namespace mdana {
namespace {

TEST(KnownAnswers, AllMembersGiveTheirDigits) {
  for (const KnownMember& member : known_members()) {
    const auto answers = member.answers();
    EXPECT_FALSE(answers.empty()) << member.name;
    for (const KnownAnswer& answer : answers)
      EXPECT_GE(correct_digits(answer), answer.digits)
          << member.name << ", " << answer.what << ": " << answer.computed << " (exact "
          << answer.exact << ")";
  }
}

// A demand of no digits would be no proof.
TEST(KnownAnswers, AskForDigits) {
  for (const KnownMember& member : known_members())
    for (const KnownAnswer& answer : member.answers())
      EXPECT_GE(answer.digits, 5) << member.name << ", " << answer.what;
}

TEST(KnownAnswers, EveryMemberOfTheListsHasOne) {
  std::set<std::string_view> known;
  for (const KnownMember& member : known_members()) known.insert(member.name);
  for (const Format* format : formats()) EXPECT_TRUE(known.contains(format->name)) << format->name;
  for (const AnalysisMember* member : analysis_members())
    EXPECT_TRUE(known.contains(member->name)) << member->name;
  for (const ForceLaw* law : force_laws()) EXPECT_TRUE(known.contains(law->name)) << law->name;
}

TEST(CorrectDigits, CountAgreeingDecimals) {
  EXPECT_EQ(correct_digits({"", 2, 2, 0}), 16);
  EXPECT_EQ(correct_digits({"", 0, 0, 0}), 16);
  EXPECT_NEAR(correct_digits({"", 1001, 1000, 0}), 3, 1e-9);
  EXPECT_NEAR(correct_digits({"", -1e-20 * 1.001, -1e-20, 0}), 3, 1e-9);
  EXPECT_NEAR(correct_digits({"", 1e-6, 0, 0}), 6, 1e-9);
  EXPECT_EQ(correct_digits({"", 30, 1, 0}), 0);
  EXPECT_EQ(correct_digits({"", std::numeric_limits<double>::quiet_NaN(), 1, 0}), 0);
  EXPECT_EQ(correct_digits({"", std::numeric_limits<double>::infinity(), 1, 0}), 0);
}

}  // namespace
}  // namespace mdana
