// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <span>
#include <vector>

#include "analyses/temporary_file.hpp"

namespace mdana {

/// Runs of sorted records in a temporary file, given back in one order: external merge sort.
template <class Record>
class SortedRuns {
 public:
  void begin_run() { ends_.push_back(size()); }
  /// To the last run, in ascending order of their keys.
  void append(std::span<const Record> records) {
    file_.write(size(), records);
    ends_.back() += records.size();
  }
  std::uint64_t size() const { return ends_.empty() ? 0 : ends_.back(); }

  /// Calls use(record) in ascending order of key(record); of equal ones those of earlier runs first.
  template <class Key, class Use>
  void merge(const Key& key, const Use& use) const {
    std::vector<Cursor> cursors;
    for (std::size_t k = 0; k < ends_.size(); ++k)
      cursors.emplace_back(file_, k == 0 ? 0 : ends_[k - 1], ends_[k], buffered / ends_.size() + 16);
    using Head = std::pair<decltype(key(cursors[0].record())), std::size_t>;  // key, run
    std::priority_queue<Head, std::vector<Head>, std::greater<>> heads;
    for (std::size_t k = 0; k < cursors.size(); ++k)
      if (cursors[k].next()) heads.emplace(key(cursors[k].record()), k);
    while (!heads.empty()) {
      const std::size_t k = heads.top().second;
      heads.pop();
      // Runs of a dump that is sorted already do not overlap: as long as this one goes on, take it.
      do use(cursors[k].record());
      while (cursors[k].next() && (heads.empty() || Head(key(cursors[k].record()), k) < heads.top()));
      if (!cursors[k].ended()) heads.emplace(key(cursors[k].record()), k);
    }
  }

 private:
  static constexpr std::size_t buffered = 32768;  ///< records of all runs together

  /// A place in a run.
  class Cursor {
   public:
    Cursor(const RecordFile<Record>& file, std::uint64_t first, std::uint64_t end, std::size_t most)
        : file_(&file), next_(first), end_(end), most_(most) {}

    bool next() {
      if (++at_ < buffer_.size()) return true;
      buffer_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(most_, end_ - next_)));
      file_->read(next_, buffer_);
      next_ += buffer_.size();
      at_ = 0;
      return !ended();
    }
    bool ended() const { return at_ >= buffer_.size(); }
    const Record& record() const { return buffer_[at_]; }

   private:
    const RecordFile<Record>* file_;
    std::uint64_t next_, end_;
    std::size_t most_, at_ = 0;
    std::vector<Record> buffer_;
  };

  RecordFile<Record> file_;
  std::vector<std::uint64_t> ends_;
};

}  // namespace mdana
