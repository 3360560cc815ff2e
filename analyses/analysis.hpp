// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analyses/frame_store.hpp"
#include "analyses/table.hpp"
#include "readers/block.hpp"
#include "readers/bodies.hpp"
#include "readers/columns.hpp"
#include "readers/frame.hpp"
#include "readers/scene.hpp"

namespace mdana {

/// What an analysis reads. The default is nothing.
struct Needs {
  ColumnSet columns;
  bool after_motion = false;  ///< needs the bodies' motion in the frame before its atoms
  bool whole_frame = false;   ///< needs all atoms of the bodies at once: a FrameAnalysis
};

/// A block of atoms with the body and mass of each.
struct LabelledBlock {
  const AtomBlock& atoms;
  std::span<const BodyIndex> body;  ///< 1, 2, ...; 0 for atoms of no body
  std::span<const double> mass;     ///< [mass]
};

struct BodyMotion;

/// The frame that partials are made for.
struct FrameContext {
  const FrameHeader& header;
  std::span<const BodyMotion> motion;  ///< of body 1, 2, ... if Needs::after_motion
};

class Parcel;

/// What an analysis knows of a part of a frame: a monoid. Partials are made for single blocks and
/// merged along one fixed tree over block numbers, so that results depend neither on threads nor on ranks.
class Partial {
 public:
  virtual ~Partial() = default;
  virtual void add(const LabelledBlock& block) = 0;     ///< called once, on a fresh partial
  virtual void merge(const Partial& later) = 0;         ///< with atoms that follow in the file
  virtual void close(std::span<double> row) const = 0;  ///< one value for each column
  /// All that `add` and `merge` change, for a fresh partial of the same frame on another rank; see analyses/parcel.hpp.
  virtual void pass(Parcel& parcel) = 0;
};

/// One measurement on the atoms of each frame; becomes a table with a row a frame.
class Analysis {
 public:
  virtual ~Analysis() = default;
  virtual Needs needs() const = 0;
  virtual std::vector<ColumnSpec> columns() const = 0;
  virtual std::unique_ptr<Partial> begin(const FrameContext& frame) const = 0;
};

/// What an analysis has found for each atom of a frame, on its way to a file. Made on any thread,
/// given on one by one in the order of the frames, then forgotten.
class Product {
 public:
  virtual ~Product() = default;
  virtual void give() = 0;
  /// Instead, to the first rank, for FrameAnalysis::give_sent there: in pieces if it is large.
  virtual void send(const std::function<void(const std::string& bytes)>& to) = 0;
};

/// An analysis that needs neighbours: it sees the atoms of a frame together, in an order that the
/// file's does not change.
class FrameAnalysis : public Analysis {
 public:
  /// Fills the frame's row, in up to `threads` threads. Neither they nor whether the atoms are in memory
  /// change a bit of it. A product may keep the atoms. Nothing is returned if there is nothing to write.
  virtual std::unique_ptr<Product> look(const FrameHeader& header, const FrameStore& atoms, std::size_t threads,
                                        std::span<double> row) const = 0;
  /// Memory for atoms that are looked at together, FrameAtoms included.
  virtual std::size_t bytes_an_atom() const = 0;
  /// Gives a product on that another rank sends; `from` is the next of its pieces.
  virtual void give_sent(const std::function<std::string()>& from) const = 0;

  std::unique_ptr<Partial> begin(const FrameContext&) const final;
};

/// What a member of the list needs to make itself for a run with its default settings.
struct AnalysisSetup {
  const Scene& scene;
  const FrameHeader& first;  ///< columns that there are
};

/// A member of MDANA_ANALYSES in CMakeLists.txt; each defines `extern const AnalysisMember
/// <name>_analysis`.
struct AnalysisMember {
  std::string_view name;
  std::string_view summary;
  std::unique_ptr<Analysis> (*make)(const AnalysisSetup& setup);
};

/// All analyses of this build.
std::span<const AnalysisMember* const> analysis_members();

}  // namespace mdana
