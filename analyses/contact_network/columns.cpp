// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "analyses/contact_network/network_numbers.hpp"

namespace mdana {
namespace {

struct NumberColumn {
  const char* name;
  Dimension dimension;
  double NetworkNumbers::*value;
};

using N = NetworkNumbers;

constexpr NumberColumn number_columns[] = {
    {"contacts", dimension::none, &N::contacts},
    {"contacts1", dimension::none, &N::contacts1},
    {"contacts2", dimension::none, &N::contacts2},
    {"contacts12", dimension::none, &N::contacts12},
    {"undecided", dimension::none, &N::undecided},
    {"listed", dimension::none, &N::listed},
    {"unmatched", dimension::none, &N::unmatched},
    {"coordination", dimension::none, &N::coordination},
    {"coordination_error", dimension::none, &N::coordination_error},
    {"coordination_core", dimension::none, &N::coordination_core},
    {"coordination_core_error", dimension::none, &N::coordination_core_error},
    {"core_grains", dimension::none, &N::core_grains},
    {"made", dimension::none, &N::made},
    {"broken", dimension::none, &N::broken},
    {"lost_contacts", dimension::none, &N::lost_contacts},
    {"tension", dimension::none, &N::tension},
    {"compression", dimension::none, &N::compression},
    {"tension12", dimension::none, &N::tension12},
    {"compression12", dimension::none, &N::compression12},
    {"strong_tension", dimension::none, &N::strong_tension},
    {"strong_compression", dimension::none, &N::strong_compression},
    {"force_mean", dimension::force, &N::force_mean},
    {"force_rms", dimension::force, &N::force_rms},
    {"force_min", dimension::force, &N::force_min},
    {"force_q05", dimension::force, &N::force_q05},
    {"force_q25", dimension::force, &N::force_q25},
    {"force_median", dimension::force, &N::force_median},
    {"force_q75", dimension::force, &N::force_q75},
    {"force_q95", dimension::force, &N::force_q95},
    {"force_max", dimension::force, &N::force_max},
    {"force12", dimension::force, &N::force12},
    {"fabric_xx", dimension::none, &N::fabric_xx},
    {"fabric_yy", dimension::none, &N::fabric_yy},
    {"fabric_zz", dimension::none, &N::fabric_zz},
    {"fabric_xy", dimension::none, &N::fabric_xy},
    {"fabric_xz", dimension::none, &N::fabric_xz},
    {"fabric_yz", dimension::none, &N::fabric_yz},
    {"fabric_line", dimension::none, &N::fabric_line},
    {"fabric_deviator", dimension::none, &N::fabric_deviator},
    {"compacted_grains", dimension::none, &N::compacted_grains},
    {"compacted_volume", {0, 3, 0}, &N::compacted_volume},
};

}  // namespace

std::vector<ColumnSpec> network_columns() {
  std::vector<ColumnSpec> columns;
  for (const NumberColumn& c : number_columns) columns.push_back({c.name, c.dimension});
  for (const char* bin : {"shell", "layer"})
    for (std::size_t k = 1; k <= filling_bins; ++k)
      columns.push_back({fmt::format("filling_{}{}", bin, k), dimension::none});
  return columns;
}

void write_row(const NetworkNumbers& numbers, std::span<double> row) {
  auto value = row.begin();
  for (const NumberColumn& c : number_columns) *value++ = numbers.*c.value;
  value = std::copy(numbers.shell.begin(), numbers.shell.end(), value);
  std::copy(numbers.layer.begin(), numbers.layer.end(), value);
}

}  // namespace mdana
