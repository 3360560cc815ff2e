// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/relative_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analyses/motion.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

Eigen::MatrixXd differentiate(const RelativeMotion& motion, const Eigen::Matrix3Xd& samples,
                              DerivativeRule rule, ForceDerivative by) {
  rule.degree = by.degree;
  rule.window = by.window > 0 ? by.window : by.degree + 1;
  if (motion.frames() <= rule.degree)
    throw InputError(fmt::format("{} frames are too few to differentiate; {} are needed",
                                 motion.frames(), rule.degree + 1));
  return derivative(motion.times, samples, rule);
}

/// Change of atoms or mass of a body over those of the first frame. Masses summed in another order of
/// the atoms differ by rounding; a lost atom of 10^8 by 1e-8.
double loss(const BodyMotion& body, const BodyMotion& first) {
  const double mass = std::abs(body.mass - first.mass) / first.mass;
  return std::max(std::abs(body.atoms - first.atoms) / first.atoms, mass > 1e-10 ? mass : 0);
}

/// Counts what the bodies lost up to frame `i`.
void follow_atoms(const std::array<BodyMotion, 2>& bodies, const std::array<BodyMotion, 2>& first,
                  std::size_t i, RelativeMotion& motion) {
  const double change = std::max(loss(bodies[0], first[0]), loss(bodies[1], first[1]));
  motion.lost.push_back(first[0].atoms + first[1].atoms - bodies[0].atoms - bodies[1].atoms);
  if (change > 0 && motion.first_lost == 0) motion.first_lost = i;
  motion.greatest_loss = std::max(motion.greatest_loss, change);
  if (change > most_lost)
    throw InputError(fmt::format("step {}: the bodies ({:.10g} and {:.10g} atoms, masses {:.10g} and "
                                 "{:.10g}) differ by more than {:g} % from those of the first frame "
                                 "({:.10g} and {:.10g}, {:.10g} and {:.10g}): atoms were lost or changed "
                                 "body; use the frames before it (--frames)",
                                 motion.steps[i], bodies[0].atoms, bodies[1].atoms, bodies[0].mass,
                                 bodies[1].mass, 100 * most_lost, first[0].atoms, first[1].atoms,
                                 first[0].mass, first[1].mass));
}

/// Components of the columns of `vectors` along the centre line.
std::vector<double> along_centre_line(const RelativeMotion& motion,
                                      const Eigen::Matrix3Xd& vectors, double factor) {
  std::vector<double> result;
  for (Eigen::Index i = 0; i < motion.frames(); ++i) {
    const Eigen::Vector3d line = motion.position.col(i);
    if (line.isZero(0))
      throw InputError(fmt::format("step {}: the centres of the bodies coincide",
                                   motion.steps[static_cast<std::size_t>(i)]));
    result.push_back(factor * (vectors.col(i).dot(line) / line.norm()));
  }
  return result;
}

Eigen::Matrix3Xd every(const Eigen::Matrix3Xd& columns, std::size_t first, std::size_t stride) {
  std::vector<Eigen::Index> chosen;
  for (auto i = static_cast<Eigen::Index>(first); i < columns.cols();
       i += static_cast<Eigen::Index>(stride))
    chosen.push_back(i);
  return columns(Eigen::all, chosen);
}

template <class T>
std::vector<T> every(const std::vector<T>& values, std::size_t first, std::size_t stride) {
  std::vector<T> chosen;
  for (std::size_t i = first; i < values.size(); i += stride) chosen.push_back(values[i]);
  return chosen;
}

void check_times(const RelativeMotion& motion) {
  for (std::size_t i = 1; i < motion.times.size(); ++i)
    if (!(motion.times[i] > motion.times[i - 1]))
      throw InputError(fmt::format("step {}: the time {} does not come after {}", motion.steps[i],
                                   motion.times[i], motion.times[i - 1]));
}

}  // namespace

std::string_view name(ForceSource source) {
  constexpr std::array<std::string_view, 3> names{"forces", "velocities", "positions"};
  return names[static_cast<std::size_t>(source)];
}

std::string_view description(ForceSource source) {
  constexpr std::array<std::string_view, 3> texts{
      "summed forces of the atoms, m* (F2/m2 - F1/m1)",
      "m* dv/dt, derivative of the relative velocity",
      "m* d2x/dt2, second derivative of the relative position"};
  return texts[static_cast<std::size_t>(source)];
}

bool RelativeMotion::can_give(ForceSource source) const {
  switch (source) {
    case ForceSource::forces: return acceleration.cols() > 0;
    case ForceSource::velocities: return velocity.cols() > 0 && !times.empty();
    case ForceSource::positions: return !times.empty();
  }
  return false;
}

std::vector<double> RelativeMotion::distance() const {
  std::vector<double> result;
  for (Eigen::Index i = 0; i < frames(); ++i) result.push_back(position.col(i).norm());
  return result;
}

RelativeMotion RelativeMotion::subset(std::size_t first, std::size_t stride) const {
  RelativeMotion part;
  part.steps = every(steps, first, stride);
  part.times = every(times, first, stride);
  part.reduced_mass = reduced_mass;
  part.lost = every(lost, first, stride);
  part.greatest_loss = greatest_loss;
  part.position_noise = position_noise;
  part.velocity_noise = velocity_noise;
  part.position = every(position, first, stride);
  part.velocity = every(velocity, first, stride);
  part.acceleration = every(acceleration, first, stride);
  return part;
}

RelativeMotion relative_motion(const Table& motion, const std::vector<std::int64_t>& steps,
                               const std::vector<double>& times) {
  RelativeMotion result;
  result.steps = steps;
  result.times = times;
  const auto n = static_cast<Eigen::Index>(motion.rows());
  const bool has_velocity = motion.has("vx1");
  const bool has_force = motion.has("fx1");
  result.position.resize(3, n);
  result.velocity.resize(3, has_velocity ? n : 0);
  result.acceleration.resize(3, has_force ? n : 0);
  check_times(result);
  std::array<BodyMotion, 2> first;
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::array<BodyMotion, 2> bodies = body_motion(motion, static_cast<std::size_t>(i));
    const auto& [a, b] = bodies;
    if (i == 0) {
      first = bodies;
      result.reduced_mass = a.mass * (b.mass / (a.mass + b.mass));
    }
    follow_atoms(bodies, first, static_cast<std::size_t>(i), result);
    result.position.col(i) = b.position - a.position;
    if (has_velocity) result.velocity.col(i) = b.velocity - a.velocity;
    if (has_force) result.acceleration.col(i) = b.force / b.mass - a.force / a.mass;
  }
  return result;
}

Eigen::Matrix3Xd relative_velocity(const RelativeMotion& motion) {
  if (motion.velocity.cols() > 0) return motion.velocity;
  if (motion.times.empty() || motion.frames() <= first_derivative.degree) return {};
  return derivative(motion.times, motion.position, first_derivative);
}

std::vector<double> approach_speed(const RelativeMotion& motion) {
  const Eigen::Matrix3Xd velocity = relative_velocity(motion);
  if (velocity.cols() == 0) return {};
  return along_centre_line(motion, velocity, -1.0);
}

std::vector<double> squared_speed(const RelativeMotion& motion) {
  const Eigen::RowVectorXd squares = relative_velocity(motion).colwise().squaredNorm();
  return {squares.begin(), squares.end()};
}

std::vector<double> interparticle_force(const RelativeMotion& motion, ForceSource source,
                                        Units units, ForceDerivative by) {
  if (!motion.can_give(source))
    throw InputError(fmt::format("the force cannot be had from {}: {}", name(source),
                                 motion.times.empty() && source != ForceSource::forces
                                     ? "the time between frames is unknown"
                                     : "the dump lacks the columns"));
  const double from_acceleration = motion.reduced_mass * force_per_mass_acceleration(units);
  switch (source) {
    case ForceSource::forces:
      return along_centre_line(motion, motion.acceleration, motion.reduced_mass);
    case ForceSource::velocities:
      return along_centre_line(
          motion, differentiate(motion, motion.velocity, first_derivative, by),
          from_acceleration);
    case ForceSource::positions:
      return along_centre_line(
          motion, differentiate(motion, motion.position, second_derivative, by),
          from_acceleration);
  }
  return {};
}

}  // namespace mdana
