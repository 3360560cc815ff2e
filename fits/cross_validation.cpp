// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/cross_validation.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace mdana {
namespace {

constexpr std::size_t most_groups = 12;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Group of each residual; none if an observation does not have the number.
std::vector<std::size_t> groups_of(const ContactModel& model, std::span<const ObservedCollision> seen,
                                   std::string_view name) {
  std::map<double, std::size_t> rank;
  for (const ObservedCollision& s : seen) {
    const auto x = s.find(name);
    if (!x) return {};
    rank[*x] = 0;
  }
  std::size_t next = 0;
  for (auto& [value, group] : rank) group = next++ * std::min(most_groups, rank.size()) / rank.size();
  std::vector<std::size_t> groups;
  for (std::size_t k = 0; k < model.residuals(); ++k)
    groups.push_back(rank.at(*seen[model.seen_of(k)].find(name)));
  return groups;
}

/// The parameters without one group.
Eigen::VectorXd without(ContactProblem& problem, const ContactOptimum* best,
                        std::span<const std::size_t> groups, std::size_t left_out) {
  if (!best) return Eigen::VectorXd(0);
  std::vector<std::size_t> rest;
  for (std::size_t k = 0; k < groups.size(); ++k)
    if (groups[k] != left_out) rest.push_back(k);
  return problem.solve(best->fit.values, rough, {{}, std::move(rest)}).ln;
}

}  // namespace

double cross_validated(ContactProblem& problem, const ContactOptimum* best,
                       std::span<const ObservedCollision> seen, std::string_view name) {
  const std::vector<std::size_t> groups = groups_of(problem.model(), seen, name);
  const std::size_t count = groups.empty() ? 0 : *std::ranges::max_element(groups) + 1;
  if (count < 2) return unknown;
  double sum = 0;
  for (std::size_t g = 0; g < count; ++g) {
    const Eigen::VectorXd ln = without(problem, best, groups, g);
    if (!ln.allFinite()) return unknown;
    for (std::size_t k = 0; k < groups.size(); ++k)
      if (groups[k] == g) {
        const double r = problem.model().residual(k, ln);
        sum += r * r;
      }
  }
  return std::sqrt(sum / static_cast<double>(groups.size()));
}

}  // namespace mdana
