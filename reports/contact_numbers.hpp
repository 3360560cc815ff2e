// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyses/contact_hysteresis.hpp"
#include "fits/force_law.hpp"
#include "reports/measured.hpp"

namespace mdana {

/// How the contact radius is to be measured; what is not given has a default.
struct ContactOptions {
  std::optional<double> layer;    ///< thickness [length]; see half_layer
  std::optional<double> spacing;  ///< of nearest neighbours [length]; median of the first frame
  std::optional<double> cutoff;   ///< of neighbours [length]; 1.5 spacings
};

/// The same, settled.
struct ContactSetup {
  double half_layer = 0;             ///< [length]
  double spacing = 0, cutoff = 0;    ///< [length]; of the patch, 0 if this build has none
  std::string spacing_source;
};

/// Reads the first frame if the spacing is not given. Throws InputError as half_layer does.
ContactSetup contact_setup(const Run& run, const ContactOptions& options);

/// The analyses that measure it: contact_radius and, if this build has it, contact_patch. They
/// follow the motion in the tables of MeasuredMotion.
std::vector<std::unique_ptr<Analysis>> contact_analyses(const Radii& radii,
                                                        const ContactSetup& setup);

/// Contact radius [length] by one definition: greatest, at greatest delta, at the end.
struct ContactRadiusNumbers {
  std::string_view definition;  ///< "gyration", "alpha", "neighbours"
  Value max, at_delta_max, end;
};

struct ContactNumbers {
  std::vector<ContactRadiusNumbers> definitions;  ///< gyration first
  ContactHysteresis hysteresis;                   ///< of gyration

  const ContactRadiusNumbers& gyration() const { return definitions.front(); }
  bool touch() const { return gyration().max.value > 0; }
};

ContactNumbers contact_numbers(const MeasuredMotion& measured, double radius_sum);

/// Numbers, definitions and cutoffs under the names that other programs rely on.
void add_contact_radius(Document& document, const ContactNumbers& numbers,
                        const ContactSetup& setup);

/// A sentence for each two definitions that differ by more than their errors.
std::vector<std::string> contact_disagreements(const ContactNumbers& numbers, Units units);

/// Adds the columns of the contact analyses.
void add_contact_columns(Table& table, const MeasuredMotion& measured);

/// Adds a_<law>, the contact radius of a law at every delta.
void add_law_column(Table& table, const std::vector<double>& delta, const ForceLaw& law,
                    const ElasticContact& contact);

}  // namespace mdana
