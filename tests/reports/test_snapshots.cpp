// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots of slices: what becomes rows, and how large pictures are.
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
        if (i * i + k * k <= radius * radius) slice.at[body].emplace_back(i, k + (body ? radius : -radius) + (body ? 0.5 : -0.5), 0.2 * (i % 3 - 1));
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

TEST(Snapshots, AStripEndsWhereThereIsRoom) {
  Snapshot snapshot;
  snapshot.diameter = 1;
  snapshot.at = {{{{0, 0.1, 0}, {1.5, 0.9, 0}, {6, 0.5, 0}, {0, -0.5, 0}}, {{2, 1.5, 0}}}};
  const Snapshot rows = with_rows(snapshot, 1);
  EXPECT_EQ(rows.strips[0], (std::vector<Strip>{{-0.5, 0.5, -0.5}, {-0.5, 2, 0.5}, {5.5, 6.5, 0.5}}));
  EXPECT_EQ(rows.strips[1], (std::vector<Strip>{{1.5, 2.5, 1.5}}));
  EXPECT_TRUE(rows.at[0].empty());
  EXPECT_EQ(with_rows(rows, 2).strips[0], (std::vector<Strip>{{-0.5, 0.5, -1}, {-0.5, 2, 1}, {5.5, 6.5, 1}}));
}

// The strips cover the discs, pi r^2 each, without gaps: one a row and body.
TEST(Snapshots, ManyAtomsBecomeRows) {
  std::vector<Snapshot> some{snapshot_of(two_discs(20))}, many = some;
  const std::size_t atoms = some[0].at[0].size() + some[0].at[1].size();
  limit(some, atoms);
  EXPECT_EQ(some[0].row, 0);
  limit(many, 40);
  EXPECT_GT(many[0].row, 1);
  EXPECT_EQ(many[0].atoms, atoms);
  double area = 0;
  for (const std::size_t body : {0, 1}) {
    EXPECT_LE(many[0].strips[body].size(), 20u);
    for (const Strip& s : many[0].strips[body]) area += many[0].row * (s.to - s.from);
    for (std::size_t k = 1; k < many[0].strips[body].size(); ++k)
      EXPECT_GT(many[0].strips[body][k].height, many[0].strips[body][k - 1].height);
  }
  EXPECT_NEAR(area, 2 * M_PI * 400, 4 * M_PI * 20 * many[0].row);
}

TEST(Snapshots, APictureHasAllAtomsOrIsAsSmallAsAskedFor) {
  const SnapshotFigure figure = figure_of(15);
  const std::string whole = snapshot_picture(figure);
  std::size_t atoms = 0;
  for (const Snapshot& s : figure.snapshots) atoms += s.atoms;
  EXPECT_EQ(count(whole, "h0"), atoms);
  EXPECT_NE(whole.find("a &lt; b"), std::string::npos);
  EXPECT_LT(whole.size(), 10 * atoms + 3000);
  EXPECT_EQ(snapshot_picture(within(figure, whole.size())), whole);
  const SnapshotFigure small = within(figure, 4000);
  EXPECT_LE(snapshot_picture(small).size(), 4000u);
  for (const Snapshot& s : small.snapshots) {
    EXPECT_GT(s.row, 0);
    EXPECT_FALSE(s.strips[0].empty() || s.strips[1].empty());
  }
  EXPECT_NE(caption(small).find("Rows of"), std::string::npos);
  EXPECT_EQ(caption(figure).find("Rows of"), std::string::npos);
}

TEST(Snapshots, NothingToShow) {
  EXPECT_EQ(snapshot_picture({}), "");
  EXPECT_EQ(caption({}), "");
  EXPECT_EQ(snapshot_table({}).rows(), 0u);
}

}  // namespace
}  // namespace mdana
