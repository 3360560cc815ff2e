// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "analyses/table.hpp"
#include "readers/units.hpp"

namespace mdana {

/// Where the energy of two bodies is, a value a frame, in the unit system's energy unit (Yoshida,
/// Kokubo & Tanaka 2024, Sec. IV C). Arrays of two are of body 1 and 2.
struct EnergyCurve {
  std::array<std::vector<double>, 2> K_p;          ///< M V^2/2, in the frame of the dump
  std::vector<double> K_p_rel;                     ///< m* |V2 - V1|^2/2, in that of the pair
  std::vector<double> K_p_across;                  ///< part of K_p_rel across the centre line
  std::array<std::vector<double>, 2> K_t;          ///< about the centre of mass, rotation included
  std::array<std::vector<double>, 2> rotation;     ///< part of K_t that is rotation as a rigid body
  std::array<std::vector<double>, 2> temperature;  ///< of K_t less rotation; NaN without freedom
  std::array<std::vector<double>, 2> W;            ///< potential energy by atoms; else empty
  std::vector<double> W_total;  ///< NaN in frames where it is unknown; empty if that is all of them
  double W_rounding = 0;        ///< of W_total, as it was printed [energy]

  std::size_t frames() const { return K_p_rel.size(); }
  std::vector<double> thermal() const;        ///< K_t of both
  std::vector<double> total_rotation() const;
  std::vector<double> kinetic() const;        ///< of all atoms of the bodies, in the dump's frame
  std::vector<double> total() const;          ///< K_p_rel + K_t + W; empty without W
};

/// From the tables of the analyses motion (with velocities) and energy.
EnergyCurve energy_curve(const Table& motion, const Table& energy, Units units);

/// Columns step, [time,] K_p1 K_p2 K_p_rel K_t1 K_t2 rotation1 rotation2 temperature1 temperature2
/// [W1 W2] [W_total total]: a row a frame. Temperatures are in K, in lj units in epsilon/k_B.
Table energy_table(const EnergyCurve& curve, const std::vector<std::int64_t>& steps,
                   const std::vector<double>& times);

}  // namespace mdana
