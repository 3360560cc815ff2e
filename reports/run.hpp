// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analyses/motion.hpp"
#include "analyses/relative_motion.hpp"
#include "analyses/sweep.hpp"
#include "readers/bodies.hpp"
#include "readers/input_error.hpp"
#include "readers/masses.hpp"
#include "readers/physical.hpp"
#include "readers/scene.hpp"

namespace mdana {

/// What the user says of a run; whatever is missing comes from the scene file or the dump.
struct RunOptions {
  std::filesystem::path dump;
  std::filesystem::path scene;      ///< empty: scene.toml beside the dump, if it names it
  std::optional<Units> units;
  std::map<std::int64_t, double> masses;           ///< [mass] by atom type; empty: not given
  std::string bodies;                              ///< rule, see find_bodies; empty: not given
  std::optional<std::array<double, 2>> radius;     ///< of body 1, 2 [length]
  std::optional<double> timestep;                  ///< [time]
  std::optional<Selection> selection;              ///< of atoms
  std::optional<PhysicalUnits> physical;           ///< what the units lj stand for
};

/// A dump with everything that is needed to analyse it, and where each of it came from.
struct Run {
  std::filesystem::path dump;
  std::string_view format;
  FrameHeader first;
  Scene scene;
  Units units;
  std::string units_source;
  std::optional<double> timestep;
  std::string timestep_source;
  Masses masses;
  Bodies bodies;
  std::optional<Selection> selection;
  std::vector<std::string> warnings;
  std::optional<PhysicalUnits> physical;
};

/// Radii of body 1 and 2 and where they come from.
struct Radii {
  std::array<double, 2> value;
  std::string source;
  double sum_error = 0;  ///< standard error of R1 + R2 [length]; 0 if they are given
  bool given = false;    ///< by option or scene, not measured
  double sum() const { return value[0] + value[1]; }
  double reduced() const { return value[0] * (value[1] / sum()); }  ///< R*
};

/// The units that option, dump or scene state, and which of them. Throws InputError if none states
/// them or they disagree.
struct StatedUnits {
  Units units;
  std::string source;
};
StatedUnits find_units(const RunOptions& options, const FrameHeader& first, const Scene& scene);

/// Masses from option, dump, scene, or 1 in lj units (a warning says so). Throws InputError.
Masses find_masses(const RunOptions& options, const FrameHeader& first, const Scene& scene,
                   Units units, std::vector<std::string>& warnings);

/// The scene file given, or the one beside the dump.
Scene find_scene(const RunOptions& options);

/// Looks at the first frame and settles units, time step, masses and bodies.
/// Throws InputError naming what is missing and the option that supplies it.
Run prepare_run(const RunOptions& options);

/// The result of `work`; an InputError that it throws is told with the name of the dump.
template <class Work>
auto told_of(const Run& run, Work&& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(run.dump.string() + ": " + error.what());
  }
}

/// Throws InputError unless the run has exactly two bodies.
void require_two_bodies(const Run& run);

/// Radii from the option, else the scene file, else sqrt(5/3) r_g in the first frame.
Radii find_radii(const Run& run, const RunOptions& options);

/// Layer half thickness for the contact radius: half the given thickness, else half of the scene's
/// sigma, else 0.5 in lj units. Throws InputError if none is known.
double half_layer(const Run& run, std::optional<double> thickness);

/// Times of the frames: by the option, else as the dump states them, else by the scene, else empty. By steps
/// they count from step 0, or from the first frame if that has more than 2^32 (then `warnings` says so).
std::vector<double> frame_times(const Run& run, const SweepResult& swept);

/// The best force source that the dump allows.
ForceSource best_force_source(const Run& run);

/// What the motion analysis has to read for a force source.
MotionParts parts_for(ForceSource source);

}  // namespace mdana
