// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/lattice_sum.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr double greatest_cutoff = 100;  // sigma: beyond, the rest is below 3e-7 of e_1

/// Neighbours of an fcc atom at p^2 = 0, 1, 2, ... up to `most`: lattice points (i, j, k)/sqrt(2)
/// with i + j + k even.
std::vector<double> shells(std::size_t most) {
  std::vector<double> count(most + 1, 0.0);
  const auto edge = static_cast<std::int64_t>(std::sqrt(2.0 * static_cast<double>(most))) + 1;
  const auto end = 2 * static_cast<std::int64_t>(most);
  for (std::int64_t i = -edge; i <= edge; ++i)
    for (std::int64_t j = -edge; j <= edge; ++j)
      for (std::int64_t k = -edge; k <= edge; ++k) {
        const std::int64_t square = i * i + j * j + k * k;
        if (square % 2 == 0 && square <= end) ++count[static_cast<std::size_t>(square / 2)];
      }
  count[0] = 0;  // the atom itself
  return count;
}

double cube(double x) { return x * x * x; }

/// Sums over p^2 = 1 ... most, the smallest terms first.
FccSums sums(const std::vector<double>& count, std::size_t most) {
  FccSums sum;
  for (std::size_t s = most; s >= 1; --s) {
    const double sixth = 1 / cube(static_cast<double>(s));
    sum.neighbours += count[s];
    sum.sixth += count[s] * sixth;
    sum.twelfth += count[s] * sixth * sixth;
  }
  return sum;
}

/// sum of p^-2n over the lattice, n = 3 or 6: Ewald's split at t, with
/// Q = exp(-x) (1 + x + ... + x^(n-1)/(n-1)!), x = pi t p^2, and v = 1/sqrt(2) the volume of an atom:
/// sum Q p^-2n + pi^n/(n-1)! (t^(n-3/2)/(v (n-3/2)) - t^n/n).
/// t = 0.118: the terms of the reciprocal lattice, exp(-1.5 pi/t), are below 1e-17.
double endless_sum(const std::vector<double>& count, int n) {
  using std::numbers::pi;
  constexpr double t = 0.118, volume = std::numbers::sqrt2 / 2;
  double sum = 0, factorial = 1;
  for (int k = 2; k < n; ++k) factorial *= k;
  for (std::size_t s = count.size() - 1; s >= 1; --s) {
    const double square = static_cast<double>(s), x = pi * t * square;
    double term = 1, series = 1;
    for (int k = 1; k < n; ++k) series += term *= x / k;
    sum += count[s] * std::exp(-x) * series * std::pow(square, -n);
  }
  return sum + std::pow(pi, n) / factorial *
                   (std::pow(t, n - 1.5) / (volume * (n - 1.5)) - std::pow(t, n) / n);
}

/// Shells within `reach` nearest neighbour distances: p < reach.
std::size_t shells_within(double reach) {
  const auto most = static_cast<std::size_t>(reach * reach);
  return std::sqrt(static_cast<double>(most)) < reach ? most : most - 1;
}

void check_cutoff(const LennardJones& u) {
  if (u.cutoff && !(*u.cutoff <= greatest_cutoff * u.sigma))
    throw InputError(fmt::format("cutoff {:.6g}: more than {} sigma; take no cutoff instead",
                                 *u.cutoff, greatest_cutoff));
}

/// u(cutoff), by which every pair within it is shifted [energy].
double shift(const LennardJones& u) {
  if (!u.cutoff || !u.shifted) return 0;
  const double sixth = 1 / cube(*u.cutoff / u.sigma * (*u.cutoff / u.sigma));
  return 4 * u.epsilon * sixth * (sixth - 1);
}

/// e_1 = 2 epsilon (A x^-12 - B x^-6) less half a shift for each neighbour, x = D/sigma; P1 C2.
double energy(const LennardJones& u, const FccSums& sum, double distance) {
  const double x = distance / u.sigma, sixth = 1 / cube(x * x);
  const double pairs = 2 * u.epsilon * sixth * (sum.twelfth * sixth - sum.sixth);
  const double moved = shift(u);
  return moved == 0 ? pairs : pairs - 0.5 * sum.neighbours * moved;
}

/// Where e_1 of these neighbours is least: x^6 = 2A/B.
double stationary_distance(const LennardJones& u, const FccSums& sum) {
  return u.sigma * std::pow(2 * sum.twelfth / sum.sixth, 1.0 / 6);
}

/// K = V d2e/dV2 / v = sqrt(2)/(9 D) d2e/dD2, where de/dD = 0.
FccCrystal crystal(const LennardJones& u, const FccSums& sum) {
  const double distance = stationary_distance(u, sum), x = distance / u.sigma;
  const double second = 2 * u.epsilon / (u.sigma * u.sigma) *
                        (156 * sum.twelfth * std::pow(x, -14) - 42 * sum.sixth * std::pow(x, -8));
  return {energy(u, sum, distance), distance, std::numbers::sqrt2 / (9 * distance) * second};
}

}  // namespace

double FccCrystal::lattice_constant() const { return std::numbers::sqrt2 * distance; }

double FccCrystal::atom_volume() const { return cube(distance) / std::numbers::sqrt2; }

FccSums endless_fcc_sums() {
  static const FccSums all = [] {
    const auto count = shells(130);  // exp(-pi t 130) = 1e-21
    return FccSums{std::numeric_limits<double>::infinity(), endless_sum(count, 3),
                   endless_sum(count, 6)};
  }();
  return all;
}

double fcc_energy(const LennardJones& potential, double distance) {
  check_cutoff(potential);
  if (!potential.cutoff) return energy(potential, endless_fcc_sums(), distance);
  if (!(*potential.cutoff <= 2 * greatest_cutoff * distance))
    throw InputError(fmt::format("a distance of {:.6g} is too little for the cutoff", distance));
  const std::size_t most = shells_within(*potential.cutoff / distance);
  return energy(potential, sums(shells(most), most), distance);
}

FccCrystal relaxed_fcc(const LennardJones& potential) {
  check_cutoff(potential);
  if (!potential.cutoff) return crystal(potential, endless_fcc_sums());
  // The neighbours within the cutoff are the same for D between two edges cutoff/sqrt(s); there
  // the minimum is known. D lies between 1.09 sigma (all neighbours) and 2^(1/6) sigma (twelve).
  const double cutoff = *potential.cutoff;
  const std::size_t most = shells_within(cutoff / (1.09 * potential.sigma));
  const std::vector<double> count = shells(most);
  std::optional<FccCrystal> found;
  for (std::size_t s = shells_within(cutoff / (1.123 * potential.sigma)); s <= most; ++s) {
    if (s == 0) continue;
    const FccCrystal c = crystal(potential, sums(count, s));
    const bool fits = shells_within(cutoff / c.distance) == s;
    if (fits && (!found || c.energy < found->energy)) found = c;
  }
  if (!found)
    throw InputError(fmt::format("cutoff {:.6g}: no fcc crystal is free of pressure with it (a "
                                 "shell of neighbours lies on the cutoff); take another one",
                                 cutoff));
  return *found;
}

}  // namespace mdana
