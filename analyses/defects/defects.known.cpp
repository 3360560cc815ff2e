// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects.hpp"

#include <cmath>
#include <numbers>

#include "readers/known_answer.hpp"

namespace mdana {

std::vector<KnownAnswer> defects_known();

namespace {

/// Close-packed layers along z, nearest neighbours 1 apart: `stacking` names their places, as "ABCABC".
/// Each layer is a hexagon of 3 n (n + 1) + 1 atoms.
std::shared_ptr<FrameAtoms> stacked(std::string_view stacking, int n) {
  const auto atoms = std::make_shared<FrameAtoms>();
  const double height = std::sqrt(2.0 / 3), row = std::sqrt(3.0) / 2;
  for (std::size_t layer = 0; layer < stacking.size(); ++layer) {
    const int shift = stacking[layer] - 'A';
    for (int i = -n; i <= n; ++i)
      for (int k = -n; k <= n; ++k) {
        if (std::abs(i + k) > n) continue;
        atoms->x.push_back(i + 0.5 * k + 0.5 * shift);
        atoms->y.push_back(row * k + row / 3 * shift);
        atoms->z.push_back(height * static_cast<double>(layer));
        atoms->body.push_back(1);
      }
  }
  return atoms;
}

struct Seen {
  double fcc, hcp, fault_area, twin_area;
};

Seen seen(std::string_view stacking, int n) {
  DefectSettings settings;
  settings.ids = false;
  const auto analysis = make_defects(settings);
  std::vector<double> row(analysis->columns().size());
  dynamic_cast<const FrameAnalysis&>(*analysis).look({}, FrameStore(stacked(stacking, n)), 1, row);
  Table table(analysis->columns());
  table.add_row(row);
  const auto value = [&](const char* name) { return table.column(name)[0]; };
  return {value("fcc"), value("hcp"), value("fault_area"), value("twin_area")};
}

}  // namespace

std::vector<KnownAnswer> defects_known() {
  // A layer has 3 n (n + 1) + 1 atoms of area sqrt(3)/2, whole positions in single precision.
  const double layer = std::sqrt(3.0) / 2 * (3 * 10 * 11 + 1);
  const Seen intrinsic = seen("ABCABCBCABCA", 10), extrinsic = seen("ABCABCBABCABC", 10),
             twin = seen("ABCABCBACBA", 10);
  return {{"hcp atoms of a crystal without a fault", seen("ABCABCABC", 6).hcp, 0, 16},
          {"twin area of an intrinsic fault", intrinsic.twin_area, 0, 16},
          {"area of an intrinsic fault", intrinsic.fault_area, layer, 7},
          {"area of an extrinsic fault", extrinsic.fault_area, layer, 7},
          {"fault area of a twin", twin.fault_area, 0, 16},
          {"area of a twin", twin.twin_area, layer, 7}};
}

}  // namespace mdana
