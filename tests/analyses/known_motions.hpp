// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/analyses/collision.hpp"

namespace mdana::test {

/// A head-on collision on a grid of times so fine that its numbers are known.
struct KnownMotion {
  std::string name;
  double mass = 3;
  double dt = 0;
  std::vector<Approach> path;

  double force(std::size_t i) const { return -mass * path[i].acceleration; }

  std::size_t turn() const {  ///< the first one
    std::size_t i = 1;
    while (i + 1 < path.size() && !(path[i].speed <= 0 && path[i].delta > 0)) ++i;
    return i;
  }

  /// Kinetic energy lost between the passages of `low` before and after the first turn.
  double loss(double low) const {
    std::size_t in = turn(), out = turn();
    while (in > 0 && path[in].delta > low) --in;
    while (out + 1 < path.size() && path[out].delta > low) ++out;
    const auto squared = [&](std::size_t i, std::size_t j) {  // at low, between two neighbours
      const double p = (low - path[i].delta) / (path[j].delta - path[i].delta);
      return (1 - p) * path[i].speed * path[i].speed + p * path[j].speed * path[j].speed;
    };
    return 0.5 * mass * (squared(in, in + 1) - squared(out - 1, out));
  }

  double greatest_force(std::size_t last) const {
    double greatest = force(0);
    for (std::size_t i = 0; i <= last; ++i) greatest = std::max(greatest, force(i));
    return greatest;
  }
  double least_force(std::size_t last) const {
    double least = force(0);
    for (std::size_t i = 0; i <= last; ++i) least = std::min(least, force(i));
    return least;
  }
  double delta_max() const {
    double greatest = path[0].delta;
    for (const Approach& a : path) greatest = std::max(greatest, a.delta);
    return greatest;
  }

  /// Twice the grid points from where the force is a hundredth of its maximum to the turn.
  std::size_t contact_points() const {
    const double limit = 0.01 * greatest_force(path.size() - 1);
    std::size_t first = 0;
    while (std::abs(force(first)) < limit) ++first;
    return 2 * (turn() - first);
  }
};

/// Runge-Kutta of fourth order for m delta'' = -force(delta, v), from delta on until it is there again, or so
/// many times.
template <class Force>
KnownMotion followed(std::string name, double delta, double v, double dt, double longest, Force&& force) {
  KnownMotion motion{std::move(name), 3, dt, {}};
  const double start = delta;
  const auto a = [&](double x, double u) { return -force(x, u) / motion.mass; };
  for (double t = 0; t < longest && (delta >= start || t == 0); t += dt) {
    motion.path.push_back({delta, v, a(delta, v)});
    const double k1 = v, l1 = a(delta, v), k2 = v + dt / 2 * l1, l2 = a(delta + dt / 2 * k1, k2);
    const double k3 = v + dt / 2 * l2, l3 = a(delta + dt / 2 * k2, k3), k4 = v + dt * l3, l4 = a(delta + dt * k3, k4);
    delta += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    v += dt / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
  }
  return motion;
}

/// Springs, Hertz with and without viscosity, and smooth attraction with and without friction, which bounce or stick.
inline std::vector<KnownMotion> known_motions() {
  constexpr double v = 0.5, dt = 2e-3, k = 0.6;
  const auto positive = [](double x) { return std::max(x, 0.0); };
  const auto morse = [](double x) { return 0.2 * (std::exp(2 * x / 0.5) - 2 * std::exp(x / 0.5)); };
  std::vector<KnownMotion> all{
      followed("spring", -2, v, dt, 100, [&](double x, double) { return k * positive(x); }),
      followed("Hertz", -2, v, dt, 100, [&](double x, double) { return k * std::pow(positive(x), 1.5); }),
      followed("viscous Hertz", -2, v, dt, 100,
               [&](double x, double u) { return k * std::pow(positive(x), 1.5) + 0.3 * std::sqrt(positive(x)) * u; }),
      followed("attraction", -4, v, dt, 100, [&](double x, double) { return morse(x); }),
      followed("attraction with friction", -4, v, dt, 100, [&](double x, double u) { return morse(x) + 0.05 * std::exp(x / 0.5) * u; }),
      followed("sticking", -4, 0.15, dt, 80, [&](double x, double u) { return morse(x) + 0.2 * std::exp(x / 0.5) * u; })};
  KnownMotion plastic{"plastic spring", 3, dt, {}};
  const Path path = plastic_bounce(v, 0.45, 0.9);
  for (double t = -4; t < 12; t += dt) plastic.path.push_back(path(t));
  all.push_back(std::move(plastic));
  return all;
}

/// How a motion is dumped.
struct Sampling {
  ForceSource source;
  double frames;  ///< in contact
  double noise;   ///< standard deviation, as a part of delta_max, of the speed, of the greatest acceleration
  bool told;      ///< by the printed digits; else only the frames show it
};

/// Frames of the motion with noise, from a random one on.
inline RelativeMotion dumped(const KnownMotion& known, const Sampling& sampling, std::mt19937_64& random) {
  const auto step = std::max<std::size_t>(1, static_cast<std::size_t>(static_cast<double>(known.contact_points()) / sampling.frames));
  std::vector<double> times;
  for (std::size_t i = random() % step; i < known.path.size(); i += step) times.push_back(known.dt * static_cast<double>(i));
  RelativeMotion motion = head_on(
      times, [&](double t) { return known.path[static_cast<std::size_t>(std::lround(t / known.dt))]; }, 20, known.mass);
  const double most = known.greatest_force(known.path.size() - 1);
  motion.position_noise = sampling.noise * known.delta_max();
  motion.velocity_noise = sampling.noise * known.path[0].speed;
  std::normal_distribution<double> normal;
  const auto shake = [&](Eigen::Matrix3Xd& m, double s) {
    for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] += s * normal(random);
  };
  shake(motion.position, motion.position_noise);
  shake(motion.velocity, motion.velocity_noise);
  shake(motion.acceleration, sampling.noise * most / known.mass);
  if (!sampling.told) motion.position_noise = motion.velocity_noise = 0;
  return motion;
}

}  // namespace mdana::test
