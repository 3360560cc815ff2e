// SPDX-License-Identifier: GPL-3.0-or-later
// A frame of a 3-D view as a picture: seen from far away, painted from back to front.
#include <algorithm>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/defect_view.hpp"

namespace mdana {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double width = 720, height = 460, margin = 16;  // pixels
constexpr std::size_t most_atoms = 4000;                  // of a kind; beyond it every 2nd, 3rd, ...

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

void add_atoms(std::vector<Shape>& shapes, const ViewedAtoms& atoms, const Paper& paper) {
  const std::size_t stride = 1 + atoms.at.size() / most_atoms;
  for (std::size_t i = 0; i < atoms.at.size(); i += stride) {
    const Vector2d at = paper.at(atoms.at[i]);
    shapes.push_back({atoms.at[i].dot(eye),
                      fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='{:.1f}' fill='{}'/>\n", at.x(), at.y(),
                                  std::max(0.5 * atoms.diameter * paper.scale(), 1.0), atoms.colour)});
  }
}

/// Piece by piece, since a line can pass both before and behind something.
void add_line(std::vector<Shape>& shapes, const ViewedLine& line, const Paper& paper) {
  for (std::size_t i = 0; i + 1 < line.at.size(); ++i) {
    const std::vector<Vector3d> piece{line.at[i], line.at[i + 1]};
    shapes.push_back({nearness(piece), fmt::format("<polyline points='{}' stroke='{}' stroke-width='3' "
                                                   "stroke-linecap='round'/>\n", corners(piece, paper), line.colour)});
  }
}

std::vector<Shape> shapes_of(const ViewedFrame& frame) {
  const Paper paper(frame);
  std::vector<Shape> shapes;
  for (const ViewedAtoms& atoms : frame.atoms) add_atoms(shapes, atoms, paper);
  for (const ViewedPlane& p : frame.planes)
    shapes.push_back({nearness(p.corners),
                      fmt::format("<polygon points='{}' fill='{}' fill-opacity='0.45' stroke='{}'/>\n",
                                  corners(p.corners, paper), p.colour, p.colour)});
  for (const ViewedLine& l : frame.lines) add_line(shapes, l, paper);
  return shapes;
}

}  // namespace

std::string still_picture(const ViewedFrame& frame) {
  std::vector<Shape> shapes = shapes_of(frame);
  std::stable_sort(shapes.begin(), shapes.end(),
                   [](const Shape& a, const Shape& b) { return a.nearness < b.nearness; });
  std::string text = fmt::format("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}'>\n"
                                 "<rect width='{0}' height='{1}' fill='#ffffff'/>\n<g stroke='#333333' "
                                 "stroke-width='0.4'>\n", width, height);
  for (const Shape& shape : shapes) text += shape.svg;
  return text + "</g>\n</svg>\n";
}

}  // namespace mdana
