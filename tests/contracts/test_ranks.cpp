// SPDX-License-Identifier: GPL-3.0-or-later
// What ranks tell each other of a part of a frame is all that there is to know of it.
#include <cstring>
#include <numeric>

#include <gtest/gtest.h>

#include "analyses/box_centres.hpp"
#include "analyses/far_side.hpp"
#include "analyses/merge_tree.hpp"
#include "analyses/motion.hpp"
#include "analyses/parcel.hpp"
#include "tests/contracts/catalogue.hpp"

namespace mdana {
namespace {

using test::made_up_scene;
using test::TemporaryFolder;

std::unique_ptr<Partial> same(std::unique_ptr<Partial> partial, const Analysis&, const FrameContext&) { return partial; }

std::unique_ptr<Partial> passed(std::unique_ptr<Partial> partial, const Analysis& analysis, const FrameContext& frame) {
  Parcel there;
  partial->pass(there);
  Parcel here(there.take());
  auto other = analysis.begin(frame);
  other->pass(here);
  EXPECT_THROW(other->pass(here), std::logic_error);  // nothing is left
  return other;
}

/// A frame in blocks of some atoms each, whose last one is of one body.
class FrameInBlocks : public testing::Test {
 protected:
  FrameInBlocks() {
    const auto dump = folder_.write("dump", test::dump_text(test::made_up_collision(2, 150)));
    first_ = first_header(dump);
    analyses_ = test::whole_catalogue({made_up_scene(), first_});
    analyses_.push_back(make_far_side());
    analyses_.push_back(make_box_centres(2));
    ColumnSet wanted{"id", "type", "mass"};
    for (const auto& analysis : analyses_) wanted.add(analysis->needs().columns);
    header_ = for_frame(dump, 1, wanted, [&](const AtomBlock& block) { whole_ = block; });
    const Bodies bodies = find_bodies(dump, first_, "type");
    for (const auto& [from, to] : {std::pair{0u, 90u}, {90u, 91u}, {91u, 200u}, {200u, 230u}, {230u, 300u}}) {
      std::vector<std::uint32_t> atoms(to - from);
      std::iota(atoms.begin(), atoms.end(), from);
      blocks_.emplace_back(whole_).keep(atoms);
      bodies.label(blocks_.back(), body_.emplace_back());
      Masses::from_column("the dump").fill(blocks_.back(), mass_.emplace_back());
    }
  }

  template <class Step>
  std::vector<double> row(const Analysis& analysis, const FrameContext& frame, const Step& step) const {
    MergeTree tree;
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      auto partial = analysis.begin(frame);
      partial->add({blocks_[k], body_[k], mass_[k]});
      tree.push(step(std::move(partial), analysis, frame));
    }
    std::vector<double> row(analysis.columns().size());
    tree.finish()->close(row);
    return row;
  }

  TemporaryFolder folder_;
  FrameHeader first_, header_;
  std::vector<std::unique_ptr<Analysis>> analyses_;
  AtomBlock whole_;
  std::vector<AtomBlock> blocks_;
  std::vector<std::vector<BodyIndex>> body_;
  std::vector<std::vector<double>> mass_;
};

TEST_F(FrameInBlocks, PartialsKeepAllTheirBitsOnTheWayToAnotherRank) {
  Table table(analyses_.front()->columns());
  table.add_row(row(*analyses_.front(), {header_, {}}, same));
  const auto motion = body_motion(table, 0);
  std::size_t seen = 0;
  for (const auto& analysis : analyses_) {
    if (analysis->needs().whole_frame) continue;
    const auto here = row(*analysis, {header_, motion}, same), there = row(*analysis, {header_, motion}, passed);
    EXPECT_EQ(std::memcmp(here.data(), there.data(), here.size() * sizeof(double)), 0) << analysis->columns().front().name;
    ++seen;
  }
  EXPECT_GT(seen, 3u);
}

TEST(Parcel, GivesBackWhatItWasGiven) {
  FrameHeader header{7, -3, 0.1, Units::metal, 5, {}, {"id", "x"}, "dump:9"};
  header.box.stated = Box::Bounds{{1, 2, 3}, {4, 5, 6}};
  header.box.periodic[1] = true;
  Parcel parcel;
  parcel(header);
  FrameHeader other;
  Parcel(parcel.take())(other);
  EXPECT_EQ(other.index, 7u);
  EXPECT_EQ(other.step, -3);
  EXPECT_EQ(other.time, 0.1);
  EXPECT_EQ(other.units, Units::metal);
  EXPECT_EQ(other.columns, header.columns);
  EXPECT_EQ(other.place, "dump:9");
  EXPECT_EQ(other.box.stated->hi, header.box.stated->hi);
  EXPECT_EQ(other.box.periodic, header.box.periodic);
}

TEST(Parcel, RefusesALengthBeyondItsBytes) {
  Parcel parcel;
  std::uint64_t length = std::uint64_t{1} << 60;
  parcel(length);
  std::vector<double> values;
  EXPECT_THROW(Parcel(parcel.take())(values), std::logic_error);
}

}  // namespace
}  // namespace mdana
