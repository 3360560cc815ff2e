// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots of slices: what becomes squares, and how large pictures are.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "reports/snapshots.hpp"

namespace mdana {
namespace {

/// A square lattice of spacing 1 in two discs of that radius that touch.
Slice two_discs(int radius) {
  Slice slice{1, {}};
  for (int i = -radius; i <= radius; ++i)
    for (int k = -radius; k <= radius; ++k)
      for (const std::size_t body : {0, 1})
        if (i * i + k * k <= radius * radius) slice.at[body].emplace_back(i, k + (body ? radius : -radius) + (body ? 0.5 : -0.5));
  return slice;
}

SnapshotFigure figure_of(int radius) {
  SnapshotFigure figure{"snapshots", "a < b", "atom", Units::lj, {}};
  for (const char* label : {"start", "maximum compression", "end"}) {
    figure.snapshots.push_back(snapshot_of(two_discs(radius)));
    figure.snapshots.back().label = label;
  }
  return figure;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST(Snapshots, SquaresBelongToTheBodyWithMostAtoms) {
  Snapshot snapshot;
  snapshot.at = {{{{0.1, 0.1}, {0.2, 0.3}, {-0.5, 0.5}}, {{0.4, 0.4}, {1.5, 0.2}, {2.5, 0.2}}}};
  const Snapshot squares = with_squares(snapshot, 1);
  EXPECT_TRUE(squares.squares);
  EXPECT_EQ(squares.at[0], (std::vector<Eigen::Vector2d>{{-0.5, 0.5}, {0.5, 0.5}}));
  EXPECT_EQ(squares.at[1], (std::vector<Eigen::Vector2d>{{1.5, 0.5}, {2.5, 0.5}}));
  const auto rows = strips(squares.at[1], 1);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].from, 1);
  EXPECT_EQ(rows[0].to, 3);
}

// The squares cover the area of the discs: pi r^2 each, but for the edge.
TEST(Snapshots, ManyAtomsBecomeSquares) {
  std::vector<Snapshot> some{snapshot_of(two_discs(20))}, many = some;
  limit(some, some[0].count());
  EXPECT_FALSE(some[0].squares);
  limit(many, 400);
  EXPECT_TRUE(many[0].squares);
  EXPECT_LE(many[0].count(), 400u);
  EXPECT_GE(many[0].size, 2);
  EXPECT_EQ(many[0].atoms, some[0].count());
  const double area = static_cast<double>(many[0].count()) * many[0].size * many[0].size;
  EXPECT_NEAR(area, 2 * M_PI * 400, 4 * M_PI * 20 * many[0].size);
}

TEST(Snapshots, APictureHasAllAtomsOrIsAsSmallAsAskedFor) {
  const SnapshotFigure figure = figure_of(15);
  const std::string whole = snapshot_picture(figure);
  std::size_t atoms = 0;
  for (const Snapshot& s : figure.snapshots) atoms += s.count();
  EXPECT_EQ(count(whole, "h0"), atoms);
  EXPECT_NE(whole.find("a &lt; b"), std::string::npos);
  EXPECT_LT(whole.size(), 10 * atoms + 3000);
  EXPECT_EQ(snapshot_picture(within(figure, whole.size())), whole);
  const SnapshotFigure small = within(figure, 4000);
  EXPECT_LE(snapshot_picture(small).size(), 4000u);
  for (const Snapshot& s : small.snapshots) {
    EXPECT_TRUE(s.squares);
    EXPECT_FALSE(s.at[0].empty() || s.at[1].empty());
  }
  EXPECT_NE(caption(small).find("Squares of"), std::string::npos);
  EXPECT_EQ(caption(figure).find("Squares of"), std::string::npos);
}

TEST(Snapshots, NothingToShow) {
  EXPECT_EQ(snapshot_picture({}), "");
  EXPECT_EQ(caption({}), "");
  EXPECT_EQ(snapshot_table({}).rows(), 0u);
}

}  // namespace
}  // namespace mdana
