// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/extreme/made_up_collision.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mdana {
namespace {

using std::numbers::pi;

/// Places of the atoms of a ball about its centre; the ball is its own mirror image, so the mean is nought.
std::vector<Eigen::Vector3d> ball_of_atoms(double radius) {
  std::vector<Eigen::Vector3d> atoms;
  const int n = static_cast<int>(radius);
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j)
      for (int k = -n; k <= n; ++k)
        if (const Eigen::Vector3d at(i, j, k); at.norm() <= radius) atoms.push_back(at);
  return atoms;
}

/// s(u) and its integral from 0.
double step(double u) { return u - std::sin(2 * pi * u) / (2 * pi); }
double step_integral(double u) { return u * u / 2 + (std::cos(2 * pi * u) - 1) / (4 * pi * pi); }

/// Where a rising function is nought, by bisection to the last bit.
template <class Function>
double zero_of(double low, double high, Function&& f) {
  for (double mid = (low + high) / 2; mid != low && mid != high; mid = (low + high) / 2)
    (f(mid) < 0 ? low : high) = mid;
  return high;
}

struct Relative {
  double delta, speed;
};

Relative in_contact(const MadeUpCollision& c, double u) {
  return {c.speed * c.duration * (u - (1 + c.e) * step_integral(u)), c.speed * (1 - (1 + c.e) * step(u))};
}

Relative relative(const MadeUpCollision& c, double t) {
  if (t < 0) return {c.speed * t, c.speed};
  if (t < c.duration) return in_contact(c, t / c.duration);
  return {in_contact(c, 1).delta - c.e * c.speed * (t - c.duration), -c.e * c.speed};
}

/// u of greatest compression.
double turn(const MadeUpCollision& c) {
  return zero_of(0, 1, [&](double u) { return -in_contact(c, u).speed; });
}

/// A frame's atoms as columns.
class FrameText {
 public:
  FrameText(const MadeUpCollision& c, std::size_t frame) : c_(c), frame_(frame), random_(frame) {}

  std::string text() {
    const double t = -c_.before + static_cast<double>(frame_) * c_.interval;
    const Relative r = relative(c_, t);
    const auto places = ball_of_atoms(c_.ball);
    for (int body = 0; body < 2; ++body) {
      const double side = body == 0 ? -0.5 : 0.5;
      const Eigen::Vector3d centre = c_.origin + c_.drift * t + Eigen::Vector3d::UnitX() * side * (c_.contact_distance() - r.delta);
      const Eigen::Vector3d velocity = c_.drift - Eigen::Vector3d::UnitX() * side * r.speed;
      for (const Eigen::Vector3d& place : places) add(body + 1, centre + place, velocity);
    }
    if (c_.shuffled) std::ranges::shuffle(lines_, random_);
    return fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS ff ff ff\n{}{}{}"
                       "ITEM: ATOMS id type x y z vx vy vz mass\n{}",
                       c_.first_step + static_cast<std::int64_t>(frame_) * c_.step_interval, lines_.size(), edge(0), edge(1),
                       edge(2), fmt::join(lines_, ""));
  }

 private:
  std::string number(double value) const { return fmt::format("{:.{}g}", value, c_.digits); }

  /// A box that holds all that moves.
  std::string edge(int axis) const {
    const double middle = c_.origin[axis];
    const double half = 10 * c_.ball + std::abs(c_.drift[axis]) * (c_.before + c_.duration + c_.after);
    return fmt::format("{:.17g} {:.17g}\n", (middle - half) * c_.length, (middle + half) * c_.length);
  }

  void add(int type, const Eigen::Vector3d& x, const Eigen::Vector3d& v) {
    std::uniform_real_distribution<double> noise(-c_.noise, c_.noise);
    std::vector<std::string> words{fmt::format("{}", c_.first_id + static_cast<std::int64_t>(lines_.size())),
                                   fmt::format("{}", type)};
    for (const double value : x) words.push_back(number((value + noise(random_)) * c_.length));
    for (const double value : v) words.push_back(number((value + noise(random_)) * c_.length / c_.time));
    words.push_back(number(c_.mass));
    if (c_.change) c_.change(frame_, words);
    if (!words.empty()) lines_.push_back(fmt::format("{}\n", fmt::join(words, " ")));
  }

  const MadeUpCollision& c_;
  std::size_t frame_;
  std::mt19937_64 random_;
  std::vector<std::string> lines_;
};

}  // namespace

std::size_t MadeUpCollision::frames() const {
  return 1 + static_cast<std::size_t>(std::lround((before + duration + after) / interval));
}

std::size_t MadeUpCollision::atoms() const { return ball_of_atoms(ball).size(); }

std::string MadeUpCollision::dump() const {
  std::string text;
  for (std::size_t frame = 0; frame < frames(); ++frame) text += FrameText(*this, frame).text();
  return text;
}

double MadeUpCollision::force_max() const {
  return 2 * reduced_mass() * (1 + e) * speed / duration * (mass * length / time / time);
}

double MadeUpCollision::delta_max() const { return in_contact(*this, turn(*this)).delta * length; }

double MadeUpCollision::kinetic_loss(double low) const {
  const double middle = turn(*this), level = low / length;
  const auto above = [&](double u) { return in_contact(*this, u).delta - level; };
  const double in = in_contact(*this, zero_of(0, middle, above)).speed;
  const bool free = above(1) > 0;
  const double out = free ? e * speed : in_contact(*this, zero_of(middle, 1, [&](double u) { return -above(u); })).speed;
  return reduced_mass() / 2 * (in * in - out * out) * (mass * length * length / time / time);
}

}  // namespace mdana
