// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reports/figure_kinds.hpp"
#include "reports/study/fits.hpp"

namespace mdana {

/// Figures that show several runs, by kinds; runs are given one by one.
class PooledFigures {
 public:
  /// Names of the kinds that are wanted; empty: all.
  explicit PooledFigures(std::vector<std::string> wanted) : wanted_(std::move(wanted)) {}

  /// Curves of one run.
  void add(const ReportedRun& run, const RunRecord& record);

  /// Points of all runs, and what their fits say. Figures in the order of the kinds.
  std::vector<Figure> finish(std::span<const ReportedRun* const> runs, const StudyFits& fits);

  /// Kinds that there are no data for; after `finish`.
  const std::vector<LeftOut>& left_out() const { return left_out_; }

 private:
  struct Curves {
    Figure figure;
    std::vector<Series> laws;  ///< drawn once
  };
  bool wants(const FigureKind& kind) const;
  void finish_points(const FigureKind& kind, std::span<const ReportedRun* const> runs, const StudyFits& fits);

  std::vector<std::string> wanted_;
  bool snapshots_ = false;  ///< some run has them, each its own
  using Group = std::pair<std::string, Units>;
  std::map<std::string, std::map<Group, Curves>> curves_;  ///< by kind
  std::map<std::string, std::vector<Figure>> finished_;    ///< by kind
  std::vector<LeftOut> left_out_;
};

}  // namespace mdana
