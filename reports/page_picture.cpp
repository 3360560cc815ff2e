// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/page_picture.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <Eigen/Core>
#include <fmt/format.h>

#include "reports/axis.hpp"
#include "reports/html.hpp"
#include "reports/series_colours.hpp"
#include "reports/thinned_curve.hpp"

namespace mdana {
namespace {

using html::escape;

constexpr double width = 720, height = 460, left = 80, right = 700, bottom = 400;  // pixels
constexpr double title_height = 36, row = 20;                                      // of the legend
constexpr std::size_t most_entries = 16;
constexpr double letter = 7.6;  // about its width

bool compares_runs(const Figure& figure) {
  std::set<std::string> runs;
  for (const Series& s : figure.series)
    if (!s.run.empty()) runs.insert(s.run);
  return runs.size() > 1;
}

/// What a series is told apart by: its run if the figure compares runs, else its label.
const std::string& key(const Series& series, bool runs) {
  return runs && !series.run.empty() ? series.run : series.label;
}

const char* dashes(Series::Style style) {
  switch (style) {
    case Series::Style::dashed: return " stroke-dasharray='7,5'";
    case Series::Style::dotted: return " stroke-dasharray='2,4'";
    case Series::Style::dash_dotted: return " stroke-dasharray='10,4,2,4'";
    default: return "";
  }
}

class Picture {
 public:
  explicit Picture(const Figure& figure)
      : figure_(figure), runs_(compares_runs(figure)), x_(values(&Series::x, nullptr), figure.log_x),
        y_(values(&Series::y, &Series::y_error), figure.log_y) {
    for (const Series& s : figure.series) add_entry(s);
  }

  std::string text() {
    if (x_.empty() || y_.empty()) return {};
    std::string content = legend();  // sets the top
    content = grid() + content;
    for (std::size_t k = 0; k < figure_.series.size(); ++k) content += drawn(figure_.series[k]);
    return fmt::format("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' font-family='Helvetica,Arial,"
                       "sans-serif' font-size='14'>\n<rect width='{0}' height='{1}' fill='#fff'/>\n{2}</svg>\n",
                       width, height, content);
  }

 private:
  std::vector<double> values(std::vector<double> Series::*list, std::vector<double> Series::*error) const {
    std::vector<double> all;
    for (const Series& s : figure_.series)
      for (std::size_t i = 0; i < (s.*list).size(); ++i) {
        if (!std::isfinite(s.x[i]) || !std::isfinite(s.y[i])) continue;
        const double v = (s.*list)[i], e = error && i < (s.*error).size() ? (s.*error)[i] : 0;
        all.insert(all.end(), {v, v - e, v + e});
      }
    return all;
  }

  void add_entry(const Series& series) {
    if (std::find(entries_.begin(), entries_.end(), key(series, runs_)) == entries_.end())
      entries_.push_back(key(series, runs_));
  }

  std::string_view colour(const Series& series) const {
    const auto at = std::find(entries_.begin(), entries_.end(), key(series, runs_)) - entries_.begin();
    return series_colours[static_cast<std::size_t>(at) % series_colours.size()];
  }

  const Series& first_of(const std::string& entry) const {
    return *std::find_if(figure_.series.begin(), figure_.series.end(),
                         [&](const Series& s) { return key(s, runs_) == entry; });
  }

  std::string legend() {
    std::string text = fmt::format("<text x='{}' y='22' text-anchor='middle'>{}</text>\n", (left + right) / 2,
                                   escape(figure_.title));
    double x = left, y = title_height + 4;
    for (std::size_t k = 0; k < std::min(entries_.size(), most_entries); ++k) {
      const double length = 34 + letter * static_cast<double>(entries_[k].size()) + 14;
      if (x > left && x + length > right) x = left, y += row;
      text += sample(first_of(entries_[k]), x, y) +
              fmt::format("<text x='{:.0f}' y='{:.0f}'>{}</text>\n", x + 34, y + 5, escape(entries_[k]));
      x += length;
    }
    for (const auto& [part, style] : parts()) {
      const double length = 34 + letter * static_cast<double>(part.size()) + 14;
      if (x > left && x + length > right) x = left, y += row;
      text += fmt::format("<path fill='none' stroke='#000' stroke-width='2'{} d='M{:.0f},{:.0f}h26'/><text x='{:.0f}' y='{:.0f}'>{}</text>\n",
                          dashes(style), x, y, x + 34, y + 5, escape(part));
      x += length;
    }
    top_ = y + row;
    return text;
  }

  /// Which of the curves of a run a style is of, where runs are compared.
  std::vector<std::pair<std::string, Series::Style>> parts() const {
    std::vector<std::pair<std::string, Series::Style>> all;
    for (const Series& s : figure_.series)
      if (runs_ && !s.part.empty() && std::ranges::find(all, s.part, &std::pair<std::string, Series::Style>::first) == all.end())
        all.emplace_back(s.part, s.style);
    return all;
  }

  std::string stroke(const Series& series) const {
    return fmt::format("fill='none' stroke='{}' stroke-width='2'{}", colour(series), dashes(series.style));
  }

  std::string sample(const Series& series, double x, double y) const {
    if (series.style == Series::Style::points)
      return fmt::format("<circle cx='{:.0f}' cy='{:.0f}' r='3.5' fill='{}'/>\n", x + 14, y, colour(series));
    return fmt::format("<path {} d='M{:.0f},{:.0f}h26'/>\n", stroke(series), x, y);
  }

  Eigen::Vector2d at(double x, double y) const {
    return {left + x_.place(x) * (right - left), bottom - y_.place(y) * (bottom - top_)};
  }

  std::string grid() const {
    std::string lines, words;
    for (const double tick : x_.ticks()) {
      const double x = left + x_.place(tick) * (right - left);
      lines += fmt::format("M{:.1f},{:.1f}V{}", x, top_, bottom + 5);
      words += fmt::format("<text x='{:.1f}' y='{}'>{}</text>", x, bottom + 20, x_.label(tick));
    }
    words = "<g text-anchor='middle'>" + words + fmt::format("<text x='{}' y='{}'>{}</text></g>\n<g text-anchor='end'>",
                                                            (left + right) / 2, bottom + 46, escape(figure_.x_label));
    for (const double tick : y_.ticks()) {
      const double y = bottom - y_.place(tick) * (bottom - top_);
      lines += fmt::format("M{},{:.1f}H{}", left - 5, y, right);
      words += fmt::format("<text x='{}' y='{:.1f}'>{}</text>", left - 9, y + 5, y_.label(tick));
    }
    return fmt::format("<path stroke='#ddd' d='{}'/>\n{}</g>\n<text text-anchor='middle' "
                       "transform='translate(18,{:.0f})rotate(-90)'>{}</text>\n<path fill='none' stroke='#444' d='M{},{:.1f}V{}H{}'/>\n",
                       lines, words, (top_ + bottom) / 2, escape(figure_.y_label), left, top_, bottom, right);
  }

  std::string drawn(const Series& series) const {
    return (series.style == Series::Style::points ? points(series) : curve(series)) + error_bars(series);
  }

  bool holds(const Series& series, std::size_t i) const { return x_.holds(series.x[i]) && y_.holds(series.y[i]); }

  std::string points(const Series& series) const {
    std::string text;
    for (std::size_t i = 0; i < series.x.size(); ++i)
      if (holds(series, i)) {
        const Eigen::Vector2d p = at(series.x[i], series.y[i]);
        text += fmt::format("M{:.1f},{:.1f}h0", p.x(), p.y());  // a round end each
      }
    return fmt::format("<path stroke='{}' stroke-width='7' stroke-linecap='round' d='{}'/>\n", colour(series), text);
  }

  std::string curve(const Series& series) const {
    std::vector<Eigen::Vector2d> piece;
    std::string text;
    for (std::size_t i = 0; i <= series.x.size(); ++i) {
      if (i < series.x.size() && holds(series, i)) {
        piece.push_back(at(series.x[i], series.y[i]));
        continue;
      }
      char command = 'M';
      for (const Eigen::Vector2d& p : thinned_curve(piece, 0.15)) {
        text += fmt::format("{}{:.1f},{:.1f}", command, p.x(), p.y());
        command = 'L';
      }
      piece.clear();
    }
    return fmt::format("<path {} d='{}'/>\n", stroke(series), text);
  }

  std::string error_bars(const Series& series) const {
    std::string text;
    for (std::size_t i = 0; i < series.y_error.size(); ++i) {
      const double low = series.y[i] - series.y_error[i], high = series.y[i] + series.y_error[i];
      if (!holds(series, i) || !(series.y_error[i] > 0) || !y_.holds(high)) continue;
      const Eigen::Vector2d to = at(series.x[i], high);
      const double from = y_.holds(low) ? at(series.x[i], low).y() : bottom;
      text += fmt::format("M{:.1f},{:.1f}V{:.1f}m-4,0h8", to.x(), from, to.y());
      if (y_.holds(low)) text += fmt::format("M{:.1f},{:.1f}h8", to.x() - 4, from);
    }
    if (text.empty()) return text;
    return fmt::format("<path fill='none' stroke='{}' d='{}'/>\n", colour(series), text);
  }

  const Figure& figure_;
  bool runs_;
  Axis x_, y_;
  std::vector<std::string> entries_;  ///< of the legend, each with a colour
  double top_ = title_height;         ///< of the plot
};

}  // namespace

std::string page_picture(const Figure& figure) { return Picture(figure).text(); }

}  // namespace mdana
