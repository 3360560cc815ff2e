// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "analyses/table.hpp"

namespace mdana {
namespace {

TEST(Table, HoldsRowsUnderNames) {
  Table table({{"step", dimension::none}, {"F", dimension::force}});
  table.add_row(std::vector<double>{1, 10});
  table.add_row(std::vector<double>{2, 20});
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.column("F")[1], 20);
  EXPECT_EQ(table.column(0)[0], 1);
  EXPECT_TRUE(table.has("step"));
  EXPECT_FALSE(table.has("f"));
}

TEST(Table, TakesColumns) {
  Table table;
  table.add_column({"a", dimension::none}, {1, 2, 3});
  table.add_column({"b", dimension::length}, {4, 5, 6});
  EXPECT_EQ(table.rows(), 3u);
  EXPECT_EQ(table.column("b")[2], 6);
  EXPECT_EQ(table.columns()[1].dimension, dimension::length);
}

TEST(Table, RefusesWrongLengthsAndNames) {
  Table table({{"a", dimension::none}});
  EXPECT_THROW(table.add_row(std::vector<double>{1, 2}), std::logic_error);
  EXPECT_THROW(table.add_column({"b", dimension::none}, {1}), std::logic_error);
  EXPECT_THROW(table.column("c"), std::out_of_range);
}

}  // namespace
}  // namespace mdana
