// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analyses/defects/labels.hpp"

namespace mdana::defects {

/// Turn of a body's lattice; a zero quaternion without any.
struct BodyLattice {
  Eigen::Quaterniond turn{0, 0, 0, 0};
  double share = 0;  ///< of the sample that agrees within 10 degrees
};

/// Lattices about a sample of the fcc atoms of a body, from slab after slab: those whose numbers have the
/// lowest hashes.
class LatticeSample {
 public:
  explicit LatticeSample(BodyIndex body) : body_(body) {}
  void add(const Sites& sites);
  BodyLattice lattice() const;

 private:
  struct Atom {
    std::uint64_t hash;
    std::uint32_t index;  ///< in the frame
    std::uint32_t place;  ///< of the slab, while it is looked at
    bool known;           ///< whether there is a turn
    std::optional<Eigen::Quaterniond> turn;
  };

  void take(const Sites& sites, std::size_t first, std::size_t end);  ///< of these places
  void take(std::uint64_t hash, std::uint32_t index, std::uint32_t place);
  std::vector<Eigen::Quaterniond> turns() const;

  BodyIndex body_;
  std::vector<Atom> atoms_;
};

}  // namespace mdana::defects
