// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/shares.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "readers/file_set.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;

/// Seconds of mdana plan for the samples, in those of one reading.
constexpr double reading = 3, defects = 7, accuracy = 26, stability = 18;
constexpr double packed = 3;  ///< text over its size when packed

double size_of(const fs::path& file) {
  std::error_code not_there;
  const auto size = fs::file_size(file, not_there);
  const bool small = file.extension() == ".gz" || file.extension() == ".zst";
  return not_there ? 0 : (small ? packed : 1) * static_cast<double>(size);
}

double bytes_of(const fs::path& dump) try {
  const auto set = find_file_set(dump);
  if (!set) return size_of(dump);
  double bytes = 0;
  for (const auto& pieces : *set)
    for (const fs::path& piece : pieces) bytes += size_of(piece);
  return bytes;
} catch (const InputError&) {  // the run itself tells of it
  return 0;
}

double weight_of(const StudyRun& run) {
  if (run.state == RunState::failed) return 0;
  const bool spheres = run.scene.interaction != Interaction::aggregate;
  return bytes_of(run.task.dump) * (reading + accuracy * run.task.accuracy + stability * run.task.stability +
                                    defects * (run.task.defects && spheres));
}

/// The run whose E* and R a run takes, as far as that is known before it is fitted.
std::optional<std::size_t> companion(const StudyRun& run) {
  return run.partners.empty() ? std::nullopt : std::optional(run.partners.front());
}

bool has(const std::vector<std::size_t>& list, std::size_t run) { return std::ranges::find(list, run) != list.end(); }

class Shares {
 public:
  Shares(const std::vector<StudyRun>& runs, std::size_t tasks) : runs_(runs), shares_(tasks), load_(tasks, 0.0) {
    for (const StudyRun& run : runs) weight_.push_back(weight_of(run));
  }

  std::vector<Share> all() {
    for (const std::size_t run : order()) give(run);
    for (Share& share : shares_) {
      std::ranges::sort(share.runs);
      std::ranges::sort(share.besides);
    }
    return std::move(shares_);
  }

 private:
  /// Runs that others need come last: by then they are done somewhere besides.
  std::vector<std::size_t> order() const {
    std::vector<char> needed(runs_.size(), false);
    for (const StudyRun& run : runs_)
      if (const auto other = companion(run)) needed[*other] = true;
    std::vector<std::size_t> order(runs_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
      return needed[a] != needed[b] ? needed[b] != 0 : weight_[a] > weight_[b];
    });
    return order;
  }

  bool is_there(std::size_t run, const Share& share) const { return has(share.runs, run) || has(share.besides, run); }

  double cost(std::size_t run, const Share& share) const {
    if (has(share.besides, run)) return 0;
    const auto other = companion(runs_[run]);
    return weight_[run] + (other && !is_there(*other, share) ? weight_[*other] : 0);
  }

  /// Where it is done besides, else where it ends soonest, else where there are fewest.
  void give(std::size_t run) {
    const bool somewhere = std::ranges::any_of(shares_, [&](const Share& s) { return has(s.besides, run); });
    const auto rank = [&](std::size_t k) {
      const bool anew = somewhere && !has(shares_[k].besides, run);
      return std::tuple(anew, load_[k] + cost(run, shares_[k]), shares_[k].runs.size());
    };
    std::size_t best = 0;
    for (std::size_t k = 1; k < shares_.size(); ++k)
      if (rank(k) < rank(best)) best = k;
    add(run, best);
  }

  void add(std::size_t run, std::size_t to) {
    Share& share = shares_[to];
    load_[to] += cost(run, share);
    const auto other = companion(runs_[run]);
    if (other && !is_there(*other, share)) share.besides.push_back(*other);
    std::erase(share.besides, run);
    share.runs.push_back(run);
  }

  const std::vector<StudyRun>& runs_;
  std::vector<Share> shares_;
  std::vector<double> load_, weight_;
};

}  // namespace

std::vector<Share> share_out(const std::vector<StudyRun>& runs, std::size_t tasks) { return Shares(runs, tasks).all(); }

}  // namespace mdana
