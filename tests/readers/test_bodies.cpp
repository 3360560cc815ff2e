// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "readers/bodies.hpp"
#include "readers/trajectory.hpp"
#include "tests/readers/temporary_folder.hpp"
#include "tests/readers/throws_with.hpp"

namespace mdana {
namespace {

constexpr auto least_id = std::numeric_limits<std::int64_t>::min();
constexpr auto greatest_id = std::numeric_limits<std::int64_t>::max();

std::string dump(const std::string& columns, const std::vector<std::string>& lines) {
  std::string text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + std::to_string(lines.size()) +
                     "\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS " + columns + "\n";
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

class BodiesRule : public ::testing::Test {
 protected:
  Bodies find(const std::string& text, const std::string& rule) {
    const auto path = folder_.write("dump", text);
    return find_bodies(path, first_header(path), rule);
  }
  std::vector<int> labels(const Bodies& bodies, const std::string& column,
                          const std::vector<std::int64_t>& values) {
    AtomBlock block;
    block.reset(0, values.size());
    std::copy(values.begin(), values.end(), block.make_integer(column).begin());
    std::vector<BodyIndex> body;
    bodies.label(block, body);
    return {body.begin(), body.end()};
  }
  test::TemporaryFolder folder_;
};

using Labels = std::vector<int>;

TEST_F(BodiesRule, TypeMakesEachTypeABody) {
  const Bodies bodies = find(dump("id type", {"1 5", "2 2", "3 5"}), "type");
  EXPECT_EQ(bodies.count(), 2u);
  EXPECT_EQ(labels(bodies, "type", {5, 2, 5, 3, 2}), (Labels{2, 1, 2, 0, 1}));
  EXPECT_EQ(bodies.rule(), "type 2, 5");
  EXPECT_EQ(bodies.columns().names(), (std::vector<std::string>{"type"}));
}

TEST_F(BodiesRule, MolMakesEachMoleculeABody) {
  const Bodies bodies = find(dump("mol id", {"7000000000 1", "-1 2"}), "mol");
  EXPECT_EQ(labels(bodies, "mol", {7'000'000'000, -1, 0}), (Labels{2, 1, 0}));
}

TEST_F(BodiesRule, IdRangeAndAllOthers) {
  const Bodies bodies = find(dump("id type", {"1 1"}), "id:10-5000000000000");
  EXPECT_EQ(bodies.count(), 2u);
  EXPECT_EQ(
      labels(bodies, "id", {9, 10, 5'000'000'000'000, 5'000'000'000'001, least_id, greatest_id}),
      (Labels{2, 1, 1, 2, 2, 2}));
}

TEST_F(BodiesRule, IdRangeUpToTheLimits) {
  const Bodies bodies = find(dump("id", {"1"}), "id:-5-9223372036854775807");
  EXPECT_EQ(labels(bodies, "id", {-6, -5, greatest_id, least_id}), (Labels{2, 1, 1, 2}));
}

TEST_F(BodiesRule, DefaultIsTypeIfThereAreTwo) {
  EXPECT_EQ(find(dump("id type mol", {"1 1 4", "2 2 4"}), "").rule(), "type 1, 2");
}

TEST_F(BodiesRule, DefaultIsMolIfTypesAreNotTwo) {
  EXPECT_EQ(find(dump("id type mol", {"1 1 4", "2 1 9"}), "").rule(), "mol 4, 9");
  EXPECT_EQ(find(dump("id type mol", {"1 1 4", "2 2 9", "3 3 9"}), "").rule(), "mol 4, 9");
}

TEST_F(BodiesRule, DefaultIsClustersOtherwise) {
  const Bodies bodies =
      find(dump("id type x y z", {"1 1 0 0 0", "2 1 1 0 0", "3 1 9 0 0", "8 1 10 0 0"}), "");
  EXPECT_TRUE(bodies.rule().starts_with("clusters")) << bodies.rule();
  EXPECT_EQ(labels(bodies, "id", {1, 2, 3, 8, 4}), (Labels{1, 1, 2, 2, 0}));
}

TEST_F(BodiesRule, MissingColumnsAreNamed) {
  const std::string text = dump("type x y z", {"1 0 0 0", "1 1 1 1"});
  EXPECT_INPUT_ERROR(find(text, "mol"), "dump:9", "no column 'mol'");
  EXPECT_INPUT_ERROR(find(text, "id:1-2"), "no column 'id'");
  EXPECT_INPUT_ERROR(find(text, "clusters"), "no column 'id'");
  EXPECT_INPUT_ERROR(find(text, ""), "no column 'id'");
}

TEST_F(BodiesRule, WrongRulesAreQuoted) {
  const std::string text = dump("id type", {"1 1"});
  for (const std::string rule : {"id:", "id:5", "id:a-b", "id:1-2x", "id:1-", "id:1-2-3",
                                 "id:99999999999999999999-3", "types", "Type"})
    EXPECT_INPUT_ERROR(find(text, rule), "'" + rule + "'", "expected");
  EXPECT_INPUT_ERROR(find(text, "id:5-4"), "'id:5-4'", "empty");
}

TEST_F(BodiesRule, MoreBodiesThanALabelHoldsAreRefused) {
  std::vector<std::string> lines;
  for (int i = 0; i < 255; ++i) lines.push_back("1 " + std::to_string(i));
  EXPECT_EQ(find(dump("id mol", lines), "mol").count(), 255u);
  lines.push_back("1 255");
  EXPECT_INPUT_ERROR(find(dump("id mol", lines), "mol"), "more than 255");
}

TEST_F(BodiesRule, ManyRunsAreSearched) {
  std::vector<Bodies::Run> runs;
  for (int i = 0; i < 1000; ++i)
    runs.push_back({10 * i, 10 * i + 4, static_cast<BodyIndex>(i % 2 + 1)});
  const Bodies bodies("id", runs, "");
  for (std::int64_t id = -3; id < 10'003; ++id) {
    const bool inside = id >= 0 && id < 10'000 && id % 10 < 5;
    ASSERT_EQ(labels(bodies, "id", {id})[0], inside ? static_cast<int>(id / 10 % 2) + 1 : 0) << id;
  }
}

}  // namespace
}  // namespace mdana
