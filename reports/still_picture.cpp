// SPDX-License-Identifier: GPL-3.0-or-later
// A frame of a 3-D view as a picture: seen from far away, painted from back to front.
#include <algorithm>
#include <limits>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/defect_view.hpp"
#include "reports/html.hpp"

namespace mdana {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double width = 720, height = 460, margin = 16;  // pixels, above the legend
constexpr double row = 22, letter = 7.6;                  // of the legend, about the width of a letter
constexpr std::size_t most_atoms = 1500;                  // of a kind; beyond it every 2nd, 3rd, ...

/// Where the eye is, as of the page's script.
const Vector3d eye = Vector3d(0.45, -0.8, 0.4).normalized();
const Vector3d right = Vector3d::UnitZ().cross(eye).normalized();
const Vector3d up = eye.cross(right);

Vector2d seen(const Vector3d& point) { return {point.dot(right), point.dot(up)}; }

/// Scale and shift of the seen plane to the picture.
class Paper {
 public:
  explicit Paper(const ViewedFrame& frame) {
    for (const ViewedAtoms& a : frame.atoms) add(a.at);
    for (const ViewedLine& l : frame.lines) add(l.at);
    for (const ViewedPlane& p : frame.planes) add(p.corners);
    if (box_.isEmpty()) return;
    const Vector2d size = box_.sizes();
    scale_ = std::min((width - 2 * margin) / std::max(size.x(), 1e-12 * size.norm()),
                      (height - 2 * margin) / std::max(size.y(), 1e-12 * size.norm()));
    if (!(scale_ < 1e300)) scale_ = 1;
  }

  double scale() const { return scale_; }
  Vector2d at(const Vector3d& point) const {
    const Vector2d from = scale_ * (seen(point) - box_.center());
    return {width / 2 + from.x(), height / 2 - from.y()};
  }

 private:
  void add(const std::vector<Vector3d>& points) {
    for (const Vector3d& p : points) box_.extend(seen(p));
  }
  Eigen::AlignedBox2d box_;
  double scale_ = 1;  ///< pixels a length
};

struct Shape {
  double nearness;
  std::string svg;
};

std::string corners(const std::vector<Vector3d>& points, const Paper& paper) {
  std::string text;
  for (const Vector3d& p : points) {
    const Vector2d at = paper.at(p);
    text += fmt::format("{:.1f},{:.1f} ", at.x(), at.y());
  }
  return text;
}

double nearness(const std::vector<Vector3d>& points) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& p : points) sum += p;
  return sum.dot(eye) / static_cast<double>(std::max<std::size_t>(points.size(), 1));
}

/// The disc that the atoms of a kind use.
std::string disc(const ViewedAtoms& atoms, std::size_t kind, const Paper& paper) {
  return fmt::format("<circle id='a{}' r='{:.1f}' fill='{}'/>\n", kind, std::max(0.5 * atoms.diameter * paper.scale(), 1.0),
                     atoms.colour);
}

void add_atoms(std::vector<Shape>& shapes, const ViewedAtoms& atoms, std::size_t kind, const Paper& paper) {
  const std::size_t stride = 1 + atoms.at.size() / most_atoms;
  for (std::size_t i = 0; i < atoms.at.size(); i += stride) {
    const Vector2d at = paper.at(atoms.at[i]);
    shapes.push_back({atoms.at[i].dot(eye), fmt::format("<use href='#a{}' x='{:.0f}' y='{:.0f}'/>\n", kind, at.x(), at.y())});
  }
}

/// Points of a line that are far enough from the one before to be seen; the last one always.
std::vector<Vector3d> seen_points(const ViewedLine& line, const Paper& paper) {
  constexpr double least = 4;  // pixels
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < line.at.size(); ++i)
    if (points.empty() || i + 1 == line.at.size() || (paper.at(line.at[i]) - paper.at(points.back())).norm() >= least)
      points.push_back(line.at[i]);
  return points;
}

/// Piece by piece, since a line can pass both before and behind something; a guide is behind all.
void add_line(std::vector<Shape>& shapes, const ViewedLine& line, const Paper& paper) {
  if (line.guide)
    shapes.push_back({-std::numeric_limits<double>::infinity(),
                      fmt::format("<polyline points='{}' fill='none' stroke='{}' stroke-width='1'/>\n",
                                  corners(line.at, paper), line.colour)});
  if (line.guide) return;
  const std::vector<Vector3d> points = seen_points(line, paper);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vector2d from = paper.at(points[i]), to = paper.at(points[i + 1]) - from;
    shapes.push_back({nearness({points[i], points[i + 1]}),
                      fmt::format("<path class='l' stroke='{}' d='M{:.0f},{:.0f}l{:.0f},{:.0f}'/>\n", line.colour, from.x(), from.y(),
                                  to.x(), to.y())});
  }
}

std::vector<Shape> shapes_of(const ViewedFrame& frame, const Paper& paper) {
  std::vector<Shape> shapes;
  for (std::size_t k = 0; k < frame.atoms.size(); ++k) add_atoms(shapes, frame.atoms[k], k, paper);
  for (const ViewedPlane& p : frame.planes)
    shapes.push_back({nearness(p.corners),
                      fmt::format("<polygon points='{}' fill='{}' fill-opacity='0.45' stroke='{}'/>\n",
                                  corners(p.corners, paper), p.colour, p.colour)});
  for (const ViewedLine& l : frame.lines) add_line(shapes, l, paper);
  std::stable_sort(shapes.begin(), shapes.end(),
                   [](const Shape& a, const Shape& b) { return a.nearness < b.nearness; });
  return shapes;
}

/// Names and colours of what is drawn, each once: atoms, planes, lines.
std::vector<std::pair<std::string, std::string>> entries_of(const ViewedFrame& frame) {
  std::vector<std::pair<std::string, std::string>> entries;
  const auto add = [&](const auto& list) {
    for (const auto& thing : list)
      if (std::ranges::find(entries, thing.name, &std::pair<std::string, std::string>::first) == entries.end())
        entries.emplace_back(thing.name, thing.colour);
  };
  add(frame.atoms);
  add(frame.planes);
  add(frame.lines);
  return entries;
}

struct Legend {
  std::string svg;
  double height = 0;  ///< [pixels]
};

Legend legend_of(const ViewedFrame& frame) {
  Legend legend{"", row};
  double x = margin;
  for (const auto& [name, colour] : entries_of(frame)) {
    const double length = 36 + letter * static_cast<double>(name.size());
    if (x > margin && x + length > width) x = margin, legend.height += row;
    legend.svg += fmt::format("<path stroke='{}' stroke-width='8' d='M{:.0f},{:.0f}h14'/><text x='{:.0f}' y='{:.0f}'>{}</text>\n",
                              colour, x, height + legend.height - row / 2, x + 20, height + legend.height - row / 2 + 5,
                              html::escape(name));
    x += length;
  }
  return legend;
}

}  // namespace

std::string still_picture(const ViewedFrame& frame) {
  const Paper paper(frame);
  const Legend legend = legend_of(frame);
  std::string text = fmt::format("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1:.0f}' font-family='Helvetica,"
                                 "Arial,sans-serif' font-size='14'>\n<rect width='{0}' height='{1:.0f}' fill='#ffffff'/>\n<style>.l{{stroke-width:3;stroke-linecap:round}}</style><defs>\n",
                                 width, height + legend.height + 8);
  for (std::size_t k = 0; k < frame.atoms.size(); ++k) text += disc(frame.atoms[k], k, paper);
  text += "</defs>\n<g stroke='#333333' stroke-width='0.4'>\n";
  for (const Shape& shape : shapes_of(frame, paper)) text += shape.svg;
  return text + "</g>\n" + legend.svg + "</svg>\n";
}

}  // namespace mdana
