// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "analyses/analysis.hpp"

namespace mdana {

/// Merges partials, which arrive in block order, along the binary tree over block numbers: the
/// order of additions is a property of the data, and only log2(blocks) partials are held.
class MergeTree {
 public:
  void push(std::unique_ptr<Partial> partial) {
    int level = 0;
    while (!stack_.empty() && stack_.back().first == level) {
      merge_last(partial);
      ++level;
    }
    stack_.emplace_back(level, std::move(partial));
  }

  /// The whole; null if nothing was pushed.
  std::unique_ptr<Partial> finish() {
    if (stack_.empty()) return nullptr;
    auto whole = std::move(stack_.back().second);
    stack_.pop_back();
    while (!stack_.empty()) merge_last(whole);
    return whole;
  }

 private:
  void merge_last(std::unique_ptr<Partial>& later) {
    stack_.back().second->merge(*later);
    later = std::move(stack_.back().second);
    stack_.pop_back();
  }
  std::vector<std::pair<int, std::unique_ptr<Partial>>> stack_;
};

}  // namespace mdana
