// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "analyses/analysis.hpp"
#include "analyses/box_centres.hpp"
#include "readers/masses.hpp"
#include "readers/selection.hpp"

namespace mdana {

/// The sweep was stopped by a signal.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(int number)
      : std::runtime_error("stopped by a signal"), signal(number) {}
  int signal;
};

/// What is done to every frame of a sweep.
struct FramePlan {
  FramePlan(const Bodies& of_bodies, const Masses& of_masses,
            std::span<const std::unique_ptr<Analysis>> all, const std::optional<Selection>& selection = {});

  const Bodies& bodies;
  const Masses& masses;
  std::span<const std::unique_ptr<Analysis>> analyses;
  std::unique_ptr<Analysis> centres;  ///< of bodies in a periodic box, where they are needed
  std::vector<Needs> needs;           ///< of the analyses
  ColumnSet wanted;                   ///< by all of them
  bool second_round = false;          ///< some analyses need the bodies' motion first
  bool whole_frame = false;           ///< some analyses need all atoms together
  bool ids = false, types = false;    ///< and these of them
  std::size_t bytes_an_atom = 1;      ///< that they need
  std::size_t frame_memory = 0;       ///< bytes for them; larger frames are done in parts
  std::size_t memory = 0;             ///< bytes for blocks kept between two rounds
  std::optional<std::uint64_t> last_digit_seed;
  int dropped_digits = 0;
  const std::atomic<int>* stop = nullptr;
};

/// Where the chunks of a frame come from, as often as they are needed.
class ChunkSupply {
 public:
  virtual ~ChunkSupply() = default;
  virtual const Chunk* cut(Chunk& place) = 0;  ///< the next one, there or elsewhere; null at the end
  virtual void restart() = 0;
};

/// What the analyses make of a frame.
struct FrameOutcome {
  /// Of an analysis, to be given on.
  struct Found {
    std::size_t analysis;
    std::unique_ptr<Product> product;  ///< null of another rank

    template <class P>
    void pass(P& parcel) {
      parcel(analysis);
    }
  };
  std::vector<std::vector<double>> rows;  ///< one for each analysis
  std::vector<Found> products;
  std::uint64_t uncertain_images = 0;  ///< atoms; see Unwrapping

  /// Without the products, which stay on their rank.
  template <class P>
  void pass(P& parcel) {
    parcel(rows, products, uncertain_images);
  }
};

/// Gives the blocks of a frame to all analyses, in rounds: first the bodies' centres if positions
/// are to be unwrapped, then the analyses, then those that need the bodies' motion; last the atoms of
/// the frame together to those that need them so.
class FrameRun {
 public:
  /// `plan` must outlive it. The arrays are kept from frame to frame.
  FrameRun(const FramePlan& plan, std::size_t threads);
  ~FrameRun();
  FrameRun(FrameRun&&) noexcept;

  /// Throws InputError if the frame has no atoms, or as the analyses do; Interrupted. `unwrapping` is
  /// null if positions are right as they are.
  FrameOutcome run(const FrameHeader& header, ChunkSupply& chunks, Unwrapping* unwrapping);

  /// The same, with the blocks shared by all ranks, each of which calls it and gets the whole. Not for analyses of whole
  /// frames.
  FrameOutcome run_on_ranks(const FrameHeader& header, ChunkSupply& chunks, Unwrapping* unwrapping);

  /// Settles the bodies' centres of a frame that another rank analyses.
  void follow(const FrameHeader& header, ChunkSupply& chunks, Unwrapping& unwrapping);

 private:
  class Rounds;
  std::unique_ptr<Rounds> rounds_;
};

}  // namespace mdana
