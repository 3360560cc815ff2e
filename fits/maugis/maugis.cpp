// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <boost/math/tools/toms748_solve.hpp>

#include "fits/force_law.hpp"

namespace mdana {
namespace {

using std::numbers::pi;

/// theta = arctan t and functions of it, t = sqrt(c^2/a^2 - 1) (Maugis 1992), without cancellation.
struct Angle {
  double t, theta, secant;

  explicit Angle(double tangent)
      : t(tangent), theta(std::atan(tangent)), secant(std::hypot(1.0, tangent)) {}

  /// tan theta - theta = theta^3/(q - theta^2), q = 3 - theta^2/(5 - theta^2/(7 - ...)).
  double tangent_less_angle() const {
    if (theta > 1) return t - theta;
    const double squared = theta * theta;
    double q = 21;
    for (int odd = 19; odd >= 3; odd -= 2) q = odd - squared / q;
    return theta * squared / (q - squared);
  }
  double f() const { return tangent_less_angle() + t * t * theta; }
  double df() const { return 2 * t * (theta + t / (secant * secant)); }
  double g() const { return t * (theta - t / (1 + secant)); }
  double dg() const { return theta + t / (secant * secant) - t / secant; }
  double q() const { return t + secant * secant * theta; }
  double dq() const { return 2 + 2 * t * theta; }
};

/// A point of the curve in Maugis' units: A = a/a1, Delta = delta/delta1, P = F/(2 pi gamma R*).
struct Point {
  double lambda, A, slope;  ///< slope: d ln A/d ln t
  Angle angle;

  /// lambda/2 A^2 f + 4/3 lambda^2 A g = 1, whose positive root is A.
  Point(double stress, double t) : lambda(stress), angle(t) {
    const double b = 4.0 / 3.0 * lambda * lambda * angle.g(), d = lambda / 2 * angle.f();
    A = 2 / (b + std::sqrt(b * b + 4 * d));
    slope = -t * (lambda / 2 * angle.df() * A + 4.0 / 3.0 * lambda * lambda * angle.dg()) /
            (2 * d * A + b);
  }
  double delta() const { return A * (A - 4.0 / 3.0 * lambda * angle.t); }
  /// d Delta/d ln t; negative on the stable branch.
  double delta_slope() const {
    return A * (2 * A * slope - 4.0 / 3.0 * lambda * angle.t * (1 + slope));
  }
  double force() const { return A * A * (A - lambda * angle.q()); }
  double force_slope() const {
    return A * A * (slope * (3 * A - 2 * lambda * angle.q()) - lambda * angle.t * angle.dq());
  }
};

/// Root of a function of ln t that changes its sign between lo and hi, to the last bits.
template <class Function>
double root(const Function& function, double lo, double hi) {
  namespace tools = boost::math::tools;
  const double at_lo = function(lo), at_hi = function(hi);
  if (at_lo == 0) return lo;
  if (at_hi == 0) return hi;
  std::uintmax_t steps = 200;
  const auto found = tools::toms748_solve([&](double x) { return function(std::exp(x)); },
                                          std::log(lo), std::log(hi), at_lo, at_hi,
                                          tools::eps_tolerance<double>(52), steps);
  return std::exp(found.first + (found.second - found.first) / 2);
}

constexpr double no_contact = std::numeric_limits<double>::infinity();

/// The stable branch of one contact, from a = 0 or from a vertical tangent of delta upwards.
class Curve {
 public:
  explicit Curve(const ElasticContact& c)
      : gamma_(c.surface_energy / c.radius / c.modulus),
        stress_(gamma_ * (c.radius / c.spacing)),
        a1_(std::cbrt(1.5 * pi * gamma_)),
        lambda_(2 * stress_ * std::cbrt(9 / (32 * pi * gamma_))) {
    if (!adhesive()) return;
    const double b = 4.0 / 3.0 * lambda_ * lambda_ * (pi / 2 - 1), d = pi / 4 * lambda_;
    const double c0 = 2 / (b + std::sqrt(b * b + 4 * d));
    least_ = -4.0 / 3.0 * lambda_ * c0;
    end_ = fold();
    if (end_ < no_contact) least_ = at(end_).delta();
  }

  bool adhesive() const { return gamma_ > 0; }
  double stress() const { return stress_; }
  double gamma() const { return gamma_; }
  double a1() const { return a1_; }
  double least_delta() const { return least_ * a1_ * a1_; }

  /// t at delta/R*; infinite without contact.
  double tangent(double delta) const {
    const double d = delta / (a1_ * a1_);
    if (!(d >= least_ * (1 + 8 * std::numeric_limits<double>::epsilon()))) return no_contact;
    const auto above = [&](double t) { return at(t).delta() - d; };
    double hi = std::min(end_, 1.0), lo = hi;
    while (above(lo) < 0) lo /= 8;
    while (hi < std::min(end_, last_) && above(hi) > 0) hi = std::min(8 * hi, end_);
    if (!(above(hi) < 0)) return hi;
    return polished(root(above, lo, hi), d);
  }

  Point at(double t) const { return {lambda_, t}; }

 private:
  static constexpr double last_ = 1e20;  ///< t of a contact that is a point, to rounding

  /// Where dDelta/dt = 0; infinite if delta falls until a = 0 (lambda < 0.938: Johnson & Greenwood
  /// 1997). There is one at most; beyond 1e6 it moves delta by less than rounding.
  double fold() const {
    const auto slope = [&](double t) { return at(t).delta_slope() / at(t).A; };
    constexpr double far = 1e6;
    return slope(far) > 0 ? root(slope, std::min(0.5, 0.5 / lambda_), far) : no_contact;
  }

  /// One step of Newton, where the curve is not vertical.
  double polished(double t, double d) const {
    const Point p = at(t);
    const double step = (d - p.delta()) / p.delta_slope();
    return std::abs(step) < 1e-9 ? t * (1 + step) : t;
  }

  double gamma_, stress_, a1_, lambda_, least_ = 0, end_ = 0;
};

/// Radii of a contact in units of R*; without adhesion those of Hertz.
struct Radii {
  double a = 0;  ///< of contact
  double c = 0;  ///< of the cohesive zone about it
  double t = 0;  ///< sqrt(c^2/a^2 - 1)
};

Radii radii(const Curve& curve, double delta) {
  if (std::isnan(delta)) return {delta, delta, delta};
  if (!curve.adhesive() || std::isinf(delta / (curve.a1() * curve.a1()))) {
    const double a = delta > 0 ? std::sqrt(delta) : 0;
    return {a, a, 0};
  }
  const double t = curve.tangent(delta);
  if (t == no_contact) return {};
  const Point p = curve.at(t);
  const double a = curve.a1() * p.A;
  return {a, a * p.angle.secant, t};
}

double force(double delta, const ElasticContact& c) {
  const Curve curve(c);
  const Radii r = radii(curve, delta / c.radius);
  // 4/3 a^3 - 2 sigma0 a^2 (t + c^2/a^2 arctan t)
  const double attraction = 2 * curve.stress() * Angle(r.t).q();
  return c.modulus * c.radius * c.radius * (r.a * r.a * (4.0 / 3.0 * r.a - attraction));
}

double contact_radius(double delta, const ElasticContact& c) {
  return c.radius * radii(Curve(c), delta / c.radius).a;
}

double pressure_radius(double delta, const ElasticContact& c) {
  return c.radius * radii(Curve(c), delta / c.radius).c;
}

double least_delta(const ElasticContact& c) {
  const Curve curve(c);
  return curve.adhesive() ? c.radius * curve.least_delta() : 0;
}

double stiffness(double delta, const ElasticContact& c) {
  const Curve curve(c);
  const Radii r = radii(curve, delta / c.radius);
  if (r.t == 0) return 2 * c.modulus * c.radius * r.a;
  const Point p = curve.at(r.t);
  return 4.0 / 3.0 * c.modulus * c.radius * curve.a1() * (p.force_slope() / p.delta_slope());
}

/// E int_0^a (delta - x^2)^2 dx - 4 sigma0^2 J - 4 sigma0 K - 2 pi gamma c^2 with J = int_a^c (c^2 -
/// x^2) dx, K = int_a^c (delta - x^2) sqrt(c^2 - x^2) dx: elastic energy, and that of the zone.
double energy(double delta, const ElasticContact& contact) {
  const Curve curve(contact);
  const auto [a, c, t] = radii(curve, delta / contact.radius);
  const double theta = std::atan(t), s = curve.stress();
  const double stretch = 2 * s * a * t, d = a * a - stretch;
  const double core = a * (a * a * (8.0 / 15.0 * a * a - 4.0 / 3.0 * stretch) + stretch * stretch);
  const double gap = a * t * t / (1 + std::hypot(1.0, t));  // c - a
  const double j = gap * gap * (2 * c + a) / 3;
  const double k = c * c * (d * (theta / 2 - std::sin(2 * theta) / 4) -
                            c * c * (theta / 8 - std::sin(4 * theta) / 32));
  const double zone = 4 * s * (s * j + k);
  const double r3 = contact.radius * contact.radius * contact.radius;
  return contact.modulus * r3 * (core - zone - 2 * pi * curve.gamma() * c * c);
}

/// Within a: 2a/pi y - 2 sigma0/pi arctan(t/y), y = sqrt(1 - r^2/a^2); then -sigma0 up to c.
double pressure(double r, double delta, const ElasticContact& contact) {
  const Curve curve(contact);
  const auto [a, c, t] = radii(curve, delta / contact.radius);
  const double x = r / contact.radius;
  if (x >= c) return 0;
  if (x >= a) return -contact.modulus * curve.stress();
  const double y = std::sqrt((1 - x / a) * (1 + x / a));
  const double cohesion = t > 0 ? 2 / pi * curve.stress() * std::atan2(t, y) : 0;
  return contact.modulus * (2 / pi * a * y - cohesion);
}

constexpr std::array parameters{contact_parameter::radius, contact_parameter::modulus,
                                contact_parameter::surface_energy, contact_parameter::spacing};

}  // namespace

extern const ForceLaw maugis_law;
const ForceLaw maugis_law{
    {force, contact_radius, least_delta, stiffness, energy, pressure, pressure_radius},
    "maugis",
    "elastic spheres with a constant attraction up to a distance",
    parameters};

}  // namespace mdana
