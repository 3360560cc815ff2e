// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/hertz.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>
#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

constexpr double force_power = 1.5;
constexpr double linear_power = 2.0 / 3.0;

/// The chosen points without dimensions: x = (X - X_least)/range, f = F/F_max. The parameters are
/// q = (2R - X_least)/range and ln k, with f = k (q - x)^1.5: both of order one at any scale.
struct Scaled {
  std::vector<double> x, f;
  std::vector<double> error;  ///< of f, over their geometric mean; 1 for equal weights
  double x_least = 0, range = 0, f_max = 0;
};

std::vector<std::size_t> choose(const HertzData& data, const HertzSettings& s, double f_max) {
  std::vector<std::size_t> points;
  const std::size_t end = s.phase == HertzPhase::loading ? data.turn + 1 : data.force.size();
  for (std::size_t i = 0; i < std::min(end, data.force.size()); ++i)
    if (data.force[i] >= s.min_force_fraction * f_max &&
        data.force[i] <= s.max_force_fraction * f_max && data.force[i] > 0)
      points.push_back(i);
  return points;
}

Scaled scale(const HertzData& data, const std::vector<std::size_t>& points, double f_max) {
  Scaled scaled;
  scaled.f_max = f_max;
  double least = data.distance[points[0]], most = least;
  for (const std::size_t i : points) {
    least = std::min(least, data.distance[i]);
    most = std::max(most, data.distance[i]);
  }
  scaled.x_least = least;
  scaled.range = most - least;
  for (const std::size_t i : points) {
    scaled.x.push_back((data.distance[i] - least) / scaled.range);
    scaled.f.push_back(data.force[i] / f_max);
  }
  return scaled;
}

/// f^(2/3) = k^(2/3) (q - x) as a straight line: the linear method's exact optimum without a loss,
/// and a start for the others. Gives {ln k, q}.
std::vector<double> straight_line(const Scaled& data) {
  const auto n = static_cast<Eigen::Index>(data.x.size());
  Eigen::MatrixXd line(n, 2);
  Eigen::VectorXd y(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    line.row(i) << 1.0, -data.x[static_cast<std::size_t>(i)];
    y[i] = std::pow(data.f[static_cast<std::size_t>(i)], linear_power);
  }
  const Eigen::Vector2d c = line.colPivHouseholderQr().solve(y);
  const double slope = c[1] > 0 ? c[1] : 1.0;  // force that falls with compression: start anywhere
  return {force_power * std::log(slope), c[1] > 0 ? c[0] / slope : 1.0};
}

/// Standard errors of the chosen points as weights of order one.
std::vector<double> relative_errors(const HertzData& data, const std::vector<std::size_t>& points,
                                    HertzWeights weights) {
  if (weights == HertzWeights::equal) return std::vector<double>(points.size(), 1.0);
  std::vector<double> errors;
  double logarithms = 0;
  for (const std::size_t i : points) {
    if (i >= data.error.size() || !(data.error[i] > 0) || !std::isfinite(data.error[i]))
      throw InputError(fmt::format("Hertz fit: the force of frame {} has no error to weigh it by; fit with equal "
                                   "weights", i));
    errors.push_back(data.error[i]);
    logarithms += std::log(data.error[i]);
  }
  const double mean = std::exp(logarithms / static_cast<double>(points.size()));
  for (double& e : errors) e /= mean;
  return errors;
}

PointResidual plain_residual(const Scaled& data, HertzMethod method) {
  if (method == HertzMethod::linear)
    return [&data](std::size_t i, std::span<const double> p, double& r, std::span<double> g) {
      const double slope = std::exp(linear_power * p[0]);
      const double model = slope * (p[1] - data.x[i]);
      r = model - std::pow(data.f[i], linear_power);
      if (g.empty()) return true;
      g[0] = linear_power * model;
      g[1] = slope;
      return true;
    };
  return [&data](std::size_t i, std::span<const double> p, double& r, std::span<double> g) {
    const double k = std::exp(p[0]);
    const double overlap = std::max(0.0, p[1] - data.x[i]);
    const double root = std::sqrt(overlap);
    r = k * overlap * root - data.f[i];
    if (g.empty()) return true;
    g[0] = k * overlap * root;
    g[1] = k * force_power * root;
    return true;
  };
}

/// Over the error of the point: of f, or of f^(2/3).
PointResidual residual_of(const Scaled& data, HertzMethod method) {
  return [&data, method, plain = plain_residual(data, method)](std::size_t i, std::span<const double> p,
                                                               double& r, std::span<double> g) {
    const double slope = method == HertzMethod::linear ? linear_power * std::pow(data.f[i], linear_power - 1) : 1;
    const double weight = data.error[i] == 1 ? 1 : 1 / (data.error[i] * slope);
    if (!plain(i, p, r, g)) return false;
    r *= weight;
    for (double& x : g) x *= weight;
    return true;
  };
}

/// Scale beyond which residuals count as outliers: 1.345 robust standard deviations (Huber 1981)
/// about the straight line, at least rounding.
double loss_scale(const Scaled& data, const PointResidual& residual,
                  const std::vector<double>& start) {
  std::vector<double> size;
  for (std::size_t i = 0; i < data.x.size(); ++i) {
    double r = 0;
    residual(i, start, r, {});
    size.push_back(std::abs(r));
  }
  const auto middle = size.begin() + static_cast<long>(size.size() / 2);
  std::nth_element(size.begin(), middle, size.end());
  return std::max(1.345 * 1.4826 * *middle, 1e-12);
}

double rms_force_residual(const HertzFit& hertz, const Scaled& data) {
  const double k = std::exp(hertz.fit.values[0]), q = hertz.fit.values[1];
  double sum = 0;
  for (std::size_t i = 0; i < data.x.size(); ++i) {
    const double r = k * std::pow(std::max(0.0, q - data.x[i]), force_power) - data.f[i];
    sum += r * r;
  }
  return std::sqrt(sum / static_cast<double>(data.x.size()));
}

/// From {ln k, q} to E* and R with propagated errors: R1 + R2 = 2R = X_least + range q,
/// 4/3 E* sqrt(R*) range^1.5 = k F_max, and R* = (R1 + R2) c/(1 + c)^2 with c = R1/R2.
void physical_parameters(HertzFit& hertz, const Scaled& data, double ratio) {
  const double ln_k = hertz.fit.values[0], q = hertz.fit.values[1];
  const double radius = 0.5 * (data.x_least + data.range * q);
  hertz.strength = 0.75 * std::exp(ln_k) * data.f_max / (data.range * std::sqrt(data.range));
  hertz.strength_error = hertz.strength * std::sqrt(hertz.fit.covariance(0, 0));
  const double reduced = 2 * radius * (ratio / ((1 + ratio) * (1 + ratio)));
  const double modulus = hertz.strength / std::sqrt(reduced);
  Eigen::Matrix2d by;  // d(ln E*, R) / d(ln k, q)
  by << 1.0, -0.25 * data.range / radius, 0.0, 0.5 * data.range;
  const Eigen::Matrix2d c = by * hertz.fit.covariance * by.transpose();
  hertz.modulus = {modulus, modulus * std::sqrt(c(0, 0)), dimension::pressure};
  hertz.radius = {radius, std::sqrt(c(1, 1)), dimension::length};
  const double product = std::sqrt(c(0, 0)) * std::sqrt(c(1, 1));
  hertz.correlation = product > 0 ? c(0, 1) / product : 0;
}

/// A contact that begins farther than this from the fitted points, in units of their range, is an
/// extrapolation that they do not support: R, and with it E*, would be arbitrary. (Exact Hertz data
/// with forces between 0.2 and 0.5 of the maximum have q = 2.2.)
constexpr double farthest_contact = 5;

void judge(HertzFit& hertz) {
  const double q = hertz.fit.values[1];
  if (!hertz.fit.usable || (q > 0 && q < farthest_contact)) return;
  hertz.fit.usable = false;
  hertz.fit.reason = fmt::format("the points do not show where contact begins: the fit puts it {:.3g} "
                                 "times their range away", q);
}

Spread spread_about(double value, const std::vector<double>& values) {
  Spread spread{value, value, 0};
  for (const double v : values) {
    spread.least = std::min(spread.least, v);
    spread.greatest = std::max(spread.greatest, v);
    spread.deviation += (v - value) * (v - value) / static_cast<double>(values.size());
  }
  spread.deviation = std::sqrt(spread.deviation);
  return spread;
}

std::vector<HertzSettings> all_settings(Loss loss, HertzWeights weights) {
  std::vector<HertzSettings> all;
  for (const HertzMethod method : {HertzMethod::force, HertzMethod::linear})
    for (const HertzPhase phase : {HertzPhase::loading, HertzPhase::all})
      for (const double least : {0.02, 0.05, 0.1, 0.2})
        for (const double greatest : {0.5, 0.75, 1.0})
          all.push_back({method, phase, least, greatest, loss, weights});
  return all;
}

}  // namespace

std::string_view name(HertzMethod method) {
  return method == HertzMethod::force ? "force" : "linear";
}
std::string_view name(HertzPhase phase) { return phase == HertzPhase::loading ? "loading" : "all"; }

HertzFit fit_hertz(const HertzData& data, const HertzSettings& settings) {
  const auto finite = [](double v) { return std::isfinite(v); };
  if (!std::all_of(data.distance.begin(), data.distance.end(), finite) ||
      !std::all_of(data.force.begin(), data.force.end(), finite))
    throw InputError("Hertz fit: a distance or a force is not finite");
  const double f_max = data.force.empty()
                           ? 0.0
                           : *std::max_element(data.force.begin(), data.force.end());
  HertzFit hertz;
  hertz.settings = settings;
  hertz.points = choose(data, settings, f_max);
  if (hertz.points.size() < 3)
    throw InputError(fmt::format(
        "Hertz fit: {} frames with a force between {:g} and {:g} of its maximum in phase {}; at "
        "least 3 are needed for 2 parameters. Dump more often or widen the range",
        hertz.points.size(), settings.min_force_fraction, settings.max_force_fraction,
        name(settings.phase)));
  Scaled scaled = scale(data, hertz.points, f_max);
  scaled.error = relative_errors(data, hertz.points, settings.weights);
  if (!(scaled.range > 0)) throw InputError("Hertz fit: all points are at the same distance");
  const PointResidual residual = residual_of(scaled, settings.method);
  const std::vector<double> start = straight_line(scaled);
  hertz.fit = solve_least_squares(residual, scaled.x.size(), start,
                                  {settings.loss, loss_scale(scaled, residual, start)});
  judge(hertz);
  physical_parameters(hertz, scaled, data.radius_ratio);
  hertz.rms_residual = rms_force_residual(hertz, scaled);
  return hertz;
}

HertzSpread hertz_spread(const HertzData& data, const HertzFit& chosen) {
  HertzSpread spread;
  std::vector<double> moduli, radii;
  for (const HertzSettings& settings : all_settings(chosen.settings.loss, chosen.settings.weights)) {
    try {
      HertzFit variant = fit_hertz(data, settings);
      if (!variant.fit.usable) continue;
      moduli.push_back(variant.modulus.value);
      radii.push_back(variant.radius.value);
      spread.variants.push_back(std::move(variant));
    } catch (const InputError&) {
      continue;  // too few points within this range: the variant says nothing
    }
  }
  spread.modulus = spread_about(chosen.modulus.value, moduli);
  spread.radius = spread_about(chosen.radius.value, radii);
  return spread;
}

}  // namespace mdana
