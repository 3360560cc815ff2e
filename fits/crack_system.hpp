// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "fits/resistance.hpp"

namespace mdana {

/// Ranges of beta = G/gamma in which the crack law (P1 eq. B2) is one formula, in ascending order;
/// at their joins its value jumps, so that the contact can also slide along a join.
enum class CrackBranch { low, below, above, high };

namespace crack {

inline constexpr double least = 0.02, low_join = 0.29, high_join = 3.7, greatest = 50;

/// The crack law's logarithm, -ln(1 - 0.02/0.98 expm1(x)): zero, and the law infinite, at x = 0.
template <class T>
T logarithm(const T& x) {
  using std::expm1, std::log1p;
  return -log1p(-(least / (1 - least)) * expm1(x));
}

/// beta of which z is the logarithm's excess in that branch.
inline double reference(CrackBranch branch) {
  if (branch == CrackBranch::low) return std::log(least);
  return branch == CrackBranch::high ? std::log(greatest) : 0;
}

/// x |x|^(p - 1), whose slope does not vanish at x = 0 (as it would below this width): a fast crack
/// is nearer to beta = 1 than rounding, and Newton's method needs its stiffness. It changes x by
/// less than the width.
inline constexpr double rounded_width = 1e-10;
template <class T>
T odd_power(const T& x, double p) {
  using std::pow;
  return x * pow(x * x + rounded_width * rounded_width, 0.5 * (p - 1));
}

/// f(beta) of B2 outside the logarithmic branches, 1/f inside; odd beyond beta = 1.
template <class T>
T law(CrackBranch branch, const T& z) {
  using std::abs, std::exp, std::expm1;
  switch (branch) {
    case CrackBranch::low:
      return least * exp(z) * logarithm(z) / 0.15;
    case CrackBranch::high:
      return logarithm(T(-z)) / (-0.24 * greatest) * exp(-z);
    case CrackBranch::below: {
      const T x = expm1(-z);
      return (0.1035 * abs(x) + 0.3421) * odd_power(x, 1.1160);
    }
    case CrackBranch::above:
      break;
  }
  const T x = expm1(z);
  return -(0.2112 * abs(x) + 0.3939) * odd_power(x, 1.1403);
}

inline bool logarithmic(CrackBranch branch) {
  return branch == CrackBranch::low || branch == CrackBranch::high;
}

/// f at a join, seen from a branch beside it.
inline double join_value(CrackBranch branch) {
  const double z =
      std::log(branch == CrackBranch::low || branch == CrackBranch::below ? low_join : high_join);
  const double value = law(branch, z - reference(branch));
  return logarithmic(branch) ? 1 / value : value;
}

}  // namespace crack

/// State w, u, z = ln beta - reference(branch); quadratures tau and the energy dissipated. With
/// h = 3u^2 - d = 2 sqrt(beta u) and dtau/ds = 1/(1 + kap |f|/c):
///
///     w' = -2u (d - u^2) - lam u w,   u' = kap f(beta),   z' = (12u/h - 1/u) u' - 2w/h
struct CrackSystem {
  static constexpr int states = 3, quadratures = 2, parameters = 5, events = 3;
  std::array<double, parameters> p{};  ///< w0 (in the start only), lam, kap, b, zeta
  bool stress = false, stress_in_crack = false;
  double c = 1;  ///< greatest speed of u by s
  CrackBranch branch = CrackBranch::low;
  bool sliding = false;     ///< along the join above `branch`
  bool after_turn = false;  ///< the spheres part: an event is w rising through zero, else falling

  template <class T, class P>
  void rates(const T* y, const P* p_, T* dy) const {
    using std::exp, std::expm1, std::sqrt;
    const T &w = y[0], &u = y[1];
    const T q = y[2] + crack::reference(branch);
    const T h = 2 * exp(0.5 * q) * sqrt(u);
    const T d = 3 * u * u - h;
    T dt(1.0), du(0.0);
    pace(w, u, h, y[2], p_, dt, du);
    const T resistance = resistance_of(u, w, p_);
    dy[0] = -(2 * u * (d - u * u) + resistance) * dt;
    dy[1] = du;
    dy[2] = sliding ? T(0.0) : T((12 * u / h - 1 / u) * du - 2 * w / h * dt);
    dy[3] = dt;
    dy[4] = resistance * w * dt - 4 * u * expm1(q) * du;
  }

  double d(const double* y) const { return 3 * y[1] * y[1] - excess(y); }
  /// Elastic force and bulk dissipation.
  double force(const double* y) const {
    return 2 * y[1] * (d(y) - y[1] * y[1]) + resistance_of(y[1], y[0], p.data());
  }
  /// w^2/2 + U (P1 eq. 7), by h, which does not cancel.
  double energy(const double* y) const {
    const double u = y[1], h = excess(y), u2 = u * u;
    return 0.5 * y[0] * y[0] + u * (u2 * (4.8 * u2 - 4 * h) + h * h - 2 * u);
  }
  /// h = 3u^2 - d.
  double excess(const double* y) const {
    return 2 * std::exp(0.5 * (y[2] + crack::reference(branch))) * std::sqrt(y[1]);
  }

  /// 0: w through zero. 1, 2: the lower and upper end of the branch, or of sliding.
  template <class T, class P>
  T event(int k, const T* y, const P* p_) const {
    if (k == 0) return after_turn ? T(-y[0]) : y[0];
    // At beta = 1 q' = -2w/h: it is passed upwards while the spheres part only, downwards while
    // they approach only. A fast crack is nearer to it than rounding, and would seem to pass to and
    // fro.
    if (branch == CrackBranch::below && k == 2 && !after_turn) return T(1.0);
    if (branch == CrackBranch::above && k == 1 && after_turn) return T(1.0);
    if (!sliding) return k == 1 ? T(y[2] - lower()) : T(upper() - y[2]);
    return k == 1 ? drift(y, p_, branch) : T(-drift(y, p_, next(branch)));
  }

  /// Ends of the branch in its z. Beyond beta = 0.02 the law has no meaning: it repels.
  double lower() const {
    switch (branch) {
      case CrackBranch::low:
        return -1e-3;
      case CrackBranch::below:
        return std::log(crack::low_join);
      case CrackBranch::above:
        return 0;
      case CrackBranch::high:
        break;
    }
    return std::log(crack::high_join) - crack::reference(branch);
  }
  double upper() const {
    switch (branch) {
      case CrackBranch::low:
        return std::log(crack::low_join) - crack::reference(branch);
      case CrackBranch::above:
        return std::log(crack::high_join);
      default:
        return 0;
    }
  }
  static CrackBranch next(CrackBranch b) {
    return static_cast<CrackBranch>(static_cast<int>(b) + 1);
  }

  /// dq/dtau that the law of a branch would give at its join.
  template <class T, class P>
  T drift(const T* y, const P* p_, CrackBranch side) const {
    using std::exp, std::sqrt;
    const T &w = y[0], &u = y[1];
    const T h = 2 * exp(0.5 * (y[2] + crack::reference(branch))) * sqrt(u);
    return (12 * u / h - 1 / u) * (speed(u, p_) * crack::join_value(side)) - 2 * w / h;
  }

 private:
  template <class T>
  static T pressure(const T& u) {
    using std::sqrt;
    return u - 1 / (3 * sqrt(u));
  }
  template <class P>
  static std::array<P, 3> lam_b_zeta(const P* p_) {
    return {p_[1], p_[3], p_[4]};
  }
  template <class T, class P>
  T resistance_of(const T& u, const T& w, const P* p_) const {
    return BulkResistance{stress}.force(u, w, pressure(u), lam_b_zeta(p_).data());
  }
  /// kap with the T(p_c) of the crack.
  template <class T, class P>
  T speed(const T& u, const P* p_) const {
    return stress_in_crack ? T(p_[2] / stress_factor(pressure(u), p_[3], p_[4])) : T(p_[2]);
  }
  /// dtau/ds and du/ds; logarithmic branches by 1/f, so that infinite f is an ordinary point.
  template <class T, class P>
  void pace(const T& w, const T& u, const T& h, const T& z, const P* p_, T& dt, T& du) const {
    using std::abs;
    if (sliding) {  // u' keeps beta
      du = (2 * w / h) / (12 * u / h - 1 / u);
      return;
    }
    const T kap = speed(u, p_), f = crack::law(branch, z);
    if (!crack::logarithmic(branch)) {
      dt = 1 / (1 + kap * abs(f) / c);
      du = kap * f * dt;
      return;
    }
    const T size = branch == CrackBranch::low ? f : T(-f);
    const T whole = size + kap / c;
    dt = size / whole;
    du = (branch == CrackBranch::low ? kap : T(-kap)) / whole;
  }
};

}  // namespace mdana
