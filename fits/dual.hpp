// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace mdana {

/// A value with its exact derivatives by N variables: what makes Jacobians and sensitivities of
/// formulas that are written once, for any number type.
template <int N>
struct Dual {
  using Gradient = Eigen::Matrix<double, N, 1>;
  double value = 0;
  Gradient gradient = Gradient::Zero();

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT: constants are numbers
  Dual(double v, const Gradient& g) : value(v), gradient(g) {}
  static Dual variable(double v, int k) { return {v, Gradient::Unit(k)}; }

  Dual operator-() const { return {-value, -gradient}; }
  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.gradient + b.gradient};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.gradient - b.gradient};
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.value * b.gradient + b.value * a.gradient};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double q = a.value / b.value;
    return {q, (a.gradient - q * b.gradient) / b.value};
  }
  friend Dual operator+(const Dual& a, double b) { return {a.value + b, a.gradient}; }
  friend Dual operator+(double a, const Dual& b) { return b + a; }
  friend Dual operator-(const Dual& a, double b) { return {a.value - b, a.gradient}; }
  friend Dual operator-(double a, const Dual& b) { return {a - b.value, -b.gradient}; }
  friend Dual operator*(const Dual& a, double b) { return {a.value * b, a.gradient * b}; }
  friend Dual operator*(double a, const Dual& b) { return b * a; }
  friend Dual operator/(const Dual& a, double b) { return a * (1 / b); }
  friend Dual operator/(double a, const Dual& b) {
    const double q = a / b.value;
    return {q, b.gradient * (-q / b.value)};
  }
};

inline double value_of(double x) { return x; }
template <int N>
double value_of(const Dual<N>& x) {
  return x.value;
}

template <int N>
Dual<N> sqrt(const Dual<N>& x) {
  const double root = std::sqrt(x.value);
  return {root, x.gradient * (0.5 / root)};
}
/// The cube root, exactly doubled if x is multiplied by eight, which std::cbrt does not promise.
inline double cube_root(double x) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  const int thirds = (exponent - ((exponent % 3) + 3) % 3) / 3;
  return std::ldexp(std::cbrt(std::ldexp(mantissa, exponent - 3 * thirds)), thirds);
}
template <int N>
Dual<N> cbrt(const Dual<N>& x) {
  const double root = cube_root(x.value);
  return {root, x.gradient * (root / (3 * x.value))};
}
template <int N>
Dual<N> exp(const Dual<N>& x) {
  const double power = std::exp(x.value);
  return {power, x.gradient * power};
}
template <int N>
Dual<N> expm1(const Dual<N>& x) {
  const double less = std::expm1(x.value);
  return {less, x.gradient * (less + 1)};
}
template <int N>
Dual<N> log(const Dual<N>& x) {
  return {std::log(x.value), x.gradient / x.value};
}
template <int N>
Dual<N> log1p(const Dual<N>& x) {
  return {std::log1p(x.value), x.gradient / (1 + x.value)};
}
template <int N>
Dual<N> abs(const Dual<N>& x) {
  return x.value < 0 ? -x : x;
}
/// x^p for x >= 0; at x = 0 the derivatives are zero.
template <int N>
Dual<N> pow(const Dual<N>& x, double p) {
  const double power = std::pow(x.value, p);
  return {power,
          x.value > 0 ? (x.gradient * (p * power / x.value)).eval() : Dual<N>::Gradient::Zero()};
}
template <int N>
Dual<N> pow(const Dual<N>& x, const Dual<N>& p) {
  const double power = std::pow(x.value, p.value);
  if (!(x.value > 0)) return {power};
  return {power, power * (x.gradient * (p.value / x.value) + p.gradient * std::log(x.value))};
}

}  // namespace mdana
