// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "analyses/relative_motion.hpp"
#include "analyses/table.hpp"
#include "analyses/value.hpp"

namespace mdana {

/// Stages of a collision. Loading and unloading follow each other again and again if the pair
/// sticks and oscillates.
enum class Phase { approach, loading, unloading, separated };

/// How a collision ended: the bodies separated, they turned back while bound, or the dump ends
/// before either.
enum class Outcome { bounce, stick, unresolved };

std::string_view name(Phase phase);
std::string_view name(Outcome outcome);

/// Bodies touch from the first to the last frame in which |F| is at least this part of its maximum,
/// or four standard deviations of its noise if that is more (but at most a tenth of the maximum).
/// Single frames above it do not count.
inline constexpr double contact_force_fraction = 0.01;
/// A turning point of delta counts if delta goes back by at least this part of its rise in contact.
inline constexpr double turning_point_fraction = 0.01;

/// One loading and the unloading after it.
struct Cycle {
  std::size_t start, turn, end;  ///< frames of least, greatest, least delta
};

/// What a cycle costs by the force, and by the motion; must be the same.
struct Loop {
  Value area;          ///< between loading and unloading over the delta that both cover [energy]
  Value kinetic_loss;  ///< of the motion along the centre line between the same passages [energy]
  double low = 0;           ///< delta that it begins and ends at [length]
  double area_by_time = 0;  ///< by a rule of higher order; NaN without speeds and times
};

/// Force against mutual approach, and what is read off it. Errors are the largest difference to the
/// same number from every second frame (even ones, odd ones), for maxima and minima at least twice the rise of a
/// parabola beyond the extreme sample, for loop areas at least what unresolved sampling leaves (see
/// analyses/loop_loss.hpp), and together with that the noise of the force or
/// of the distance, of an extreme sqrt(2 ln n) times, where noise does not tell n samples apart.
struct ForceCurve {
  std::vector<double> distance;  ///< X [length]
  std::vector<double> delta;     ///< R1 + R2 - X [length]
  std::vector<double> speed;     ///< d delta/dt [velocity]; empty if unknown
  std::vector<double> force;     ///< repulsive > 0 [force]
  std::vector<double> force_error;  ///< standard error of each [force]; NaN if unknown
  std::vector<Phase> phase;
  std::vector<Cycle> cycles;     ///< the first is the collision; empty without contact

  bool contact = false;
  Outcome outcome = Outcome::unresolved;
  Value force_max;          ///< greatest repulsive force
  Value force_min_loading;  ///< least force up to the first turn (greatest attraction)
  Value delta_max;
  /// Area between the first loading and the first unloading branch over the delta that both cover:
  /// the energy lost in the first cycle; for a head-on bounce all that is lost. NaN without a turn.
  Value hysteresis_area;
  /// Kinetic energy that the motion along the centre line lost to the force between the two passages of
  /// the delta that the loop begins and ends at: must be the loop area. NaN without a turn, or if
  /// speeds are unknown. And all that the relative motion lost between them, which is less by what
  /// tangential forces gave to the motion across the line.
  Value kinetic_loss, kinetic_loss_total;
  std::vector<Loop> loops;  ///< of each cycle
  Loop all_loops;           ///< from the start of the first cycle to the end of the last one

  int window = 0;        ///< frames that a derivative is made from; 0 for summed forces
  bool coarse = false;   ///< halved sampling changes the force by more than 5 % of its maximum
};

/// Whether loop area and kinetic loss differ by more than twice their errors and what rounding leaves.
bool energies_disagree(const ForceCurve& curve);

/// Reads phases, turning points, outcome and loop area off the motion.
/// `radius_sum` is R1 + R2, `by` as in force_series. Throws InputError as interparticle_force does.
ForceCurve force_curve(const RelativeMotion& motion, ForceSource source, Units units,
                       double radius_sum, ForceDerivative by = {});

/// Columns step, [time,] X, delta, [v,] F, F_error, phase, lost (atoms), and the bodies' centres of mass x1 y1 z1 x2 y2 z2 and
/// velocities vx1 ... of the motion table, as far as they were measured: a row a frame.
Table force_table(const ForceCurve& curve, const RelativeMotion& motion, const Table& bodies);

}  // namespace mdana
