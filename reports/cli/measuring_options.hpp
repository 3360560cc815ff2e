// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/cli/command.hpp"
#include "reports/contact_numbers.hpp"
#include "reports/measured_energy.hpp"

namespace mdana::cli {

/// --layer, --spacing, --neighbour-cutoff of the contact radius.
void add_contact_options(Options& options);
ContactOptions contact_options(const Values& values);

/// Material constants that no dump tells: --modulus, --surface-energy.
struct Material {
  std::optional<double> modulus;         ///< E* [pressure]
  std::optional<double> surface_energy;  ///< gamma [energy/length^2]; else that of the scene
};
void add_material_options(Options& options);
Material material_options(const Values& values, const Scene& scene);

/// --final-clusters: look for exchanged atoms also among many.
void add_membership_options(Options& options);

/// --potential, --log.
void add_potential_options(Options& options);
PotentialOptions potential_options(const Values& values);

}  // namespace mdana::cli
