// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <gtest/gtest.h>

#include "analyses/merge_tree.hpp"

namespace mdana {
namespace {

/// A partial that remembers how it was merged: "((0 1) 2)".
class Trace final : public Partial {
 public:
  explicit Trace(std::size_t block) : text(std::to_string(block)) {}
  void add(const LabelledBlock&) override {}
  void merge(const Partial& later) override {
    text = "(" + text + " " + dynamic_cast<const Trace&>(later).text + ")";
  }
  void close(std::span<double>) const override {}
  void pass(Parcel&) override {}
  std::string text;
};

std::string tree(std::size_t blocks) {
  MergeTree merge;
  for (std::size_t i = 0; i < blocks; ++i) merge.push(std::make_unique<Trace>(i));
  const auto whole = merge.finish();
  return whole ? dynamic_cast<const Trace&>(*whole).text : "";
}

TEST(MergeTree, HasOneShapeForEachNumberOfBlocks) {
  EXPECT_EQ(tree(0), "");
  EXPECT_EQ(tree(1), "0");
  EXPECT_EQ(tree(2), "(0 1)");
  EXPECT_EQ(tree(3), "((0 1) 2)");
  EXPECT_EQ(tree(4), "((0 1) (2 3))");
  EXPECT_EQ(tree(7), "(((0 1) (2 3)) ((4 5) 6))");
  EXPECT_EQ(tree(8), "(((0 1) (2 3)) ((4 5) (6 7)))");
}

// Every block once and in order, and no merge of more than log2(blocks) + 1 levels.
TEST(MergeTree, HoldsAllBlocksInOrder) {
  for (std::size_t blocks = 1; blocks <= 130; ++blocks) {
    std::string order, expected;
    int depth = 0, deepest = 0;
    for (const char c : tree(blocks)) {
      depth += (c == '(') - (c == ')');
      deepest = std::max(deepest, depth);
      if (c != '(' && c != ')') order += c;
    }
    for (std::size_t i = 0; i < blocks; ++i) expected += (i ? " " : "") + std::to_string(i);
    EXPECT_EQ(order, expected);
    EXPECT_LE(1u << deepest, 2 * blocks);
  }
}

// A subtree over complete blocks does not depend on what follows.
TEST(MergeTree, CompleteSubtreesStay) {
  const std::string eight = tree(8);
  for (std::size_t blocks = 9; blocks < 40; ++blocks)
    EXPECT_NE(tree(blocks).find(eight), std::string::npos) << blocks;
}

TEST(MergeTree, IsEmptyAfterFinish) {
  MergeTree merge;
  merge.push(std::make_unique<Trace>(0));
  EXPECT_TRUE(merge.finish());
  EXPECT_FALSE(merge.finish());
}

}  // namespace
}  // namespace mdana
