// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/weak_direction.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mdana {
namespace {

constexpr double unknown_below = 1e-6;  ///< of the greatest singular value
constexpr int largest_power = 9;

/// The direction in small whole numbers, if there are some within 1 %; else scaled to 1 at most.
Eigen::VectorXd simplest(const Eigen::VectorXd& direction) {
  Eigen::Index top = 0;
  direction.cwiseAbs().maxCoeff(&top);
  const Eigen::VectorXd scaled = direction / direction[top];
  for (int k = 1; k <= largest_power; ++k) {
    const Eigen::VectorXd whole = (scaled * k).array().round();
    if ((whole - scaled * k).cwiseAbs().maxCoeff() < 0.01) return whole;
  }
  return scaled;
}

std::string power(const std::string& name, double exponent) {
  return std::abs(exponent) == 1 ? name : fmt::format("{}^{:.3g}", name, std::abs(exponent));
}

/// gamma^5/E^2
std::string product(std::span<const std::string> names, const Eigen::VectorXd& exponents) {
  std::vector<std::string> above, below;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double x = exponents[static_cast<Eigen::Index>(i)];
    if (std::abs(x) >= 0.01) (x > 0 ? above : below).push_back(power(names[i], x));
  }
  if (above.empty()) above.push_back("1");
  if (below.empty()) return fmt::format("{}", fmt::join(above, " "));
  return fmt::format("{}/{}", fmt::join(above, " "),
                     below.size() == 1 ? below[0] : fmt::format("({})", fmt::join(below, " ")));
}

}  // namespace

std::string describe_weak_direction(std::span<const std::string> names, const Eigen::MatrixXd& v,
                                    const Eigen::VectorXd& s) {
  const Eigen::Index n = v.cols();
  if (n == 1) return s[0] > 0 ? "" : fmt::format("nothing is known of {}", names[0]);
  const double last = s.size() < n ? 0 : s[n - 1];
  const std::string weakest = product(names, simplest(v.col(n - 1)));
  if (last > unknown_below * s[0])
    return fmt::format("{} is known {:.2g} times worse than {}", weakest, s[0] / last,
                       product(names, simplest(v.col(0))));
  if (n == 2)
    return fmt::format("only {} is determined", product(names, simplest(v.col(0))));
  return fmt::format("nothing is known of {}", weakest);
}

}  // namespace mdana
