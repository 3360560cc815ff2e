// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/fit_coordinates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mdana {
namespace {

/// k-th number in (0, 1) of a sequence that fills it evenly (Halton 1960).
double halton(std::size_t k, std::size_t base) {
  double value = 0, part = 1;
  for (; k > 0; k /= base) {
    part /= static_cast<double>(base);
    value += part * static_cast<double>(k % base);
  }
  return value;
}

bool are(const std::vector<Unknown>& unknowns, const std::array<std::string_view, 3>& names) {
  return std::ranges::equal(unknowns, names, {}, &Unknown::parameter);
}

}  // namespace

FitCoordinates::FitCoordinates(std::vector<Unknown> unknowns, const CollisionScales& scales)
    : unknowns_(std::move(unknowns)), scales_(scales) {
  for (const Unknown& u : unknowns_) {
    const double least = std::log(u.least), greatest = std::log(u.greatest);
    ranges_.push_back({least, greatest, u.start > 0 ? std::log(u.start) : (least + greatest) / 2});
  }
  if (are(unknowns_, {"C", "B", "zeta"})) stress_ranges();
  if (are(unknowns_, {"D", "alpha", "beta"})) power_ranges();
}

void FitCoordinates::stress_ranges() {
  kind_ = Kind::stress;
  const Range B = ranges_[1], zeta = ranges_[2];
  const double ln_p = std::log(scales_.pressure);
  const auto ln_z = [&](double ln_b, double ln_zeta) { return std::exp(ln_zeta) * (ln_b + ln_p); };
  // Where exp(z) changes the time by little or by much; B alone would span far more.
  const double start = ln_z(B.start, zeta.start);
  ranges_[1] = {std::min(-4.0, start), std::max(3.0, start), start};
  ranges_[2].margin = 0.3;
}

void FitCoordinates::power_ranges() {
  kind_ = Kind::power;
  const double ln_v = std::log(scales_.velocity), ln_a = std::log(scales_.contact_radius);
  const double alpha = std::exp(ranges_[1].start), beta = std::exp(ranges_[2].start);
  const double ln_force = std::log(scales_.force / scales_.modulus);  // D E* v^alpha a^beta is a force
  const double start =
      unknowns_[0].start > 0 ? ranges_[0].start + alpha * ln_v + beta * ln_a : ln_force - 1.5;
  ranges_[0] = {std::min(ln_force - 6, start), std::max(ln_force + 2, start), start};
  for (std::size_t k = 1; k < 3; ++k) {
    for (double* x : {&ranges_[k].least, &ranges_[k].greatest, &ranges_[k].start}) *x = std::exp(*x);
    ranges_[k].margin = std::min(0.4, 0.8 * ranges_[k].least);  // powers stay > 0
  }
}

std::vector<double> FitCoordinates::start(std::size_t k) const {
  constexpr std::array<std::size_t, 12> primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
  std::vector<double> q;
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    const Range& r = ranges_[i];
    const double at = halton(k, primes[i % primes.size()]);
    q.push_back(k == 0 ? r.start : r.least + at * (r.greatest - r.least));
  }
  return q;
}

Eigen::VectorXd FitCoordinates::logarithms(std::span<const double> q) const {
  Eigen::VectorXd ln = Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
  if (kind_ == Kind::stress) ln[1] = q[1] * std::exp(-q[2]) - std::log(scales_.pressure);
  if (kind_ == Kind::power) {
    ln[0] = q[0] - q[1] * std::log(scales_.velocity) - q[2] * std::log(scales_.contact_radius);
    ln[1] = std::log(q[1]);
    ln[2] = std::log(q[2]);
  }
  return ln;
}

Eigen::MatrixXd FitCoordinates::derivatives(std::span<const double> q) const {
  const auto n = static_cast<Eigen::Index>(q.size());
  Eigen::MatrixXd by = Eigen::MatrixXd::Identity(n, n);
  if (kind_ == Kind::stress) {
    by(1, 1) = std::exp(-q[2]);
    by(1, 2) = -q[1] * std::exp(-q[2]);
  }
  if (kind_ == Kind::power) {
    by(0, 1) = -std::log(scales_.velocity);
    by(0, 2) = -std::log(scales_.contact_radius);
    by(1, 1) = 1 / q[1];
    by(2, 2) = 1 / q[2];
  }
  return by;
}

Eigen::VectorXd FitCoordinates::beyond(std::span<const double> q) const {
  const auto out = [](double x, double least, double greatest) {
    return x < least ? x - least : std::max(0.0, x - greatest);
  };
  const auto n = static_cast<Eigen::Index>(size());
  const Eigen::VectorXd ln = logarithms(q);
  Eigen::VectorXd beyond = Eigen::VectorXd::Zero(2 * n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Unknown& u = unknowns_[i];
    beyond[k] = out(q[i], ranges_[i].least - ranges_[i].margin, ranges_[i].greatest + ranges_[i].margin);
    if (u.bounded) beyond[n + k] = out(ln[k], std::log(u.least), std::log(u.greatest));
  }
  return beyond;
}

}  // namespace mdana
