// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/compression_study.hpp"
#include "reports/figure.hpp"

namespace mdana {

/// A run of two aggregates in a study: what mdana compress tells of it.
struct AggregateRun {
  std::string name;
  std::filesystem::path dump;
  Run run;
  std::optional<CompressedRun> result;
  std::string failure;  ///< why there is no result
};

/// What the report does not say of aggregates, and why.
inline constexpr std::string_view aggregate_left_out = "contact radius by layers, Hertz and JKR of the whole body, lattice defects";
inline constexpr std::string_view aggregate_reason =
    "an aggregate of grains is no solid sphere and has no lattice; mdana network tells of its contacts";

/// Measures every run; one that fails keeps its reason.
void analyse_aggregates(std::vector<AggregateRun>& runs, const SweepOptions& options,
                        const std::function<void(const std::string&)>& progress);

/// All that were measured, together; nothing if they are fewer than two.
struct AggregatesTogether {
  std::optional<CompressionStudy> study;
  std::string failure;  ///< why they cannot be taken together, else empty
};
AggregatesTogether aggregates_together(const std::vector<AggregateRun>& runs);

/// What a page and results.json say of a run.
Document aggregate_document(const AggregateRun& run);

/// delta and v_rel against time.
std::vector<Figure> aggregate_figures(const AggregateRun& run);

}  // namespace mdana
