// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/run_figures.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace mdana {
namespace {

std::string axis(const std::string& name, const Run& run, Dimension dimension) {
  return fmt::format("{} [{}]", name, symbol(run.units, dimension));
}

/// The part of a series in which the phase is one of two.
Series phase_series(const ForceCurve& curve, const std::vector<double>& y, Phase first,
                    Phase second, const std::string& label) {
  Series series{label, {}, {}, Series::Style::line, {}};
  for (std::size_t i = 0; i < curve.delta.size(); ++i)
    if (curve.phase[i] == first || curve.phase[i] == second) {
      series.x.push_back(curve.delta[i]);
      series.y.push_back(y[i]);
    }
  return series;
}

/// Frames around the contact: delta above the least value that matters for the figure.
double least_delta_shown(const ForceCurve& curve) {
  double least = curve.delta_max.value;
  for (std::size_t i = 0; i < curve.delta.size(); ++i)
    if (curve.phase[i] == Phase::loading || curve.phase[i] == Phase::unloading)
      least = std::min(least, curve.delta[i]);
  return least - 0.15 * (curve.delta_max.value - least);
}

void crop(Series& series, double least_x) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < series.x.size(); ++i)
    if (series.x[i] >= least_x) {
      x.push_back(series.x[i]);
      y.push_back(series.y[i]);
    }
  series.x = std::move(x);
  series.y = std::move(y);
}

/// The law drawn over the measured range of delta.
Series law_series(const Overlay& overlay, double (*function)(double, const ElasticContact&),
                  double least, double greatest) {
  Series series{std::string(overlay.law->name) == "jkr" ? "JKR" : "Hertz", {}, {},
                Series::Style::dashed, {}};
  const double from = std::max(least, overlay.law->least_delta(overlay.contact));
  constexpr int points = 200;
  for (int i = 0; i <= points; ++i) {
    const double d = from + (greatest - from) * i / points;
    series.x.push_back(d);
    series.y.push_back(function(d, overlay.contact));
  }
  return series;
}

Figure over_delta(const SphereRun& entry, const std::vector<double>& y, const char* what) {
  const ForceCurve& curve = entry.result.curve;
  Figure figure;
  figure.name = what;
  figure.x_name = "delta";
  figure.x_label = axis("mutual approach δ", entry.run, dimension::length);
  figure.series = {phase_series(curve, y, Phase::approach, Phase::loading, "loading"),
                   phase_series(curve, y, Phase::unloading, Phase::separated, "unloading")};
  const double least = least_delta_shown(curve);
  for (Series& s : figure.series) crop(s, least);
  return figure;
}

Figure force_figure(const SphereRun& entry) {
  const ForceCurve& curve = entry.result.curve;
  Figure figure = over_delta(entry, curve.force, "force");
  figure.title = entry.name + ": force between the bodies";
  figure.y_label = axis("force F (repulsive > 0)", entry.run, dimension::force);
  figure.y_name = "F";
  figure.alt = fmt::format("Force against mutual approach: loading up to delta = {:.4g} with F_max = "
                           "{:.4g}, then unloading; the loop encloses {:.4g}.",
                           curve.delta_max.value, curve.force_max.value,
                           curve.hysteresis_area.value);
  if (entry.overlay)
    figure.series.push_back(law_series(*entry.overlay, entry.overlay->law->force,
                                       least_delta_shown(curve), curve.delta_max.value));
  return figure;
}

Figure contact_figure(const SphereRun& entry) {
  const auto a = entry.result.contact_table().column("contact_radius");
  Figure figure = over_delta(entry, {a.begin(), a.end()}, "contact-radius");
  figure.title = entry.name + ": contact radius";
  figure.y_label = axis("contact radius a", entry.run, dimension::length);
  figure.y_name = "a";
  figure.alt = fmt::format("Contact radius against mutual approach, at most {:.4g}.",
                           entry.result.contact.gyration().max.value);
  if (entry.overlay)
    figure.series.push_back(law_series(*entry.overlay, entry.overlay->law->contact_radius,
                                       least_delta_shown(entry.result.curve),
                                       entry.result.curve.delta_max.value));
  return figure;
}

Figure fit_figure(const SphereRun& entry) {
  const HertzFit& fit = entry.result.hertz->fit;
  const ForceCurve& curve = entry.result.curve;
  Series points{"fitted points", {}, {}, Series::Style::points, {}};
  Series line{"Hertz fit", {}, {}, Series::Style::line, {}};
  for (const std::size_t i : fit.points) {
    points.x.push_back(curve.distance[i]);
    points.y.push_back(curve.force[i]);
  }
  const auto [least, most] = std::minmax_element(points.x.begin(), points.x.end());
  const double end = std::max(*most, 2 * fit.radius.value);
  for (int i = 0; i <= 200; ++i) {
    line.x.push_back(*least + (end - *least) * i / 200);
    line.y.push_back(fitted_force(fit, line.x.back()));
  }
  Figure figure;
  figure.name = "fit";
  figure.title = entry.name + ": Hertz fit of the loading phase";
  figure.x_label = axis("distance of the centres X", entry.run, dimension::length);
  figure.y_label = axis("force F", entry.run, dimension::force);
  figure.x_name = "X";
  figure.y_name = "F";
  figure.alt = fmt::format("Force against distance with the fitted Hertz law, E* = {:.4g}, R = {:.5g}.",
                           fit.modulus.value, fit.radius.value);
  figure.series = {points, line};
  return figure;
}

Figure residual_figure(const SphereRun& entry) {
  const HertzFit& fit = entry.result.hertz->fit;
  const ForceCurve& curve = entry.result.curve;
  Series residual{"(F - F_fit)/F_max", {}, {}, Series::Style::points, {}};
  for (const std::size_t i : fit.points) {
    residual.x.push_back(curve.distance[i]);
    residual.y.push_back((curve.force[i] - fitted_force(fit, curve.distance[i])) /
                         curve.force_max.value);
  }
  Figure figure;
  figure.name = "residuals";
  figure.title = entry.name + ": residuals of the Hertz fit";
  figure.x_label = axis("distance of the centres X", entry.run, dimension::length);
  figure.y_label = "residual as a part of F_max";
  figure.x_name = "X";
  figure.y_name = "residual";
  figure.alt = fmt::format("Residuals of the fit against distance; root mean square {:.3g} of F_max.",
                           fit.rms_residual);
  figure.series = {residual};
  return figure;
}

Figure accuracy_figure(const SphereRun& entry) {
  std::map<std::string, Series> by_quantity;
  for (const AccuracyRow& row : entry.accuracy) {
    if (!(row.error > 0) || !std::isfinite(row.error)) continue;
    Series& series = by_quantity[row.quantity];
    series.label = row.quantity;
    series.style = Series::Style::points;
    series.x.push_back(row.cost.seconds);
    series.y.push_back(row.error);
  }
  Figure figure;
  figure.name = "accuracy";
  figure.title = entry.name + ": error against run time";
  figure.x_label = "run time [s]";
  figure.y_label = "relative difference from the reference";
  figure.x_name = "seconds";
  figure.y_name = "error";
  figure.alt = "Error of each published number against run time over frame strides and methods.";
  figure.log_y = true;
  for (auto& [quantity, series] : by_quantity) figure.series.push_back(std::move(series));
  return figure;
}

}  // namespace

std::vector<Figure> run_figures(const SphereRun& entry) {
  std::vector<Figure> figures{force_figure(entry)};
  if (entry.result.touch()) figures.push_back(contact_figure(entry));
  if (entry.result.hertz) {
    figures.push_back(fit_figure(entry));
    figures.push_back(residual_figure(entry));
  }
  if (!entry.accuracy.empty()) figures.push_back(accuracy_figure(entry));
  return figures;
}

}  // namespace mdana
