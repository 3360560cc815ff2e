// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "readers/units.hpp"

namespace mdana {

/// How particles of the two bodies act on each other.
enum class Interaction { unknown, hertz, adhesive, aggregate };

std::string_view name(Interaction interaction);

/// The grains that an aggregate is made of; everything is optional.
struct Grains {
  std::optional<double> radius;          ///< [length]
  std::optional<double> density;         ///< [mass/length^3] of a grain, not of the aggregate
  std::optional<double> surface_energy;  ///< gamma of one surface [energy/length^2]
  std::optional<double> modulus;         ///< Young's [pressure]
  std::optional<double> poisson_ratio;   ///< -1 to 0.5
  std::optional<double> rolling_displacement;  ///< xi_c [length], where rolling becomes inelastic
};

/// What is known of a run beside its dump; everything is optional. Read from a scene file (TOML)
/// and completed by options; quantities are in the dump's units.
struct Scene {
  std::filesystem::path file;                ///< empty if there is no scene file
  std::string name;                          ///< of the run
  std::string dump;                          ///< file name, relative to the scene file
  std::optional<Units> units;
  Interaction interaction = Interaction::unknown;
  std::optional<double> timestep;            ///< [time] between steps
  std::optional<double> sigma;               ///< [length] scale of the potential
  std::optional<double> cutoff;              ///< [length] of the potential
  std::optional<bool> shift;                 ///< the potential is shifted to zero at the cutoff
  std::string bodies;                        ///< rule as for --bodies; empty: not stated
  std::map<std::int64_t, double> masses;     ///< [mass] by atom type
  std::vector<double> radii;                 ///< [length] of body 1, 2
  std::string radius_definition;             ///< "cut", "volume", ...
  std::optional<double> surface_energy;      ///< gamma of one surface [energy/length^2]
  std::optional<double> poisson_ratio;
  std::optional<double> filling_factor;      ///< of the aggregates as made, grains (r/R)^3
  Grains grains;                             ///< of aggregates
  std::optional<double> impact_velocity;     ///< [velocity] as generated
  std::optional<double> seed;                ///< of the generator
  std::vector<std::array<double, 4>> orientations;  ///< of body 1, 2: unit quaternions w x y z
};

/// Reads a scene file. Throws InputError naming file, line and key; unknown keys outside
/// [generator] are errors, so that a misspelt one is not passed over.
Scene load_scene(const std::filesystem::path& file);

/// The scene file that belongs to a dump: `scene.toml` in its folder, if that names the dump.
/// An empty scene without one.
Scene scene_beside(const std::filesystem::path& dump);

}  // namespace mdana
