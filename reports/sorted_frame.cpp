// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/sorted_frame.hpp"

#include <algorithm>

#include "readers/columns.hpp"

namespace mdana {

SortedFrame::SortedFrame(std::string key, std::vector<std::string> columns)
    : key_(std::move(key)), columns_(std::move(columns)) {}

void SortedFrame::add(AtomBlock block) {
  for (std::size_t i = 0; i < block.atoms(); ++i) order_.push_back({blocks_.size(), i});
  blocks_.push_back(std::move(block));
}

void SortedFrame::give(const std::function<void(const AtomBlock&)>& use) {
  if (!key_.empty()) sort();
  AtomBlock sorted;
  for (std::size_t first = 0; first < order_.size(); first += AtomBlock::capacity) {
    sorted.reset(first / AtomBlock::capacity,
                 std::min(AtomBlock::capacity, order_.size() - first));
    fill(sorted, first);
    use(sorted);
  }
}

void SortedFrame::sort() {
  std::vector<std::span<const std::int64_t>> keys;
  for (const AtomBlock& block : blocks_) keys.push_back(block.integer(key_));
  std::ranges::stable_sort(order_, {}, [&](const Place& p) { return keys[p.block][p.atom]; });
}

void SortedFrame::fill(AtomBlock& sorted, std::size_t first) const {
  const auto gather = [&](auto values_of, auto to) {
    std::vector<decltype(values_of(blocks_[0]))> from;
    for (const AtomBlock& block : blocks_) from.push_back(values_of(block));
    for (std::size_t i = 0; i < to.size(); ++i) {
      const Place& place = order_[first + i];
      to[i] = from[place.block][place.atom];
    }
  };
  for (const std::string& name : columns_) switch (kind_of_column(name)) {
      case ColumnKind::real:
        gather([&](const AtomBlock& b) { return b.real(name); }, sorted.make_real(name));
        break;
      case ColumnKind::integer:
        gather([&](const AtomBlock& b) { return b.integer(name); }, sorted.make_integer(name));
        break;
      case ColumnKind::text:
        gather([&](const AtomBlock& b) { return b.text(name); }, sorted.make_text(name));
        break;
    }
}

}  // namespace mdana
