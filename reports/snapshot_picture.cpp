// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots on a sheet of 720 pixels width: as SVG of few bytes an atom, and as a script for gnuplot.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "reports/atomic_file.hpp"
#include "reports/csv.hpp"
#include "reports/figure.hpp"
#include "reports/html.hpp"
#include "reports/snapshots.hpp"

namespace mdana {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double width = 720, head = 100, foot = 36, gap = 14;  // pixels
constexpr double most_height = 420;                            // of a panel
constexpr double grid = 0.2;                                   // pixels, to which places are rounded
constexpr double points_a_pixel = 16 / 2.54 * 72 / width;      // of the PDF, 16 cm wide
constexpr std::size_t layers = 4;  // of the slice, painted one after the other: few atoms of a layer hide each other

struct Look {
  const char *fill, *edge, *light;
};
constexpr Look looks[2] = {{"#3C93CC", "#0B3F66", "#A9D3EE"}, {"#E8A33A", "#7A4A00", "#F8DDA8"}};

/// 1, 2 or 5 times a power of ten, at most `length`.
double round_length(double length) {
  const double power = std::pow(10, std::floor(std::log10(length)));
  return power * (length >= 5 * power ? 5 : length >= 2 * power ? 2 : 1);
}

/// Where on the sheet things are.
class Sheet {
 public:
  explicit Sheet(const SnapshotFigure& figure) : panel_(width / static_cast<double>(figure.snapshots.size())) {
    double wide = 0;
    const auto reach = [&](double x, double y, double half) {
      wide = std::max(wide, std::abs(x));
      low_ = std::min(low_, y - half);
      high_ = std::max(high_, y + half);
    };
    for (const Snapshot& s : figure.snapshots)
      for (const std::size_t body : {0, 1}) {
        for (const Vector3d& p : s.at[body]) reach(std::abs(p.x()) + 0.5 * s.diameter, p.y(), 0.5 * s.diameter);
        for (const Strip& p : s.strips[body]) reach(std::max(-p.from, p.to), p.height, 0.5 * s.row);
      }
    if (high_ > low_) scale_ = std::min((panel_ - gap) / (2 * wide), most_height / (high_ - low_));
    bar_ = round_length(0.6 * (panel_ - gap) / scale_);
  }

  double height() const { return head + scale_ * (high_ - low_) + foot; }
  double scale() const { return scale_; }  ///< pixels a length
  double bar() const { return bar_; }      ///< [length]
  double middle(std::size_t panel) const { return (static_cast<double>(panel) + 0.5) * panel_; }
  Vector2d at(std::size_t panel, const Vector3d& p) const {
    return {middle(panel) + scale_ * p.x(), head + scale_ * (high_ - p.y())};
  }

 private:
  double panel_;
  double low_ = 0, high_ = 0, scale_ = 1, bar_ = 1;
};

std::string panel_title(const SnapshotFigure& figure, std::size_t panel) {
  return fmt::format("({}) {}", static_cast<char>('a' + panel), figure.snapshots[panel].label);
}

std::string bar_text(const SnapshotFigure& figure, const Sheet& sheet) {
  return fmt::format("{:g} {}", sheet.bar(), symbol(figure.units, dimension::length));
}

/// A point for each place, by rows, with moves relative to the one before.
std::string dots(std::vector<Vector2d> places) {
  std::vector<std::array<long, 2>> grid_places;
  for (const Vector2d& p : places) grid_places.push_back({std::lround(p.y() / grid), std::lround(p.x() / grid)});
  std::ranges::sort(grid_places);
  std::string text;
  std::array<long, 2> last{0, 0};
  for (const auto& [y, x] : grid_places) {
    text += fmt::format("m{}{}{}h0", x - last[1], y < last[0] ? "" : " ", y - last[0]);
    last = {y, x};
  }
  return text;
}

std::size_t layer_of(const Snapshot& snapshot, const Vector3d& p) {
  const double from_below = p.z() / snapshot.diameter + 0.5;
  return static_cast<std::size_t>(std::clamp(from_below, 0.0, 0.999) * layers);
}

/// Where on the sheet the atoms of a body in a layer are, of all panels.
std::vector<Vector2d> places_in(const SnapshotFigure& figure, const Sheet& sheet, std::size_t body, std::size_t layer) {
  std::vector<Vector2d> places;
  for (std::size_t panel = 0; panel < figure.snapshots.size(); ++panel)
    for (const Vector3d& p : figure.snapshots[panel].at[body])
      if (layer_of(figure.snapshots[panel], p) == layer) places.push_back(sheet.at(panel, p));
  return places;
}

/// Edges, discs and a light on each.
std::string discs(const SnapshotFigure& figure, const Sheet& sheet, std::size_t body, std::size_t layer) {
  const double size = sheet.scale() * figure.snapshots.front().diameter / grid;
  const auto use = [&](const char* colour, double share, double shift) {
    return fmt::format("<use href='#b{}{}' stroke='{}' stroke-width='{:.1f}' x='{:.1f}' y='{:.1f}'/>\n", body, layer, colour,
                       share * size, -shift * size, -shift * size);
  };
  const Look& look = looks[body];
  return fmt::format("<defs><path id='b{}{}' d='{}'/></defs>\n", body, layer, dots(places_in(figure, sheet, body, layer))) +
         use(look.edge, 1, 0) + use(look.fill, 0.84, 0) + use(look.light, 0.3, 0.13);
}

std::string strips(const SnapshotFigure& figure, const Sheet& sheet, std::size_t body) {
  std::string text;
  for (std::size_t panel = 0; panel < figure.snapshots.size(); ++panel)
    for (const Strip& strip : figure.snapshots[panel].strips[body]) {
      const Vector2d from = sheet.at(panel, {strip.from, strip.height, 0}) / grid;
      text += fmt::format("M{:.0f} {:.0f}h{:.0f}", from.x(), from.y(), sheet.scale() * (strip.to - strip.from) / grid);
    }
  return fmt::format("<path stroke='{}' stroke-linecap='butt' stroke-width='{:.1f}' d='{}'/>\n", looks[body].fill,
                     sheet.scale() * figure.snapshots.front().row / grid + 1, text);  // no light between the rows
}

std::string words(const SnapshotFigure& figure, const Sheet& sheet) {
  std::string text = fmt::format("<text x='{}' y='20'>{}</text>\n", width / 2, html::escape(figure.title));
  for (std::size_t body = 0; body < 2; ++body)
    text += fmt::format("<circle cx='{0}' cy='42' r='6' fill='{1}' stroke='{2}'/><text x='{3}' y='47'>body {4}</text>\n",
                        width / 2 - 76 + 96 * static_cast<double>(body), looks[body].fill, looks[body].edge,
                        width / 2 - 38 + 96 * static_cast<double>(body), body + 1);
  for (std::size_t panel = 0; panel < figure.snapshots.size(); ++panel)
    text += fmt::format("<text x='{0:.0f}' y='73' font-weight='bold'>{1}</text><text x='{0:.0f}' y='92' font-size='15'>{2}</text>\n",
                        sheet.middle(panel), html::escape(panel_title(figure, panel)),
                        html::escape(moment(figure.snapshots[panel], figure.units)));
  const double length = sheet.scale() * sheet.bar(), y = sheet.height() - 12;
  text += fmt::format("<path stroke='#000' stroke-width='3' d='M{:.1f},{:.1f}h{:.1f}'/>", sheet.middle(0) - length / 2, y, length);
  return text + fmt::format("<text x='{:.0f}' y='{:.0f}' text-anchor='start'>{}</text>\n", sheet.middle(0) + length / 2 + 8, y + 5,
                            html::escape(bar_text(figure, sheet)));
}

bool in_rows(const SnapshotFigure& figure) { return figure.snapshots.front().row > 0; }

/// Centre and half sides of strips in pixels from below, as gnuplot data $b1 and $b2.
std::string strip_data(const SnapshotFigure& figure, const Sheet& sheet, std::size_t body) {
  std::string text = fmt::format("$b{} << EOD\n", body + 1);
  for (std::size_t panel = 0; panel < figure.snapshots.size(); ++panel) {
    const Snapshot& s = figure.snapshots[panel];
    for (const Strip& strip : s.strips[body]) {
      const Vector2d p = sheet.at(panel, {0.5 * (strip.from + strip.to), strip.height, 0});
      text += fmt::format("{:.2f} {:.2f} {:.2f} {:.2f}\n", p.x(), sheet.height() - p.y(),
                          0.5 * sheet.scale() * (strip.to - strip.from), 0.5 * sheet.scale() * s.row);
    }
  }
  return text + "EOD\n";
}

/// Centres of atoms, likewise, as $b10, $b11 ... by body and layer.
std::string disc_data(const SnapshotFigure& figure, const Sheet& sheet, std::size_t body, std::size_t layer) {
  std::string text = fmt::format("$b{}{} << EOD\n", body + 1, layer);
  for (const Vector2d& p : places_in(figure, sheet, body, layer)) text += fmt::format("{:.2f} {:.2f}\n", p.x(), sheet.height() - p.y());
  return text + "EOD\n";
}

std::string script_data(const SnapshotFigure& figure, const Sheet& sheet) {
  if (in_rows(figure)) return strip_data(figure, sheet, 0) + strip_data(figure, sheet, 1);
  std::string text;
  for (std::size_t k = 0; k < 2 * layers; ++k) text += disc_data(figure, sheet, k % 2, k / 2);
  return text;
}

/// What gnuplot plots. A point of size 1 has a radius of 3 points in a PDF.
std::string plotted(const SnapshotFigure& figure, const Sheet& sheet) {
  std::string text;
  const auto add = [&](const std::string& clause) { text += (text.empty() ? "plot " : ", \\\n     ") + clause; };
  if (in_rows(figure)) {
    for (const int body : {0, 1})
      add(fmt::format("$b{} using 1:2:3:4 with boxxyerror fc rgb '{}' fs solid noborder", body + 1, looks[body].fill));
    return text + "\n";
  }
  const double size = 0.5 * sheet.scale() * figure.snapshots.front().diameter * points_a_pixel / 3;
  for (std::size_t k = 0; k < 2 * layers; ++k)
    for (const auto& [colour, share] : {std::pair{looks[k % 2].edge, 1.0}, {looks[k % 2].fill, 0.84}})
      add(fmt::format("$b{}{} using 1:2 with points pt 7 ps {:.4f} lc rgb '{}'", k % 2 + 1, k / 2, share * size, colour));
  return text + "\n";
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : c == '\n' ? " " : std::string(1, c);
  return result + "'";
}

std::string label(const std::string& text, double x, double y, const char* how) {
  return fmt::format("set label {} at {:.1f},{:.1f} {}\n", quoted(text), x, y, how);
}

std::string script_labels(const SnapshotFigure& figure, const Sheet& sheet) {
  const double top = sheet.height(), length = sheet.scale() * sheet.bar();
  std::string text = label(figure.title, width / 2, top - 16, "center");
  for (std::size_t panel = 0; panel < figure.snapshots.size(); ++panel)
    text += label(panel_title(figure, panel), sheet.middle(panel), top - 66, "center") +
            label(moment(figure.snapshots[panel], figure.units), sheet.middle(panel), top - 86, "center");
  for (int body = 0; body < 2; ++body)
    text += label(fmt::format("body {}", body + 1), width / 2 - 58 + 90 * body, top - 40, "left") +
            fmt::format("set object circle at {:.1f},{:.1f} size 6 fc rgb '{}' fs solid border lc rgb '{}'\n",
                        width / 2 - 74 + 90 * body, top - 40, looks[body].fill, looks[body].edge);
  text += fmt::format("set arrow from {:.1f},12 to {:.1f},12 nohead lw 3\n", sheet.middle(0) - length / 2, sheet.middle(0) + length / 2);
  return text + label(bar_text(figure, sheet), sheet.middle(0) + length / 2 + 8, 12, "left");
}

/// Writes NAME.pdf.
std::string script(const SnapshotFigure& figure) {
  const Sheet sheet(figure);
  std::string text = fmt::format("# gnuplot {0}.gp writes {0}.pdf\nset encoding utf8\nset termoption noenhanced\n", figure.name);
  text += script_data(figure, sheet) + script_labels(figure, sheet);
  return text + fmt::format("unset key\nunset border\nunset tics\nset lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n"
                            "set xrange [0:{}]\nset yrange [0:{:.1f}]\n"
                            "set terminal pdfcairo size 16cm,{:.2f}cm noenhanced font 'Helvetica,9'\nset output {}\n",
                            width, sheet.height(), 16 * sheet.height() / width, quoted(figure.name + ".pdf")) +
         plotted(figure, sheet);
}

}  // namespace

std::string snapshot_picture(const SnapshotFigure& figure) {
  if (figure.snapshots.empty()) return {};
  const Sheet sheet(figure);
  std::string text = fmt::format("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1:.0f}' font-family='Helvetica,"
                                 "Arial,sans-serif' font-size='16' text-anchor='middle'>\n<rect width='{0}' height='{1:.0f}' "
                                 "fill='#fff'/>\n<g fill='none' stroke-linecap='round' transform='scale({2})'>\n",
                                 width, sheet.height(), grid);
  for (const std::size_t body : {0, 1})
    if (in_rows(figure)) text += strips(figure, sheet, body);
  for (std::size_t k = 0; k < 2 * layers && !in_rows(figure); ++k) text += discs(figure, sheet, k % 2, k / 2);
  return text + "</g>\n" + words(figure, sheet) + "</svg>\n";
}

void draw(const SnapshotFigure& figure, const std::filesystem::path& directory) {
  write_file(directory / (figure.name + ".svg"), snapshot_picture(figure));
  write_file(directory / (figure.name + ".csv"), to_csv(snapshot_table(figure)));
  write_file(directory / (figure.name + ".gp"), script(figure));
  run_gnuplot(directory, figure.name);
}

}  // namespace mdana
