// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/measured_energy.hpp"
#include "reports/run.hpp"

namespace mdana {

/// What can be told of a run. A part is computed whole, or left out.
enum class Part {
  force,
  rotation,
  restitution,
  contact_radius,
  contact_areas,
  plasticity,
  energies,
  potential_energy,
  hertz_fit,
  jkr,
  surface_energy,
  structure,
  dislocations,
  compression,
  coordination,
  network,
  pictures,
  accuracy,
  stability
};

/// As documents name it: "contact radius by area and by neighbours".
std::string_view name(Part part);

struct LeftOut {
  std::string what, reason;
};

struct PlannedPart {
  Part part;
  std::vector<std::string> columns;  ///< that it reads, as the dump names them
  std::string reason;                ///< why it is computed, and so
};

/// What is computed of a run and what is not, with the reasons: decided before the dump is read, by its first
/// header, the scene, and what this build has.
struct Plan {
  std::vector<PlannedPart> computed;
  std::vector<LeftOut> left_out;

  bool has(Part part) const;
  /// Of a part that is computed: it turned out not to be possible. Nothing if it is left out already.
  void leave_out(Part part, const std::string& reason);
  /// e and its speeds, as far as the outcome of a run allows.
  void settle(const Restitution& restitution, Outcome outcome);
};

/// Why laws of adhesive spheres are not drawn beside what was measured.
inline constexpr const char* gamma_not_known =
    "gamma is not known; state it in the scene ([material]) or add --surface-energy";
inline constexpr const char* modulus_not_known =
    "E* is not known; add --modulus (fit-hertz measures it in a repulsive run; a report takes that of the same radius)";

/// Why a compression cannot be followed in time.
inline constexpr const char* times_not_known =
    "t_max and v_rel need the time between frames, which is unknown; add --timestep DT, or dump with 'dump_modify time yes'";

/// What a command or a study asks for.
struct PlanWishes {
  std::vector<Part> parts;
  /// The parts are wanted whatever the scene is of; else what the scene does not call for is left out.
  bool insist = false;
  bool structure = true, pictures = true, accuracy = true, stability = true;  ///< settings of a study
  std::optional<ForceSource> source;  ///< of the force; the best one that the dump has
  PotentialOptions potential;
  std::optional<double> layer;  ///< of the contact radius [length]; see half_layer
  std::optional<double> surface_energy;  ///< gamma, besides that of the scene [energy/length^2]
  bool modulus = false;         ///< E* is known
  bool grains = false;          ///< and the radius of grains
};

/// The parts that a command tells of, that of a report, or all that a scene could call for ("all"); nothing if
/// the command computes nothing out of a dump.
std::optional<std::vector<Part>> parts_of(std::string_view command);

/// The commands that parts_of knows.
std::vector<std::string_view> planned_commands();

Plan plan_run(const Run& run, const PlanWishes& wishes);

/// The plan of a command that tells its own parts whatever the scene is of; `wishes` says the rest.
Plan plan_command(const Run& run, std::string_view command, PlanWishes wishes = {});

/// Why a part cannot be computed of a run; empty if it can.
std::string obstacle(Part part, const Run& run, const PlanWishes& wishes = {});

/// Why the scene does not call for a part; empty if it does.
std::string not_needed(Part part, const Run& run, const PlanWishes& wishes = {});

/// `computed` and `left_out` of a document.
void add_plan(Document& document, const Plan& plan);

}  // namespace mdana
