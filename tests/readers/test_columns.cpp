// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "readers/block.hpp"
#include "readers/columns.hpp"

namespace mdana {
namespace {

TEST(ColumnSet, IsSortedAndUnique) {
  ColumnSet set{"z", "x", "vx"};
  set.add(ColumnSet{"x", "id"});
  set.add("z");
  EXPECT_EQ(set.names(), (std::vector<std::string>{"id", "vx", "x", "z"}));
}

TEST(ColumnSet, KnowsItsMembers) {
  const ColumnSet set{"id", "c_pe[1]"};
  EXPECT_TRUE(set.has("c_pe[1]"));
  EXPECT_FALSE(set.has("c_pe"));
  EXPECT_FALSE(set.has(""));
  EXPECT_TRUE(ColumnSet().empty());
}

TEST(ColumnSet, WholeNumbersAreKnownByName) {
  for (const char* name : {"id", "type", "mol", "ix", "iy", "iz", "proc"})
    EXPECT_TRUE(kind_of_column(name) == ColumnKind::integer) << name;
  for (const char* name : {"x", "ids", "mass", "", "q"}) EXPECT_EQ(kind_of_column(name), ColumnKind::real);
}

TEST(AtomBlock, ColumnsAreKeptForReuse) {
  AtomBlock block;
  block.reset(0, 3);
  block.make_real("x")[2] = 7;
  block.make_integer("id")[0] = std::int64_t{1} << 60;
  EXPECT_EQ(block.real("x")[2], 7);
  EXPECT_EQ(block.integer("id")[0], std::int64_t{1} << 60);
  EXPECT_EQ(block.bytes(), 3 * 16u);
  block.reset(5, 2);
  EXPECT_EQ(block.number(), 5u);
  EXPECT_EQ(block.real("x").size(), 2u);
  EXPECT_EQ(block.integer("id").size(), 2u);
}

TEST(AtomBlock, UndeclaredColumnIsAProgrammingError) {
  AtomBlock block;
  block.reset(0, 1);
  block.make_real("x");
  EXPECT_THROW(block.real("y"), std::logic_error);
  EXPECT_THROW(block.integer("x"), std::logic_error);
}

}  // namespace
}  // namespace mdana
