// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "fits/dual.hpp"

namespace mdana {

/// exp of this does not overflow, and more makes no difference: nothing moves.
inline constexpr double greatest_exponent = 250;

/// T(p_c)/T_0 = exp[(b p)^zeta] for p > 0, else 1 (P1 eq. 17), with b p = B p_c/E*.
template <class T, class P>
auto stress_factor(const T& p, const P& b, const P& zeta) {
  using std::exp, std::pow;
  using Result = decltype(p * b);
  const Result x = p * b;
  if (!(value_of(x) > 0)) return Result(1);
  const Result power = pow(x, zeta);
  return value_of(power) < greatest_exponent ? Result(exp(power))
                                             : Result(std::exp(greatest_exponent));
}

/// Force of bulk dissipation lam u w, P1 eq. 12, with T(p_c) if `stress`. p: lam, b, zeta.
struct BulkResistance {
  static constexpr int parameters = 3;
  bool stress = false;

  template <class T, class P>
  T force(const T& u, const T& w, const T& pressure, const P* p) const {
    const T f = p[0] * u * w;
    return stress ? T(f * stress_factor(pressure, p[1], p[2])) : f;
  }
};

/// sgn(w) D |w|^alpha u^beta, P1 eq. 19. p: D, alpha, beta.
struct PowerResistance {
  static constexpr int parameters = 3;

  template <class T, class P>
  T force(const T& u, const T& w, const T& pressure, const P* p) const {
    using std::pow, std::abs;
    (void)pressure;
    if (!(value_of(u) > 0)) return value_of(p[2]) > 0 ? T(0.0) : rate(w, p);
    return rate(w, p) * pow(u, p[2]);
  }

 private:
  template <class T, class P>
  static T rate(const T& w, const P* p) {
    using std::pow, std::abs;
    const T size = p[0] * pow(abs(w), p[1]);
    return value_of(w) < 0 ? T(-size) : size;
  }
};

}  // namespace mdana
