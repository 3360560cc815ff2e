// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fits/force_law.hpp"
#include "reports/accuracy.hpp"
#include "reports/analysed_run.hpp"
#include "reports/figure.hpp"
#include "reports/stability.hpp"

namespace mdana {

/// A contact law drawn over the measured curves.
struct Overlay {
  const ForceLaw* law = nullptr;
  ElasticContact contact;
  std::string source;  ///< where its constants come from
};

/// A measured run of two spheres, and what it is drawn with.
struct SphereRun {
  std::string name;
  const Run& run;
  AnalysedRun result;
  std::optional<Overlay> overlay = {};
  std::vector<AccuracyRow> accuracy = {};
  std::vector<StabilityRow> stability = {};
};

/// The figures of a run: force loop with overlay, contact radius with overlay and, for a Hertz scene, the
/// fit and its residuals; error of each published number against run time, if that was looked at. Their names do
/// not tell the run.
std::vector<Figure> run_figures(const SphereRun& entry);

}  // namespace mdana
