// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "fits/aggregate_constants.hpp"
#include "reports/network.hpp"

namespace mdana {
namespace {

void add_grains(Document& document, const NetworkSetup& setup) {
  const bool alike = setup.smallest == setup.largest;
  document.number(
      "grains.radius", {*setup.grains.radius, {}, dimension::length},
      {{"smallest", setup.smallest}, {"largest", setup.largest}, {"source", setup.radius_source}});
  document.json("grains.count", setup.count);
  document.line("grains",
                fmt::format("{}, radii {} (from the {})", setup.count,
                            alike ? "all alike"
                                  : fmt::format("{:.6g} to {:.6g}", setup.smallest, setup.largest),
                            setup.radius_source));
  document.number("filling_factor", {setup.filling, {}, dimension::none},
                  {{"source", setup.filling_source}});
}

void add_contact(Document& document, const NetworkSetup& setup) {
  if (!setup.contact) return document.left_out("forces, elastic constants", setup.no_contact);
  const ElasticContact& c = *setup.contact;
  document.number("contact.a0", {equilibrium_radius(c), {}, dimension::length});
  document.number("contact.delta0", {equilibrium_overlap(c), {}, dimension::length});
  document.number("contact.F_c", {pull_force(c), {}, dimension::force});
  document.number(
      "contact.force_noise", {setup.settings.force_noise, {}, dimension::force},
      {{"of", "three standard deviations by the printed digits of positions, at rest"}});
}

/// The row of a frame as an object, without what is not known.
nlohmann::ordered_json row_of(const Table& table, std::size_t row) {
  nlohmann::ordered_json object;
  for (std::size_t c = 0; c < table.columns().size(); ++c)
    if (const double value = table.column(c)[row]; !std::isnan(value))
      object[table.columns()[c].name] = value;
  return object;
}

std::string contacts_of(const Table& table, std::size_t row) {
  const auto at = [&](const char* column) { return table.column(column)[row]; };
  std::string text = fmt::format("{:g} and {:g} within, {:g} between the bodies", at("contacts1"),
                                 at("contacts2"), at("contacts12"));
  if (table.has("tension"))
    text += fmt::format("; {:g} in tension, {:g} in compression", at("tension"), at("compression"));
  if (table.has("made"))
    text += fmt::format("; {:g} made, {:g} broken", at("made"), at("broken"));
  return text;
}

void add_frames(Document& document, const MeasuredNetwork& measured) {
  const Table& table = measured.table;
  const std::tuple<const char*, const char*, std::size_t> frames[] = {
      {"first", "contacts at first", 0},
      {"at_delta_max", "at the greatest delta", measured.most_compressed},
      {"last", "at last", table.rows() - 1}};
  for (const auto& [key, label, row] : frames) {
    document.json(fmt::format("frame.{}", key), row_of(table, row));
    document.line(label, contacts_of(table, row));
  }
}

void add_coordination(Document& document, const NetworkSetup& setup, const Table& table) {
  const auto at = [&](const char* column) { return table.column(column)[0]; };
  const double expected = cpe_coordination(setup.filling);
  document.number("coordination", {at("coordination"), at("coordination_error"), dimension::none},
                  {{"of", "all grains, first frame used"}});
  if (at("core_grains") > 1)
    document.number("coordination_core",
                    {at("coordination_core"), at("coordination_core_error"), dimension::none},
                    {{"of", "grains deeper than two grain radii, first frame used"}});
  nlohmann::ordered_json details{{"of", "12 phi/phi_max"}};
  if (setup.contact) {  // grains made delta0 nearer than touch take a smaller share of more places
    const double nearer = 1 - equilibrium_overlap(*setup.contact) / (2 * *setup.grains.radius);
    details["at_equilibrium_overlap"] = expected * nearer * nearer * nearer;
  }
  document.number("coordination_cpe", {expected, {}, dimension::none}, details);
}

/// Contacts whose state the frame does not tell.
void tell_undecided(Document& document, const NetworkSetup& setup, const Table& table) {
  if (!setup.contact) return;
  const auto undecided = table.column("undecided");
  const auto row =
      static_cast<std::size_t>(std::ranges::max_element(undecided) - undecided.begin());
  document.json("undecided.most", undecided[row]);
  document.json("undecided.row", row);
  document.line(
      "undecided",
      fmt::format("at most {:g} pairs beside {:g} contacts (frame {}): apart, but by less "
                  "than at pull-off; they hold if they have touched",
                  undecided[row], table.column("contacts")[row], row));
}

/// How much of the contacts and forces is the list's.
void add_list(Document& document, const NetworkSetup& setup, const Table& table) {
  if (!setup.list) return;
  document.input(*setup.list, "local dump");
  double frames = 0, listed = 0, contacts = 0, unmatched = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (std::isnan(table.column("listed")[row])) continue;
    ++frames;
    listed += table.column("listed")[row];
    unmatched += table.column("unmatched")[row];
    contacts += table.column("contacts")[row];
  }
  document.json(
      "listed",
      {{"frames", frames}, {"contacts", contacts}, {"forces", listed}, {"unmatched", unmatched}});
  document.line(
      "listed",
      fmt::format(
          "{:g} of {} frames; {:g} of their {:g} contacts have the list's force, the others "
          "that by the overlap",
          frames, table.rows(), listed, contacts));
  if (unmatched > 0)
    document.warn(fmt::format(
        "{}: {:g} listed forces are of pairs farther apart than at pull-off, or not in the bodies",
        setup.list->path, unmatched));
}

void add_left_out(Document& document, const NetworkSetup& setup) {
  if (!setup.settings.reference)
    document.left_out("made, broken, lost contacts", setup.not_followed);
  document.left_out(
      "pairs apart that still hold (undecided)",
      "whether they have touched before is not in a frame; forces are of pairs that overlap");
  document.left_out("contacts through periodic faces", "the bodies are put together first");
}

/// The errors are those of the coordination: what the estimate itself is off by is more.
void add_moduli(Document& document, const NetworkSetup& setup, const NetworkOptions& options,
                const Value& coordination) {
  const double stiffness = contact_stiffness(*setup.contact);
  const auto bulk = [&](double n) {
    return bulk_modulus(setup.filling, n, stiffness, *setup.grains.radius);
  };
  Value modulus{bulk(coordination.value), {}, dimension::pressure};
  if (coordination.error) modulus.error = bulk(*coordination.error);
  document.number("aggregate.bulk_modulus", modulus,
                  {{"of", "phi n_c k/(6 pi r), n_c as counted inside"}, {"stiffness", stiffness}});
  if (!options.aggregate_modulus)
    return document.left_out("aggregate.poisson_ratio",
                             "E* of the aggregates is not known; add --aggregate-modulus");
  const auto ratio = [&](double k) {
    return aggregate_poisson_ratio(*options.aggregate_modulus, k);
  };
  Value nu{ratio(modulus.value), {}, dimension::none};
  if (modulus.error && *modulus.error < modulus.value)
    nu.error = (ratio(modulus.value + *modulus.error) - ratio(modulus.value - *modulus.error)) / 2;
  document.number("aggregate.poisson_ratio", nu,
                  {{"of", "E*_agg = 3 K (1 - 2 nu)/(2 (1 - nu^2))"}});
}

}  // namespace

void add_network(Document& document, const NetworkSetup& setup, const MeasuredNetwork& measured) {
  add_grains(document, setup);
  add_contact(document, setup);
  add_coordination(document, setup, measured.table);
  add_frames(document, measured);
  add_list(document, setup, measured.table);
  tell_undecided(document, setup, measured.table);
  document.json("compacted.local_filling_above", *setup.settings.compacted);
  document.number("compacted.volume",
                  {measured.table.column("compacted_volume")[measured.most_compressed],
                   measured.table.column("compacted_volume")[0],
                   {0, 3, 0}},
                  {{"of", "the frame of greatest delta; the error is what the first frame has"}});
  if (setup.settings.strong_force) document.json("strong_force", *setup.settings.strong_force);
  add_left_out(document, setup);
}

void add_aggregate_constants(Document& document, const NetworkSetup& setup,
                             const NetworkOptions& options, const Value& coordination) {
  if (setup.filling >= largest_filling)
    return document.left_out(
        "aggregate", fmt::format("the filling factor is {:.4g}, above {:.4f} of close packing: "
                                 "check the radii of grains and bodies",
                                 setup.filling, largest_filling));
  document.number("aggregate.coordination_bcca",
                  {bcca_coordination(setup.filling), {}, dimension::none},
                  {{"of", "compressed BCCA, 2 + 9.38 phi^1.62"}});
  if (setup.contact) add_moduli(document, setup, options, coordination);
  const Grains& grains = setup.grains;
  if (grains.surface_energy && grains.rolling_displacement)
    document.number("aggregate.static_yield_stress",
                    {static_yield_stress(setup.filling, *grains.radius, *grains.surface_energy,
                                         *grains.rolling_displacement),
                     {},
                     dimension::pressure},
                    {{"of", "(E_roll/r^3) (1/phi - 1/phi_max)^-3, quasistatic, compressed BCCA"}});
  else
    document.left_out("aggregate.static_yield_stress",
                      "needs gamma and xi_c; add --surface-energy and --rolling-displacement");
}

}  // namespace mdana
