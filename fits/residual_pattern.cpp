// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/residual_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace mdana {
namespace {

constexpr std::size_t most_values = 64;  ///< of R or v: more are no groups
constexpr double stands_out = 3;         ///< standard errors by which a group's mean square must be above all

struct Sum {
  double square = 0, plain = 0;
  int count = 0;

  void add(double r) { square += r * r, plain += r, ++count; }
  double rms() const { return count ? std::sqrt(square / count) : 0; }
  double mean() const { return count ? plain / count : 0; }
};

/// "R = 29.6: rms 4.1, mean +3.9 (too high); all: rms 1.2" of the group that stands out most, or nothing.
std::string worst_group(std::string_view name, std::span<const ObservedCollision> seen,
                        std::span<const FittedPoint> points) {
  std::map<double, Sum> groups;
  Sum all;
  for (const FittedPoint& p : points) {
    const auto x = seen[p.seen].find(name);
    if (!x) return {};
    groups[*x].add(p.residual);
    all.add(p.residual);
  }
  if (groups.size() < 2 || groups.size() > most_values) return {};
  const auto worst = std::ranges::max_element(groups, {}, [](const auto& g) { return g.second.rms(); });
  const Sum& s = worst->second;
  const double excess = s.rms() * s.rms() / (all.rms() * all.rms()) - 1;
  if (!(excess > stands_out * std::sqrt(2.0 / s.count))) return {};
  const bool one_sided = std::abs(s.mean()) > 0.7 * s.rms();
  return fmt::format("largest at {} = {:g}: rms {:.3g}{}; all: {:.3g}", name, worst->first, s.rms(),
                     !one_sided ? "" : s.mean() > 0 ? ", the fit is too high" : ", the fit is too low", all.rms());
}

std::string where(const ObservedCollision& s) {
  std::string text;
  for (const char* name : {"R", "v"})
    if (const auto x = s.find(name)) text += fmt::format("{}{} = {:g}", text.empty() ? "" : ", ", name, *x);
  return text;
}

/// What was seen of a quantity that has no other story than its value.
double value_of(const ObservedCollision& s, const FittedPoint& p) {
  switch (p.quantity) {
    case SeenQuantity::delta_max: return s.delta_max.value;
    case SeenQuantity::t_max: return s.t_max.value;
    case SeenQuantity::delta: return s.motion[p.sample].delta.value;
    case SeenQuantity::velocity: return s.motion[p.sample].velocity.value;
    case SeenQuantity::force: return s.motion[p.sample].force.value;
    case SeenQuantity::e_squared: break;
  }
  return s.e.value * s.e.value;
}

std::string said(const ObservedCollision& s, const FittedPoint& p) {
  constexpr std::string_view names[] = {"e^2", "delta_max", "t_max", "delta", "v", "F"};
  const auto e = [](double squared) { return squared > 0 ? fmt::format("e {:.4g}", std::sqrt(squared)) : std::string("sticking"); };
  if (p.quantity == SeenQuantity::e_squared)
    return fmt::format("{}, fit {}", s.stuck ? "sticking" : e(value_of(s, p)), e(p.predicted));
  const std::string text = fmt::format("{} {:.4g}, fit {:.4g}", names[static_cast<std::size_t>(p.quantity)],
                                       value_of(s, p), p.predicted);
  return p.quantity < SeenQuantity::delta ? text : fmt::format("{}, t = {:.4g}", text, s.motion[p.sample].time);
}

}  // namespace

std::vector<std::string> describe_residuals(std::span<const ObservedCollision> seen,
                                            std::span<const FittedPoint> points) {
  std::vector<std::string> lines;
  if (points.empty()) return lines;
  for (const char* name : {"R", "v"})
    if (std::string line = worst_group(name, seen, points); !line.empty()) lines.push_back(std::move(line));
  const auto worst = std::ranges::max_element(points, {}, [](const FittedPoint& p) { return std::abs(p.residual); });
  lines.push_back(fmt::format("greatest {:.3g} at {} ({})", worst->residual, where(seen[worst->seen]),
                              said(seen[worst->seen], *worst)));
  return lines;
}

}  // namespace mdana
