// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/task.hpp"

#include <fmt/format.h>

#include "analyses/motion.hpp"
#include "readers/input_error.hpp"
#include "reports/study/aggregate_record.hpp"
#include "reports/study/chosen_frames.hpp"
#include "reports/study/run_checks.hpp"
#include "reports/study/run_figures.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

/// E*, R and gamma of a run, where they are known, and from where.
Overlay constants_of(const SphereRun& entry, const std::optional<Companion>& companion) {
  const bool adhesive = entry.run.scene.interaction == Interaction::adhesive;
  const HertzResult* own = entry.result.hertz ? &*entry.result.hertz : nullptr;
  Overlay overlay{find_force_law(adhesive ? "jkr" : "hertz"), {entry.result.radii.reduced(), 0, 0, 0, 0, 0}, {}};
  if (adhesive) overlay.contact.surface_energy = entry.run.scene.surface_energy.value_or(0);
  if (own && own->fit.fit.usable)
    overlay.contact.modulus = own->modulus.value;
  else if (!own && companion)
    overlay.contact.modulus = companion->modulus.value;
  overlay.source = fmt::format("E* and R from the Hertz fit of {}", own || !companion ? entry.name : companion->name);
  if (overlay.contact.surface_energy > 0)
    overlay.source += fmt::format(", gamma = {:g} from the scene", overlay.contact.surface_energy);
  return overlay;
}

/// Hertz over its own fit; JKR where it is planned.
void choose_overlay(SphereRun& entry, const Overlay& constants, Document& document) {
  const bool adhesive = entry.run.scene.interaction == Interaction::adhesive;
  if (adhesive ? entry.result.plan.has(Part::jkr) : constants.law && constants.contact.modulus > 0)
    entry.overlay = constants;
  else if (!adhesive)
    document.left_out("Hertz overlay", constants.law ? "neither this run nor a Hertz run with the same radius gives E* and R"
                                                     : "this build has no such law");
}

#ifdef MDANA_WITH_DEFECTS

/// Crystal structure: where defects begin, what is left of them, and the first and last frame.
void add_structure(const DefectHistory& history, Document& document) {
  Document defects("defects");
  add_defects(defects, history);
  const Json all = defects.content();
  Json json;
  for (const char* name : {"first_defect", "at_separation"}) json[name] = all.at(name);
  json["first_frame"] = all.at("frames").front();
  json["last_frame"] = all.at("frames").back();
  document.json("defects", std::move(json));
  for (const std::string& w : defects.warnings()) document.warn(w);
}

/// With the share of inner atoms that are not fcc.
Table structure_table(const DefectHistory& history) {
  Table table = defect_table(history);
  std::vector<double> share;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double other = table.column("hcp")[i] + table.column("bulk_defect")[i];
    share.push_back(other / (other + table.column("fcc")[i]));
  }
  table.add_column({"non_fcc", dimension::none}, std::move(share));
  return table;
}

void add_defects_to(RunRecord& record, const DefectHistory& history, Document& document) {
  add_structure(history, document);
  record.tables.push_back({"defects", structure_table(history)});
}

#else

void add_defects_to(RunRecord&, const DefectHistory&, Document&) {}

#endif

std::vector<double> sum_of(const Table& table, const char* first, const char* second) {
  std::vector<double> sum;
  for (std::size_t i = 0; i < table.rows(); ++i) sum.push_back(table.column(first)[i] + table.column(second)[i]);
  return sum;
}

/// Columns of both bodies together, and of laws, that figures draw.
void add_drawn_columns(Table& table, const SphereRun& entry) {
  if (table.has("K_t1")) table.add_column({"K_t", dimension::energy}, sum_of(table, "K_t1", "K_t2"));
  if (table.has("W_total")) {
    const auto total = table.column("W_total");
    std::vector<double> change(total.begin(), total.end());
    for (double& w : change) w -= total[0];
    table.add_column({"W_change", dimension::energy}, std::move(change));
  }
  if (!entry.overlay) return;
  add_law_column(table, entry.result.curve.delta, *entry.overlay->law, entry.overlay->contact);
  const std::string column = fmt::format("F_{}", entry.overlay->law->name);
  if (table.has(column)) return;
  std::vector<double> force;
  for (const double delta : entry.result.curve.delta)
    force.push_back(entry.overlay->law->force(delta, entry.overlay->contact));
  table.add_column({column, dimension::force}, std::move(force));
}

RunWishes wishes_of(const RunTask& task, const Run& run) {
  const bool known = task.companion && task.companion->units == name(run.units);
  PlanWishes asked = plan_wishes(task);
  asked.modulus = known;
  RunWishes wishes;
  wishes.plan = plan_run(run, asked);
  wishes.potential = asked.potential;
  if (!known) return wishes;
  const Value& r = task.companion->radius;
  wishes.radii = Radii{{r.value, r.value}, fmt::format("Hertz fit of run {}", task.companion->name), 2 * r.error.value_or(0)};
  return wishes;
}

RunRecord sphere_record(const RunTask& task, const Run& run, const SweepOptions& sweeping) {
  SphereRun entry{task.name, run, analyse_run(run, wishes_of(task, run), sweeping)};
  Document document("report", run);
  const auto bodies = body_motion(entry.result.measured.swept.tables[0], 0);
  document.json("atoms", {bodies[0].atoms, bodies[1].atoms});
  const Overlay constants = constants_of(entry, task.companion);
  RunRecord record;
  record.tables.push_back({"frames", add_collision(document, run, entry.result, constants.contact, sweeping, false)});
  if (constants.contact.modulus > 0)
    document.json("constants", {{"E_star", constants.contact.modulus},
                                {"R_star", constants.contact.radius},
                                {"gamma", constants.contact.surface_energy},
                                {"source", constants.source}});
  choose_overlay(entry, constants, document);
  add_drawn_columns(record.tables[0].table, entry);
  if (entry.result.hertz) {
    add_hertz(document, run, *entry.result.hertz);
    record.tables.push_back({"fit", hertz_table(*entry.result.hertz, entry.result.curve)});
  }
  if (entry.result.defects) add_defects_to(record, *entry.result.defects, document);
  if (entry.overlay)
    document.json("overlay", {{"law", entry.overlay->law->name}, {"source", entry.overlay->source}});
  if (entry.result.plan.has(Part::accuracy)) {
    const AccuracySubject subject = run_subject(run, entry.result, sweeping);
    entry.accuracy = accuracy_rows(subject, subject.knobs);
  }
  if (entry.result.plan.has(Part::stability)) entry.stability = stability_rows(run, entry.result, sweeping);
  record.document = document.content();
  record.numbers = document.numbers();
  add_checks(record, entry.accuracy, entry.stability);
  record.figures = run_figures(entry);
  add_chosen_frames(record, task, run, record.tables[0].table, entry.result.radii,
                    entry.result.defects ? &*entry.result.defects : nullptr, sweeping);
  return record;
}

}  // namespace

PlanWishes plan_wishes(const RunTask& task) {
  PlanWishes wishes;
  wishes.parts = parts_of("report").value();
  wishes.structure = task.defects;
  wishes.pictures = task.snapshots;
  wishes.accuracy = task.accuracy;
  wishes.stability = task.stability;
  wishes.potential.log = task.log;
  return wishes;
}

RunRecord analyse_task(const RunTask& task, const SweepOptions& sweeping) {
  RunOptions options;
  options.dump = task.dump;
  options.scene = task.scene;
  const Run run = prepare_run(options);
  require_two_bodies(run);
  SweepOptions chosen = sweeping;
  if (!task.frames.empty()) chosen.choice = parse_frame_choice(task.frames);
  return run.scene.interaction == Interaction::aggregate ? aggregate_record(task, run, chosen)
                                                         : sphere_record(task, run, chosen);
}

}  // namespace mdana
