// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include "fits/force_law.hpp"

namespace mdana {

/// Estimates of the elastic constants, the static yield stress and the coordination of an aggregate
/// of equal adhesive spheres (Arakawa et al. 2024, Sec. 5; their numbers are (36) to (45)). They
/// take all contacts to be alike, at the equilibrium of JKR, and the coordination not to change
/// with pressure: orders of magnitude. phi is the filling factor, 0 to largest_filling.

/// pi/sqrt(18), of close packing; (40).
inline constexpr double largest_filling = std::numbers::pi / (3 * std::numbers::sqrt2);

/// Of a CPE aggregate, close packing less random grains: n_c = 12 phi/phi_max; (39).
double cpe_coordination(double phi);
/// Of a compressed BCCA aggregate: n_c = 2 + 9.38 phi^1.62 (Arakawa et al. 2019); (45).
double bcca_coordination(double phi);

/// JKR contact of two equal grains of one material: Young's modulus E, Poisson's ratio nu.
ElasticContact grain_contact(double grain_radius, double modulus, double poisson_ratio,
                             double surface_energy);

/// At the equilibrium of JKR: a0 = (9 pi gamma R*^2/E*)^(1/3), delta0 = a0^2/(3 R*), the force to
/// pull them apart F_c = 3 pi gamma R*, and dF/ddelta = 6 F_c/(5 delta0) = 6/5 E* a0; (38).
double equilibrium_radius(const ElasticContact& contact);   ///< a0 [length]
double equilibrium_overlap(const ElasticContact& contact);  ///< delta0 [length]
double pull_force(const ElasticContact& contact);           ///< F_c [force]
double contact_stiffness(const ElasticContact& contact);    ///< [force/length]

/// K = phi n_c k/(6 pi r_1): -V dP/dV of P = phi n_c F/(4 pi r_1^2), grains nearer by ddelta; (36),
/// (37), (41).
double bulk_modulus(double phi, double coordination, double stiffness, double grain_radius);

/// Poisson's ratio of E*_agg = E/(2 (1 - nu^2)), the reduced modulus of two equal aggregates, and
/// of K = E/(3 (1 - 2 nu)); (42), solved for nu. Above -1 and below 1/2 for any two positive
/// moduli.
double aggregate_poisson_ratio(double reduced_modulus, double bulk_modulus);

/// (E_roll/r_1^3) (1/phi - 1/phi_max)^-3 with E_roll = 6 pi^2 gamma r_1 xi_c, of quasistatic
/// compression (Tatsuuma et al. 2023, for compressed BCCA); (44) [pressure]. Infinite at phi_max.
double static_yield_stress(double phi, double grain_radius, double surface_energy,
                           double rolling_displacement);

}  // namespace mdana
