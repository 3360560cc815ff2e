// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/hertz_sizes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace mdana {
namespace {

constexpr double same_size = 0.01;

nlohmann::ordered_json to_json(const Pooled& pooled) {
  using Json = nlohmann::ordered_json;
  Json json = to_json(pooled.value);
  json["within"] = pooled.within;
  json["between"] = std::isnan(pooled.between) ? Json() : Json(pooled.between);
  json["spread"] = std::isnan(pooled.spread) ? Json() : Json(pooled.spread);
  return json;
}

void add_pooled(Document& document, const std::string& name, const Pooled& pooled) {
  document.number(name, pooled.value, {{"within", pooled.within}, {"between", pooled.between}, {"spread", pooled.spread}});
  document.line(name + " of runs", fmt::format("{:.3g} within and {:.3g} between runs, spread {:.3g}", pooled.within,
                                               pooled.between, pooled.spread));
}

}  // namespace

std::vector<HertzSize> pool_by_size(std::span<const HertzRun> runs) {
  std::vector<HertzRun> sorted(runs.begin(), runs.end());
  std::ranges::stable_sort(sorted, {}, &HertzRun::atoms);
  std::vector<HertzSize> sizes;
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto end = std::find_if(first, sorted.end(), [&](const HertzRun& r) {
      return r.atoms > (1 + same_size) * first->atoms;
    });
    std::vector<Value> moduli, radii;
    HertzSize size;
    size.runs = static_cast<std::size_t>(end - first);
    for (auto run = first; run != end; ++run) {
      size.atoms += run->atoms / static_cast<double>(size.runs);
      moduli.push_back(run->modulus);
      radii.push_back(run->radius);
    }
    size.modulus = pool(moduli);
    size.radius = pool(radii);
    sizes.push_back(size);
    first = end;
  }
  return sizes;
}

void add_sizes(Document& document, std::span<const HertzSize> sizes) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const HertzSize& s : sizes)
    json.push_back({{"N", s.atoms}, {"runs", s.runs}, {"R", to_json(s.radius)}, {"E_star", to_json(s.modulus)}});
  document.json("sizes", std::move(json));
  if (sizes.size() == 1) {
    add_pooled(document, "E_star", sizes[0].modulus);
    add_pooled(document, "R", sizes[0].radius);
    return;
  }
  for (const HertzSize& s : sizes)
    document.line(fmt::format("N = {:.6g}", s.atoms),
                  fmt::format("R {}, E_star {}, of {} run{}", to_text(s.radius.value, document.units()),
                              to_text(s.modulus.value, document.units()), s.runs, s.runs == 1 ? "" : "s"));
}

Table size_table(std::span<const HertzSize> sizes) {
  Table table({{"N", dimension::none},
               {"runs", dimension::none},
               {"R", dimension::length},
               {"R_error", dimension::length},
               {"R_between", dimension::length},
               {"E_star", dimension::pressure},
               {"E_star_error", dimension::pressure},
               {"E_star_between", dimension::pressure}});
  for (const HertzSize& s : sizes)
    table.add_row(std::array{s.atoms, static_cast<double>(s.runs), s.radius.value.value, *s.radius.value.error,
                             s.radius.between, s.modulus.value.value, *s.modulus.value.error, s.modulus.between});
  return table;
}

}  // namespace mdana
