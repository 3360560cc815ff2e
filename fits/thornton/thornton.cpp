// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fits/jkr_contact.hpp"

namespace mdana {
namespace {

using std::numbers::pi;

/// Of the units R* and E*: radius of curvature of the pressure, a/p0 = pi R*/(2 E*).
constexpr double rho = pi / 2;

/// The contact beyond yield in units of R* and E*: JKR's pressure cut off at p. With s = sqrt(a) and
/// kappa s = eta (eta + 2p), all is a polynomial with positive coefficients.
struct Yielding {
  double p, kappa, gamma;  ///< p_y = 1.6 Y (P1 II C); kappa = 4 sqrt(4 gamma/pi)/rho; gamma

  explicit Yielding(const ElasticContact& c)
      : p(1.6 * (c.yield_strength / c.modulus)),
        kappa(4 / rho * std::sqrt(4 / pi * (c.surface_energy / c.radius / c.modulus))),
        gamma(c.surface_energy / c.radius / c.modulus) {}

  double eta(double s) const { return kappa * s / (p + std::sqrt(p * p + kappa * s)); }

  /// sqrt(a) where the centre yields, p0 - q = p: s^3 - rho p s - rho^2 kappa/4 = 0. Newton from
  /// above on a convex function.
  double yield_root() const {
    const double b = rho * p, k = rho * rho * kappa / 4;
    double s = std::sqrt(b) + std::cbrt(k);
    for (int i = 0; i < 100; ++i) {
      const double next = s - (s * (s * s - b) - k) / (3 * s * s - b);
      if (!(next < s)) return s;
      s = next;
    }
    return s;
  }

  /// F = pi (a^2 p - rho^2/12 Z^2 (p + 2 eta)), Z = 2p + eta.
  double force(double s) const {
    const double h = eta(s), z = 2 * p + h;
    return pi * (s * s * s * s * p - rho * rho / 12 * z * z * (p + 2 * h));
  }

  double stiffness(double s) const {
    const double z = 2 * p + eta(s), s3 = 4 * s * s * s;
    return pi * (s3 * p - rho * rho * kappa * z / 4) / (s3 - rho * rho * kappa / 2);
  }

  /// Indefinite integral of F ddelta, delta = s^4 - rho^2 eta Z/2.
  double work(double s) const {
    const double h = eta(s), z = 2 * p + h, r2 = rho * rho, s4 = s * s * s * s;
    constexpr std::array<double, 8> c{32, 176, 384, 440, 290, 111, 23, 2};
    double cubic = 0, power = 1;  // s^4 sum c_k eta^k p^(7-k)/(k + 4)/Z^4, in q = eta/Z, r = p/Z
    const double q = h / z, r = p / z;
    for (std::size_t k = 0; k < c.size(); ++k, power *= q)
      cubic += c[k] * power * std::pow(r, 7 - static_cast<int>(k)) / static_cast<double>(k + 4);
    const double quintic =
        h * (p * p * p * p * 8 + h * (16 * p * p * p + h * (14 * p * p + h * (5.5 * p + h * 0.8))));
    return pi * (p * s4 * (s4 / 2 - r2 * kappa * s / 10) - 2.0 / 3.0 * r2 * s4 * z * z * z * cubic +
                 r2 * r2 / 24 * quintic);
  }

  /// What JKR's force has more than this one, over 4/3 a^3: from the root y of p0 y - q/y = p.
  double excess(const JkrContact& jkr) const {
    const double z = 2 * p + eta(std::sqrt(jkr.a)), y = z * rho / (2 * jkr.a), h = 1 - y;
    return h > 0 ? h * h * (h + 1.5 * (y + jkr.x / (3 * y))) : 0;
  }
};

/// Whether the pressure at the centre is beyond p.
bool yielded(const JkrContact& jkr, const Yielding& y) {
  return std::sqrt(jkr.a) > y.yield_root();
}

namespace loading {

double force(double delta, const ElasticContact& c) {
  const JkrContact jkr = jkr_contact(delta, c);
  const Yielding y(c);
  return c.modulus * c.radius * c.radius *
         (yielded(jkr, y) ? y.force(std::sqrt(jkr.a)) : jkr.force());
}

double contact_radius(double delta, const ElasticContact& c) {
  return c.radius * jkr_contact(delta, c).a;
}

double least_delta(const ElasticContact& c) { return c.radius * jkr_least_delta(Yielding(c).gamma); }

double stiffness(double delta, const ElasticContact& c) {
  const JkrContact jkr = jkr_contact(delta, c);
  const Yielding y(c);
  return c.modulus * c.radius *
         (yielded(jkr, y) ? y.stiffness(std::sqrt(jkr.a)) : jkr.stiffness());
}

double energy(double delta, const ElasticContact& c) {
  const JkrContact jkr = jkr_contact(delta, c);
  const Yielding y(c);
  double u = jkr.energy();
  if (yielded(jkr, y)) {
    const double s = y.yield_root(), a = s * s;
    // x of JKR at yield: p = p0 (1 - x/3).
    const JkrContact at_yield{a, 3 * (1 - rho * y.p / a)};
    u = at_yield.energy() + (y.work(std::sqrt(jkr.a)) - y.work(s));
  }
  return c.modulus * c.radius * c.radius * c.radius * u;
}

double pressure(double r, double delta, const ElasticContact& c) {
  return c.modulus * std::min(jkr_contact(delta, c).pressure(r / c.radius), Yielding(c).p);
}

}  // namespace loading

namespace returning {

/// JKR of a larger radius R_p and a shifted delta, with a and F of the turning point.
struct Dent {
  ElasticContact contact;  ///< with R_p
  double delta;            ///< delta - delta_p

  Dent(double delta_now, const ElasticContact& c) : contact(c), delta(delta_now) {
    const JkrContact turn = jkr_contact(c.delta_max, c);
    const Yielding y(c);
    if (!yielded(turn, y)) return;
    const double elastic = 4.0 / 3.0 * turn.a * turn.a * turn.a;
    const double flatter = y.force(std::sqrt(turn.a)) / elastic + turn.x;  // R*/R_p
    contact.radius = c.radius / flatter;
    delta = delta_now - c.radius * (turn.a * turn.a * y.excess(turn));
  }
};

double force(double delta, const ElasticContact& c) {
  const Dent dent(delta, c);
  const ElasticContact& d = dent.contact;
  return d.modulus * d.radius * d.radius * jkr_contact(dent.delta, d).force();
}

double contact_radius(double delta, const ElasticContact& c) {
  const Dent dent(delta, c);
  return dent.contact.radius * jkr_contact(dent.delta, dent.contact).a;
}

double least_delta(const ElasticContact& c) {
  const Dent dent(0, c);
  const ElasticContact& d = dent.contact;
  return d.radius * jkr_least_delta(d.surface_energy / d.radius / d.modulus) - dent.delta;
}

double stiffness(double delta, const ElasticContact& c) {
  const Dent dent(delta, c);
  return c.modulus * dent.contact.radius * jkr_contact(dent.delta, dent.contact).stiffness();
}

double energy(double delta, const ElasticContact& c) {
  const Dent dent(delta, c);
  const double r = dent.contact.radius;
  return c.modulus * r * r * r * jkr_contact(dent.delta, dent.contact).energy();
}

double pressure(double r, double delta, const ElasticContact& c) {
  const Dent dent(delta, c);
  return c.modulus * jkr_contact(dent.delta, dent.contact).pressure(r / dent.contact.radius);
}

}  // namespace returning

constexpr std::array parameters{contact_parameter::radius, contact_parameter::modulus,
                                contact_parameter::surface_energy,
                                contact_parameter::yield_strength};

const ForceBranch way_back{returning::force,       returning::contact_radius,
                           returning::least_delta, returning::stiffness,
                           returning::energy,      returning::pressure,
                           returning::contact_radius};

}  // namespace

extern const ForceLaw thornton_law;
const ForceLaw thornton_law{
    {loading::force, loading::contact_radius, loading::least_delta, loading::stiffness,
     loading::energy, loading::pressure, loading::contact_radius},
    "thornton",
    "elastic, perfectly plastic spheres with or without adhesion",
    parameters,
    &way_back};

}  // namespace mdana
