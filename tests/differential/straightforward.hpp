// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "tests/contracts/made_up_dump.hpp"

namespace mdana::test {

/// What the analyses' pages say of a frame, written down as it stands there, in long double: all atoms at once, every
/// sum twice, nothing merged. With each number the scale that rounding is measured in.
class Straightforward {
 public:
  using Real = long double;
  using Vector = Eigen::Matrix<Real, 3, 1>;
  struct Number {
    double value, scale;
  };

  Straightforward(const MadeUpFrame& frame, std::array<double, 2> radii, double half_layer)
      : frame_(frame), radii_(radii), half_layer_(half_layer) {
    for (const int b : {0, 1}) bodies_[static_cast<std::size_t>(b)] = body(b);
    for (const int b : {0, 1}) {
      motion(b);
      energies(b);
    }
    of_the_pair();
    contact();
  }

  const std::map<std::string, Number>& numbers() const { return numbers_; }

 private:
  struct Body {
    std::vector<const MadeUpAtom*> atoms;
    Real mass = 0;
    Vector x = Vector::Zero(), v = Vector::Zero(), f = Vector::Zero();
    Real far = 0, fast = 0, strong = 0;  ///< greatest of an atom
  };

  static Vector wide(const Eigen::Vector3d& v) { return v.cast<Real>(); }

  Body body(int b) const {
    Body body;
    for (const MadeUpAtom& atom : frame_.atoms) {
      if (atom.type != b + 1) continue;
      body.atoms.push_back(&atom);
      body.mass += atom.mass;
      body.x += atom.mass * wide(atom.x);
      body.v += atom.mass * wide(atom.v);
      body.f += wide(atom.f);
      body.far = std::max(body.far, wide(atom.x).norm());
      body.fast = std::max(body.fast, wide(atom.v).norm());
      body.strong += wide(atom.f).norm();
    }
    body.x /= body.mass;
    body.v /= body.mass;
    return body;
  }

  void tell(const std::string& name, Real value, Real scale) {
    numbers_[name] = {static_cast<double>(value), static_cast<double>(scale)};
  }

  void motion(int b) {
    const Body& body = bodies_[static_cast<std::size_t>(b)];
    const std::string n = std::to_string(b + 1);
    tell("atoms" + n, static_cast<Real>(body.atoms.size()), 1);
    tell("mass" + n, body.mass, body.mass);
    for (const int k : {0, 1, 2}) {
      const std::string axis(1, "xyz"[k]);
      tell(axis + n, body.x[k], body.far);
      tell("v" + axis + n, body.v[k], body.fast);
      tell("f" + axis + n, body.f[k], body.strong);
    }
  }

  void energies(int b) {
    const Body& body = bodies_[static_cast<std::size_t>(b)];
    const std::string n = std::to_string(b + 1);
    Real thermal = 0, squares = 0, potential = 0, deep = 0;
    for (const MadeUpAtom* atom : body.atoms) {
      thermal += 0.5L * atom->mass * (wide(atom->v) - body.v).squaredNorm();
      squares += atom->mass * (wide(atom->x) - body.x).squaredNorm();
      potential += atom->pe;
      deep += std::abs(static_cast<Real>(atom->pe));
    }
    tell("K_t" + n, thermal, 0.5L * body.mass * body.fast * body.fast);
    tell("W" + n, potential, deep);
    tell("radius" + n, std::sqrt(5.0L / 3 * squares / body.mass), body.far);
    if (body.atoms.size() > 3) rotation(body, n);
  }

  /// L.I^-1.L/2 by the inverse itself: of bodies that are no line.
  void rotation(const Body& body, const std::string& n) {
    Vector angular = Vector::Zero();
    Eigen::Matrix<Real, 3, 3> inertia = Eigen::Matrix<Real, 3, 3>::Zero();
    for (const MadeUpAtom* atom : body.atoms) {
      const Vector r = wide(atom->x) - body.x;
      angular += atom->mass * r.cross(wide(atom->v) - body.v);
      inertia += atom->mass * (r.squaredNorm() * Eigen::Matrix<Real, 3, 3>::Identity() - r * r.transpose());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, 3, 3>> axes(inertia);
    const Real condition = axes.eigenvalues()[2] / axes.eigenvalues()[0];
    if (!(condition > 0 && condition < 1e4L)) return;
    const Vector along = axes.eigenvectors().transpose() * angular;
    Real energy = 0;
    for (const int k : {0, 1, 2}) energy += 0.5L * along[k] * along[k] / axes.eigenvalues()[k];
    tell("rotation" + n, energy, condition * 0.5L * body.mass * body.fast * body.fast);
  }

  void of_the_pair() {
    const Body &a = bodies_[0], &b = bodies_[1];
    const Vector line = (b.x - a.x).normalized(), relative = b.v - a.v;
    const Real reduced = a.mass * b.mass / (a.mass + b.mass), fast = a.fast + b.fast, distance = (b.x - a.x).norm();
    const Real turn = 1 + (a.far + b.far) / distance;  // by which rounding of the places turns the line
    tell("distance", distance, a.far + b.far);
    tell("approach speed", -relative.dot(line), fast * turn);
    tell("force", reduced * (b.f / b.mass - a.f / a.mass).dot(line), (a.strong + b.strong) * turn);
  }

  /// sqrt(2) r_g within the layer about the plane where the spheres intersect.
  void contact() {
    const Vector line = (bodies_[1].x - bodies_[0].x).normalized();
    const Real x = (bodies_[1].x - bodies_[0].x).norm();
    const Vector plane = bodies_[0].x + line * (x * x + radii_[0] * radii_[0] - radii_[1] * radii_[1]) / (2 * x);
    std::vector<Vector> within;
    std::array<int, 2> count{};
    Real nearest_edge = 1;
    for (const MadeUpAtom& atom : frame_.atoms) {
      const Vector r = wide(atom.x) - plane;
      const Real height = r.dot(line);
      nearest_edge = std::min(nearest_edge, std::abs(std::abs(height) - half_layer_));
      if (std::abs(height) > half_layer_) continue;
      within.push_back(r - height * line);
      ++count[static_cast<std::size_t>(atom.type - 1)];
    }
    if (nearest_edge < 1e-9L) return;  // rounding decides who is in
    tell("layer_atoms1", count[0], 1);
    tell("layer_atoms2", count[1], 1);
    Vector mean = Vector::Zero();
    for (const Vector& r : within) mean += r / static_cast<Real>(within.size());
    Real squares = 0;
    for (const Vector& r : within) squares += (r - mean).squaredNorm();
    const bool both = count[0] > 0 && count[1] > 0;
    tell("contact_radius", both ? std::sqrt(2 * squares / static_cast<Real>(within.size())) : 0, bodies_[0].far + bodies_[1].far);
  }

  const MadeUpFrame& frame_;
  std::array<double, 2> radii_;
  Real half_layer_;
  std::array<Body, 2> bodies_;
  std::map<std::string, Number> numbers_;
};

}  // namespace mdana::test
