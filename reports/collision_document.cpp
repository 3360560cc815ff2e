// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/compression.hpp"
#include "reports/analysed_run.hpp"
#include "reports/compressed.hpp"
#include "reports/exchange.hpp"
#include "reports/overlays.hpp"
#include "reports/plasticity.hpp"

namespace mdana {
namespace {

void tell_bodies(Document& document, const AnalysedRun& analysed) {
  const auto [first, second] = body_motion(analysed.measured.swept.tables[0], 0);
  document.number("mass.body1", {first.mass, {}, dimension::mass});
  document.number("mass.body2", {second.mass, {}, dimension::mass});
  document.number("radius.body1", {analysed.radii.value[0], {}, dimension::length});
  document.number("radius.body2", {analysed.radii.value[1], {}, dimension::length});
}

void tell_time_of_compression(Document& document, const AnalysedRun& analysed) {
  const MaximumCompression m =
      maximum_compression(approach_by_membership(analysed.measured.motion), analysed.radii.sum());
  if (m.time_reason.empty())
    document.number("t_max", m.time);
  else
    document.left_out("t_max", m.time_reason);
}

void tell_plasticity(Document& document, const AnalysedRun& analysed, const ElasticContact& contact) {
  PlasticSigns signs = plastic_signs(analysed.curve, contact);
  const auto windows = energy_windows(analysed.curve);
  judge_bumps(signs, {far_side_growth(analysed.far_side(), 1, windows), far_side_growth(analysed.far_side(), 2, windows)},
              analysed.contact_setup ? analysed.contact_setup->spacing : 0);
  document.number("p_c_max", signs.pressure());
  document.text("p_c_law", signs.pressure_jkr ? "JKR, over E*" : "Hertz, over E*");
  document.number("p_c.hertz", signs.pressure_hertz);
  if (signs.pressure_jkr)
    document.number("p_c.jkr", *signs.pressure_jkr);
  document.number("delta_residual", signs.residual);
  document.text("plastic", std::string(name(signs.verdict)));
  document.json("plastic_reasons", signs.reasons);
  document.number("far_side.body1", signs.bump[0]);
  document.number("far_side.body2", signs.bump[1]);
}

void tell_energy(Document& document, const Run& run, const AnalysedRun& analysed, const SweepOptions& sweeping,
                 bool final_clusters) {
  add_energy(document, *analysed.energy);
  add_rotation(document, analysed.energy->curve, analysed.curve);
  if (const auto windows = energy_windows(analysed.curve))
    add_exchange(document, {run, analysed.measured, analysed.curve, analysed.restitution, analysed.energy->curve,
                            windows->after, sweeping, final_clusters});
  else
    document.left_out("exchanged atoms", "no frame before contact, or no turn");
}

void tell_contact(Document& document, const Run& run, const AnalysedRun& analysed) {
  if (!analysed.touch()) return;
  add_contact_radius(document, analysed.contact, *analysed.contact_setup);
  for (const std::string& w : contact_disagreements(analysed.contact, run.units)) document.warn(w);
}

/// Columns that the table does not have yet.
void add_columns(const Table& more, Table& all) {
  for (std::size_t k = 0; k < more.columns().size(); ++k)
    if (!all.has(more.columns()[k].name)) {
      const auto column = more.column(k);
      all.add_column(more.columns()[k], {column.begin(), column.end()});
    }
}

Table all_columns(const AnalysedRun& analysed) {
  const RelativeMotion& motion = analysed.measured.motion;
  Table all = force_table(analysed.curve, motion, analysed.measured.swept.tables[0]);
  for (std::size_t t = 1; t <= analysed.contact_tables + 1; ++t) add_columns(analysed.measured.swept.tables[t], all);
  if (analysed.energy) add_columns(energy_table(analysed.energy->curve, motion.steps, motion.times), all);
  return all;
}

}  // namespace

Table add_collision(Document& document, const Run& run, const AnalysedRun& analysed, const ElasticContact& contact,
                    const SweepOptions& sweeping, bool final_clusters) {
  Table table = all_columns(analysed);
  document.sweep(analysed.measured.swept, run.format);
  add_plan(document, analysed.plan);
  tell_bodies(document, analysed);
  add_force(document, analysed.curve, analysed.source, analysed.radii);
  tell_time_of_compression(document, analysed);
  add_restitution(document, analysed.restitution);
  add_overlays(document, table, analysed.curve, contact);
  tell_plasticity(document, analysed, contact);
  if (analysed.energy) tell_energy(document, run, analysed, sweeping, final_clusters);
  tell_contact(document, run, analysed);
  add_lost_atoms(document, analysed.measured.motion);
  warn_of_force(document, analysed.curve);
  return table;
}

}  // namespace mdana
