// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "analyses/table.hpp"
#include "fits/contact_fit.hpp"
#include "reports/document.hpp"

namespace mdana {

/// Numbers of a contact fit under the names that other programs rely on.
void add_contact_fit(Document& document, const CollisionLaw& law, const ContactFitSettings& settings,
                     std::span<const ObservedCollision> seen, const ContactFit& fit);

/// Columns R, v, e, sigma, e_fit, residual, and of delta_max and t_max the same if some were seen; one
/// row a collision. e_fit is 0 where sticking is predicted.
Table contact_fit_table(std::span<const ObservedCollision> seen, const ContactFit& fit);

}  // namespace mdana
