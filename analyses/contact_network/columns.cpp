// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "analyses/contact_network/network_numbers.hpp"

namespace mdana {
namespace {

/// What the settings must have for a column to be there.
enum class Condition { none, force, strong, compacted, reference, list };

bool holds(Condition condition, const ContactNetworkSettings& settings) {
  switch (condition) {
    case Condition::force: return settings.law.force || settings.listed;
    case Condition::strong: return settings.strong_force.has_value();
    case Condition::compacted: return settings.compacted.has_value();
    case Condition::reference: return settings.reference != nullptr;
    case Condition::list: return static_cast<bool>(settings.listed);
    case Condition::none: break;
  }
  return true;
}

struct NumberColumn {
  const char* name;
  Dimension dimension;
  double NetworkNumbers::*value;
  Condition condition = Condition::none;
};

using N = NetworkNumbers;

constexpr NumberColumn number_columns[] = {
    {"contacts", dimension::none, &N::contacts},
    {"contacts1", dimension::none, &N::contacts1},
    {"contacts2", dimension::none, &N::contacts2},
    {"contacts12", dimension::none, &N::contacts12},
    {"undecided", dimension::none, &N::undecided},
    {"listed", dimension::none, &N::listed, Condition::list},
    {"unmatched", dimension::none, &N::unmatched, Condition::list},
    {"coordination", dimension::none, &N::coordination},
    {"coordination_error", dimension::none, &N::coordination_error},
    {"coordination_core", dimension::none, &N::coordination_core},
    {"coordination_core_error", dimension::none, &N::coordination_core_error},
    {"core_grains", dimension::none, &N::core_grains},
    {"made", dimension::none, &N::made, Condition::reference},
    {"broken", dimension::none, &N::broken, Condition::reference},
    {"lost_contacts", dimension::none, &N::lost_contacts, Condition::reference},
    {"tension", dimension::none, &N::tension, Condition::force},
    {"compression", dimension::none, &N::compression, Condition::force},
    {"tension12", dimension::none, &N::tension12, Condition::force},
    {"compression12", dimension::none, &N::compression12, Condition::force},
    {"strong_tension", dimension::none, &N::strong_tension, Condition::strong},
    {"strong_compression", dimension::none, &N::strong_compression, Condition::strong},
    {"force_mean", dimension::force, &N::force_mean, Condition::force},
    {"force_rms", dimension::force, &N::force_rms, Condition::force},
    {"force_min", dimension::force, &N::force_min, Condition::force},
    {"force_q05", dimension::force, &N::force_q05, Condition::force},
    {"force_q25", dimension::force, &N::force_q25, Condition::force},
    {"force_median", dimension::force, &N::force_median, Condition::force},
    {"force_q75", dimension::force, &N::force_q75, Condition::force},
    {"force_q95", dimension::force, &N::force_q95, Condition::force},
    {"force_max", dimension::force, &N::force_max, Condition::force},
    {"force12", dimension::force, &N::force12, Condition::force},
    {"fabric_xx", dimension::none, &N::fabric_xx},
    {"fabric_yy", dimension::none, &N::fabric_yy},
    {"fabric_zz", dimension::none, &N::fabric_zz},
    {"fabric_xy", dimension::none, &N::fabric_xy},
    {"fabric_xz", dimension::none, &N::fabric_xz},
    {"fabric_yz", dimension::none, &N::fabric_yz},
    {"fabric_line", dimension::none, &N::fabric_line},
    {"fabric_deviator", dimension::none, &N::fabric_deviator},
    {"compacted_grains", dimension::none, &N::compacted_grains, Condition::compacted},
    {"compacted_volume", {0, 3, 0}, &N::compacted_volume, Condition::compacted},
};

}  // namespace

std::vector<ColumnSpec> network_columns(const ContactNetworkSettings& settings) {
  std::vector<ColumnSpec> columns;
  for (const NumberColumn& c : number_columns)
    if (holds(c.condition, settings)) columns.push_back({c.name, c.dimension});
  for (const char* bin : {"shell", "layer"})
    for (std::size_t k = 1; k <= filling_bins; ++k)
      columns.push_back({fmt::format("filling_{}{}", bin, k), dimension::none});
  return columns;
}

void write_row(const NetworkNumbers& numbers, const ContactNetworkSettings& settings,
               std::span<double> row) {
  auto value = row.begin();
  for (const NumberColumn& c : number_columns)
    if (holds(c.condition, settings)) *value++ = numbers.*c.value;
  value = std::copy(numbers.shell.begin(), numbers.shell.end(), value);
  std::copy(numbers.layer.begin(), numbers.layer.end(), value);
}

}  // namespace mdana
