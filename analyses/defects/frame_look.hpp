// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "analyses/defects.hpp"
#include "analyses/defects/clusters.hpp"
#include "analyses/defects/frame_shape.hpp"
#include "analyses/defects/labelled_atoms.hpp"
#include "analyses/defects/lattice.hpp"
#include "analyses/defects/lines/line_finder.hpp"
#include "analyses/defects/planes.hpp"
#include "analyses/defects/surface.hpp"

namespace mdana::defects {

/// Mean place of some atoms. The sum is one of whole numbers: it does not depend on their order.
class ExactMean {
 public:
  explicit ExactMean(const CellSpace& space) : space_(space) {}
  void add(const Eigen::Vector3d& at);
  Eigen::Vector3d mean() const;  ///< [length]; zeros without atoms

 private:
  const CellSpace& space_;
  std::array<std::int64_t, 3> high_{};   ///< of 2^-8 spacings
  std::array<std::uint64_t, 3> low_{};   ///< of 2^-40 spacings
  std::uint64_t count_ = 0;
};

/// A slab with what is known of its atoms.
struct LabelledSlab {
  LabelledSlab(Slab of, const CellSpace& space, const DefectSettings& settings, std::size_t threads);

  Slab slab;
  CellGrid grid;
  SearchMaker search;
  Sites sites;
  std::size_t repaired;
  OtherStructures others;
};

/// The look at a frame, slab by slab: one if it is in memory.
class FrameLook {
 public:
  FrameLook(const DefectSettings& settings, const FrameHeader& header, const FrameStore& frame, std::size_t threads);

  /// Fills the row in the order of the columns; what else was found.
  FrameDefects fill(std::span<double> row);

 private:
  struct Counts {
    std::array<std::size_t, 5> structure{};  ///< by Structure
    std::array<std::size_t, 4> site{};       ///< by Site
    std::size_t repaired = 0, bcc = 0, ico = 0;
  };

  void look_at(const LabelledSlab& slab);
  void find_lines(const Slabs& slabs, FrameDefects& found);
  void count(const Sites& sites);
  AtomLabels labels(const Sites& sites);
  // Each fills a part of the row and gives the place behind it.
  double* put_counts(double* next) const;
  double* put_lattices(double* next) const;
  double* put_surfaces(const BodySurfaces& surfaces, double* next) const;

  const DefectSettings& settings_;
  const FrameHeader& header_;
  const FrameStore& frame_;
  std::size_t threads_;
  FrameShape shape_;
  CellSpace space_;
  Counts counts_;
  ExactMean defects_;
  FaultFinder faults_;
  std::array<LatticeSample, 2> lattices_;
  SurfaceFinder surfaces_;
  LineFinder lines_;
  ClusterFinder clusters_;
  std::shared_ptr<LabelCollector> labels_;  ///< if they are asked for
  std::unique_ptr<LabelledSlab> whole_;     ///< the frame if it is in memory and lines are asked for
};

}  // namespace mdana::defects
