// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace mdana {

/// A relaxed fcc sphere of Lennard-Jones atoms, in units lj.
struct LjParticle {
  double atoms;    ///< N, which is its mass
  double radius;   ///< R, by a Hertz fit
  double modulus;  ///< E*, by a Hertz fit
};

/// Yoshida, Kokubo & Tanaka 2024, Table II.
constexpr std::array<LjParticle, 5> lj_particles{{{113637, 29.6, 53.2},
                                                  {914443, 58.9, 58.4},
                                                  {3120599, 88.4, 63.7},
                                                  {14434147, 147, 65.5},
                                                  {115506757, 294, 68.3}}};

/// Their surface energy, Poisson's ratio and distance of nearest neighbours (same source).
constexpr double lj_surface_energy = 3.17;
constexpr double lj_poisson_ratio = 0.25;
constexpr double lj_spacing = 1.091;

}  // namespace mdana
