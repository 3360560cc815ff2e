// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/sweep_rows.hpp"

#include <algorithm>
#include <utility>

#include "readers/column_choice.hpp"
#include "readers/ranks.hpp"

namespace mdana {

SweepRows::SweepRows(const FramePlan& plan, const SweepOptions& options) : plan_(plan), options_(options) {
  for (const auto& analysis : plan.analyses) result_.tables.emplace_back(analysis->columns());
}

void SweepRows::add(const FrameHeader& header, FrameOutcome&& outcome, std::optional<double> share, int owner) {
  agreement_.see(header);
  if (result_.steps.empty()) note_columns(header);
  give_products();
  held_ = std::move(outcome.products);
  holder_ = owner;
  for (std::size_t k = 0; k < outcome.rows.size(); ++k) result_.tables[k].add_row(outcome.rows[k]);
  result_.steps.push_back(header.step);
  if (header.time) result_.stated_times.push_back(*header.time);
  atoms_.push_back(header.atoms);
  result_.uncertain_images = std::max(result_.uncertain_images, outcome.uncertain_images);
  if (options_.progress) options_.progress({result_.steps.size(), share});
}

void SweepRows::note_columns(const FrameHeader& header) {
  result_.columns_not_read = header.columns;
  const ColumnChoice choice(header, plan_.wanted);
  for (const auto& column : choice.columns()) {
    result_.columns_read.push_back(column.name);
    std::erase(result_.columns_not_read, column.name);
  }
}

/// Of the frame before: it may have been dropped until now.
void SweepRows::give_products() try {
  for (auto& found : std::exchange(held_, {})) give(found);
} catch (...) {
  break_ranks();  // between the two that send and receive
  throw;
}

void SweepRows::give(FrameOutcome::Found& found) const {
  if (holder_ == rank() && is_first_rank()) return found.product->give();
  if (holder_ == rank()) return found.product->send(send_to_first_rank);
  const auto& analysis = dynamic_cast<const FrameAnalysis&>(*plan_.analyses[found.analysis]);
  if (is_first_rank()) analysis.give_sent([this] { return receive_from_rank(holder_); });
}

/// A frame with another number of atoms than the one before it: that number may be what is wrong, and lines that belong to
/// the frame what cannot be read behind it.
void SweepRows::damaged_behind() {
  const std::size_t n = atoms_.size();
  if (n > 1 && atoms_[n - 1] != atoms_[n - 2]) drop_last();
}

void SweepRows::drop_last() {
  held_.clear();
  for (Table& table : result_.tables) table.drop_last_row();
  if (result_.stated_times.size() == result_.steps.size()) result_.stated_times.pop_back();
  result_.steps.pop_back();
  atoms_.pop_back();
}

}  // namespace mdana
