// SPDX-License-Identifier: GPL-3.0-or-later
// The extreme collisions that `mdana stability laws` computes keep the digits that they should.
#include <set>

#include <gtest/gtest.h>

#include "fits/collision_law.hpp"
#include "fits/law_catalogue.hpp"

namespace mdana {
namespace {

TEST(LawCatalogue, EveryCaseKeepsItsDigits) {
  const std::vector<LawCase> cases = law_catalogue();
  EXPECT_GE(cases.size(), 100u);
  std::set<std::string_view> laws;
  for (const LawCase& c : cases) {
    laws.insert(c.law);
    EXPECT_GE(c.digits, c.needed) << c.law << ": " << c.what << ": " << c.computed << " against "
                                  << c.exact << (c.unresolved ? ", unresolved" : "");
    EXPECT_LT(c.seconds, 20) << c.law << ": " << c.what;
  }
  EXPECT_GE(laws.size(), 7u);
}

}  // namespace
}  // namespace mdana
