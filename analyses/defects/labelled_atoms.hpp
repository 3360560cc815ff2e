// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "analyses/defects.hpp"
#include "analyses/defects/labels.hpp"

namespace mdana::defects {

/// Collects atoms and labels of slab after slab: in memory if the frame is one slab, else in a temporary
/// file of 64 bytes an atom.
class LabelCollector {
 public:
  virtual ~LabelCollector() = default;
  /// Labels by place; the pieces of ClusterFinder stand for the clusters.
  virtual void add(const Sites& sites, AtomLabels labels) = 0;
  /// `numbers` of the clusters by piece.
  virtual std::shared_ptr<const LabelledAtoms> finish(std::vector<std::uint32_t> numbers) = 0;
};

std::shared_ptr<LabelCollector> collect_labels(const FrameStore& frame);

}  // namespace mdana::defects
