// SPDX-License-Identifier: GPL-3.0-or-later
// What a 3-D view shows of the defects that were found. Apart from the rest: builds without their analysis have views.
#include <fmt/format.h>

#include "reports/defect_pictures.hpp"
#include "reports/defect_view.hpp"

namespace mdana {
namespace {

const char* colour(PlanarFault kind) {
  switch (kind) {
    case PlanarFault::intrinsic: return "#e8862e";
    case PlanarFault::extrinsic: return "#8a63d2";
    case PlanarFault::twin: return "#3c8fd9";
    case PlanarFault::none: break;
  }
  return "#8c97a1";
}

std::string shown_name(PlanarFault kind) {
  return std::string(name(kind)) + (kind == PlanarFault::twin ? " boundaries" : " faults");
}

void add_if_any(ViewedFrame& frame, ViewedAtoms atoms) {
  if (!atoms.at.empty()) frame.atoms.push_back(std::move(atoms));
}

}  // namespace

ViewedFrame viewed_frame(const FrameDefects& defects, std::string label) {
  ViewedFrame frame{std::move(label), {}, {}, {}};
  const double diameter = 0.8 * defects.spacing;
  ViewedAtoms hcp{"hcp atoms", "#e0574f", diameter, {}}, bulk{"bulk defects", "#c9a227", diameter, {}};
  if (defects.atoms)
    defects.atoms->for_blocks([&](const FrameAtoms& atoms, const AtomLabels& labels) {
      for (std::size_t i = 0; i < atoms.size(); ++i)
        if (labels.structure[i] == Structure::hcp)
          hcp.at.emplace_back(atoms.x[i], atoms.y[i], atoms.z[i]);
        else if (labels.site[i] == Site::bulk_defect)
          bulk.at.emplace_back(atoms.x[i], atoms.y[i], atoms.z[i]);
    });
  add_if_any(frame, std::move(hcp));
  add_if_any(frame, std::move(bulk));
  const PolyData discs = fault_picture(defects.planes);
  for (std::size_t k = 0; k < defects.planes.size(); ++k) {
    const FaultPlane& plane = defects.planes[k];
    ViewedPlane viewed{shown_name(plane.kind), colour(plane.kind), plane.area, {}};
    for (const std::uint32_t corner : discs.polygons[k]) viewed.corners.push_back(discs.points[corner]);
    frame.planes.push_back(std::move(viewed));
  }
  for (const DislocationSegment& s : defects.lines.segments) {
    ViewedLine line = viewed_line(name(s.family), s.points);
    line.burgers = fmt::format("[{:.3g} {:.3g} {:.3g}]", s.burgers.x(), s.burgers.y(), s.burgers.z());
    line.length = s.length.value;
    frame.lines.push_back(std::move(line));
  }
  return frame;
}

}  // namespace mdana
