// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "analyses/analysis.hpp"
#include "analyses/sweep.hpp"
#include "readers/trajectory.hpp"
#include "tests/contracts/made_up_dump.hpp"
#include "tests/readers/temporary_folder.hpp"

namespace mdana::test {

/// Every analysis of the list with its default settings, motion first as sweep asks for.
inline std::vector<std::unique_ptr<Analysis>> whole_catalogue(const AnalysisSetup& setup) {
  std::vector<std::unique_ptr<Analysis>> analyses;
  for (const bool motion : {true, false})
    for (const AnalysisMember* member : analysis_members())
      if ((member->name == "motion") == motion) analyses.push_back(member->make(setup));
  return analyses;
}

/// Grains cannot be at one place, which atoms can.
inline bool is_of_grains(const std::unique_ptr<Analysis>& analysis) {
  const auto columns = analysis->columns();
  return std::ranges::find(columns, "coordination", &ColumnSpec::name) != columns.end();
}

/// A scene for made-up collisions: two spheres, lengths in units of `length`.
inline Scene made_up_scene(double length = 1) {
  Scene scene;
  scene.radii = {1.0 * length, 1.25 * length};
  scene.sigma = 0.125 * length;
  return scene;
}

inline SweepResult sweep_catalogue(const std::filesystem::path& dump, const Scene& scene,
                                   const SweepOptions& options = {}) {
  const FrameHeader first = first_header(dump);
  const auto analyses = whole_catalogue({scene, first});
  return sweep(dump, find_bodies(dump, first, "type"), Masses::from_column("the dump"), analyses,
               options);
}

inline SweepResult sweep_catalogue(const std::vector<MadeUpFrame>& frames,
                                   const Scene& scene = made_up_scene(),
                                   const SweepOptions& options = {}) {
  const TemporaryFolder folder;
  return sweep_catalogue(folder.write("dump", dump_text(frames)), scene, options);
}

/// Two values of a table agree: both are missing, or within the tolerance.
inline bool agree(double a, double b, double tolerance) {
  return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= tolerance;
}

/// Calls use(column, value in a, value in b) for every number of two results of the same analyses.
template <class Use>
void for_all_values(const SweepResult& a, const SweepResult& b, Use&& use) {
  for (std::size_t k = 0; k < a.tables.size(); ++k)
    for (std::size_t c = 0; c < a.tables[k].columns().size(); ++c)
      for (std::size_t row = 0; row < a.tables[k].rows(); ++row)
        use(a.tables[k].columns()[c], a.tables[k].column(c)[row], b.tables.at(k).column(c)[row]);
}

}  // namespace mdana::test
