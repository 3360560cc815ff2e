// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "analyses/defects.hpp"

namespace mdana {

/// What a 3-D view shows of a frame; all positions [length].
struct ViewedAtoms {
  std::string name, colour;  ///< of their kind; "#rrggbb"
  double diameter = 1;       ///< [length]
  std::vector<Eigen::Vector3d> at;
};
struct ViewedLine {
  std::string name, colour;
  std::string burgers;  ///< vector, as text; may be empty
  double length = 0;    ///< [length]; 0: not told
  std::vector<Eigen::Vector3d> at;
  bool guide = false;   ///< thin, for the eye only
};
struct ViewedPlane {
  std::string name, colour;
  double area = 0;  ///< [length^2]
  std::vector<Eigen::Vector3d> corners;
};
struct ViewedFrame {
  std::string label;
  std::vector<ViewedAtoms> atoms;
  std::vector<ViewedLine> lines;
  std::vector<ViewedPlane> planes;
  std::size_t one_of = 1;  ///< atoms: so many of them for each that is left
  std::size_t dropped = 0; ///< lines and planes, the shortest and smallest
};

/// Chosen frames of a run in three dimensions.
struct DefectView {
  std::string name;  ///< unlike those of the other views of a page: letters, digits, '-' and '_'
  std::string title, alt;
  std::string unit;  ///< of length
  std::vector<ViewedFrame> frames;
  std::size_t shown = 0;  ///< the frame that is seen first, and that the still picture is of
};

/// A dislocation with the colour of its family: perfect blue, Shockley green, stair-rod magenta, Hirth
/// yellow, Frank cyan, any other red.
ViewedLine viewed_line(std::string_view family, std::vector<Eigen::Vector3d> at);

/// Two great circles through the poles of a sphere, as guides.
std::vector<ViewedLine> viewed_sphere(const std::string& name, const Eigen::Vector3d& centre, double radius,
                                      const Eigen::Vector3d& pole);

/// hcp atoms and bulk defects (if there are labels), fault planes and dislocation lines of a frame.
ViewedFrame viewed_frame(const FrameDefects& defects, std::string label);

/// How much of a frame is shown.
struct ViewLimits {
  std::size_t atoms, lines, planes;
};
/// Every 2nd, 3rd, ... atom of each kind, the first lines and planes, and all guides, which the label says.
void limit(ViewedFrame& frame, const ViewLimits& most);
std::string shown_label(const ViewedFrame& frame);

/// {title, alt, unit, shown, frames: [{label, atoms: [{name, colour, diameter, at}], lines: [{name, colour, burgers,
/// length, at, guide}], planes: [{name, colour, area, at}]}]}; `at` is {origin: [x, y, z], step, int16: base64 of
/// little-endian (at - origin)/step, three an atom, corner or point}.
nlohmann::ordered_json view_json(const DefectView& view);

/// The frame seen as the view is at first, as SVG.
std::string still_picture(const ViewedFrame& frame);

/// The view for a page: a still picture of the frame seen first, caption and, where the page has a script, its
/// data as the block scene-NAME.
std::string live_view(const DefectView& view);

}  // namespace mdana
