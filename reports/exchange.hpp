// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "analyses/energy_budget.hpp"
#include "reports/document.hpp"
#include "reports/measured.hpp"
#include "reports/run.hpp"

namespace mdana {

/// Which atoms are with the other body in the last frame: bodies are there the two clusters (see
/// readers/clusters.hpp) that hold most of the atoms of body 1 and of body 2.
struct Exchange {
  std::string obstacle;               ///< why they are not known; else empty
  std::array<double, 2> to_other{};   ///< atoms of body 1, 2 in the other one's cluster
  double loose = 0;                   ///< atoms of the bodies in neither
  std::optional<Bodies> final_bodies;

  bool any() const { return to_other[0] + to_other[1] + loose > 0; }
};

/// `frame` counted from 0 in the dump. Keeps about 100 bytes an atom.
Exchange find_exchange(const Run& run, std::uint64_t frame);

/// What is left of the motion after separation, by one membership of the atoms.
struct SeparatedEnergies {
  Value K_p;         ///< of the relative motion [energy]
  Value K_t;         ///< of both bodies [energy]
  Value e, e_total;  ///< the speeds before are those of the bodies of the first frame
};

/// A measured run, as far as memberships are concerned. `restitution` has e determined.
struct SeparatedRun {
  const Run& run;
  const MeasuredMotion& measured;
  const ForceCurve& curve;
  const Restitution& restitution;
  const EnergyCurve& energy;  ///< by first-frame membership
  EnergyWindow after;
  SweepOptions sweeping;
  bool asked = false;  ///< for exchanged atoms, however many atoms there are
};

SeparatedEnergies by_first_frame(const SeparatedRun& separated);
/// Reads the frames after separation again.
SeparatedEnergies by_final_clusters(const SeparatedRun& separated, const Bodies& bodies);

/// Atoms in a frame beyond which exchanged ones are not looked for unasked: memory has a bound.
inline constexpr std::uint64_t most_atoms_clustered = 250'000;

/// `exchanged`, and energies by both memberships; or why they are left out.
void add_exchange(Document& document, const SeparatedRun& separated);

}  // namespace mdana
