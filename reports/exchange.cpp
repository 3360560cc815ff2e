// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "analyses/energy.hpp"
#include "analyses/motion.hpp"
#include "readers/input_error.hpp"
#include "readers/trajectory.hpp"

namespace mdana {
namespace {

/// Atoms of no body, body 1 and body 2 (rows) in each cluster (columns; 0: in none).
using Overlap = std::array<std::vector<double>, 3>;

Overlap overlap(const Run& run, const Bodies& clusters, std::uint64_t frame) {
  Overlap counts;
  for (auto& row : counts) row.assign(clusters.count() + 1, 0);
  ColumnSet wanted = run.bodies.columns();
  wanted.add(clusters.columns());
  std::vector<BodyIndex> body, cluster;
  const auto take = [&](const AtomBlock& block) {
    run.bodies.label(block, body);
    clusters.label(block, cluster);
    for (std::size_t i = 0; i < body.size(); ++i)
      if (body[i] <= 2) ++counts[body[i]][cluster[i]];
  };
  for_frame(run.dump, frame, wanted, take, run.selection);
  return counts;
}

/// The cluster, from 1, that holds most of a body.
std::size_t main_cluster(const std::vector<double>& atoms) {
  return static_cast<std::size_t>(std::max_element(atoms.begin() + 1, atoms.end()) - atoms.begin());
}

/// Numbers 1 and 2 for the clusters of bodies 1 and 2.
Bodies as_bodies(const Bodies& clusters, std::size_t of_body1, std::size_t of_body2) {
  std::vector<BodyIndex> number(clusters.count(), 0);
  number[of_body1 - 1] = 1;
  number[of_body2 - 1] = 2;
  return clusters.renumbered(number);
}

void compare(const Run& run, std::uint64_t frame, Exchange& found) {
  const Bodies clusters = clusters_of_frame(run.dump, run.first, frame, run.selection);
  const Overlap counts = overlap(run, clusters, frame);
  const std::size_t one = clusters.count() ? main_cluster(counts[1]) : 0;
  const std::size_t two = clusters.count() ? main_cluster(counts[2]) : 0;
  if (one == two) {
    found.obstacle = "both bodies are in one cluster in the last frame";
    return;
  }
  found.to_other = {counts[1][two], counts[2][one]};
  for (std::size_t c = 0; c <= clusters.count(); ++c)
    if (c != one && c != two) found.loose += counts[1][c] + counts[2][c];
  found.final_bodies = as_bodies(clusters, one, two);
}

/// a/b, errors as of independent numbers.
Value ratio(const Value& a, const Value& b) {
  Value result{a.value / b.value, {}, dimension::none};
  if (a.error && b.error)
    result.error = std::hypot(*a.error, result.value * *b.error) / std::abs(b.value);
  return result;
}

/// Frame of the dump that is the i-th one used.
std::uint64_t frame_of(const FrameChoice& choice, std::size_t i) {
  return choice.first + choice.stride * i;
}

void add_energies(Document& document, const std::string& prefix, const SeparatedEnergies& energies) {
  document.number(prefix + ".K_p_after", energies.K_p);
  document.number(prefix + ".K_t_after", energies.K_t);
  document.number(prefix + ".e", energies.e);
  document.number(prefix + ".e_total", energies.e_total);
}

void warn_of_exchange(Document& document, const Exchange& found) {
  document.warn(fmt::format("{:.0f} atoms of body 1 and {:.0f} of body 2 are with the other one at the "
                            "end, {:.0f} with neither: K_t by the bodies of the first frame holds their "
                            "motion; see by_final_clusters",
                            found.to_other[0], found.to_other[1], found.loose));
}

}  // namespace

Exchange find_exchange(const Run& run, std::uint64_t frame) {
  Exchange found;
  if (!run.first.has_column("id")) {
    found.obstacle = "the dump has no column id to follow atoms by";
    return found;
  }
  try {
    compare(run, frame, found);
  } catch (const InputError& error) {
    found.obstacle = error.what();
  }
  return found;
}

SeparatedEnergies by_first_frame(const SeparatedRun& s) {
  return {window_mean(s.energy.K_p_rel, s.after, dimension::energy),
          window_mean(s.energy.thermal(), s.after, dimension::energy), s.restitution.e,
          s.restitution.e_total};
}

SeparatedEnergies by_final_clusters(const SeparatedRun& s, const Bodies& bodies) {
  SweepOptions options = s.sweeping;
  options.choice = {frame_of(s.sweeping.choice, s.after.first),
                    frame_of(s.sweeping.choice, s.after.last - 1) + 1, s.sweeping.choice.stride};
  options.selection = s.run.selection;
  options.progress = nullptr;
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_motion({true, false}));
  analyses.push_back(make_energy(""));
  const SweepResult swept = sweep(s.run.dump, bodies, s.run.masses, analyses, options);
  const EnergyCurve energy = energy_curve(swept.tables[0], swept.tables[1], s.run.units);
  const Eigen::Vector3d normal = impact_normal(s.measured.motion, s.curve);
  std::vector<double> along, whole;
  for (std::size_t i = 0; i < swept.tables[0].rows(); ++i) {
    const auto [a, b] = body_motion(swept.tables[0], i);
    along.push_back(normal.dot(b.velocity - a.velocity));
    whole.push_back((b.velocity - a.velocity).norm());
  }
  const EnergyWindow all{0, along.size()};
  return {window_mean(energy.K_p_rel, all, dimension::energy),
          window_mean(energy.thermal(), all, dimension::energy),
          ratio(window_mean(along, all, dimension::velocity), s.restitution.speed_before),
          ratio(window_mean(whole, all, dimension::velocity), s.restitution.speed_before_total)};
}

void add_exchange(Document& document, const SeparatedRun& s) {
  const std::string what = "exchanged atoms";
  if (s.curve.outcome != Outcome::bounce)
    return document.left_out(what, "the bodies do not separate");
  if (s.run.first.atoms > most_atoms_clustered && !s.asked)
    return document.left_out(what, "many atoms: ask for them by --final-clusters");
  if (!s.restitution.reason.empty()) return document.left_out(what, s.restitution.reason);
  const Exchange found =
      find_exchange(s.run, frame_of(s.sweeping.choice, s.measured.motion.steps.size() - 1));
  if (!found.obstacle.empty()) return document.left_out(what, found.obstacle);
  document.json("exchanged", {{"from_body1", found.to_other[0]},
                              {"from_body2", found.to_other[1]},
                              {"loose", found.loose},
                              {"bodies", found.final_bodies->rule()}});
  document.line("exchanged", fmt::format("{:.0f} and {:.0f} atoms, {:.0f} loose", found.to_other[0],
                                         found.to_other[1], found.loose));
  const SeparatedEnergies first = by_first_frame(s);
  add_energies(document, "by_first_frame", first);
  add_energies(document, "by_final_clusters",
               found.any() ? by_final_clusters(s, *found.final_bodies) : first);
  if (found.any()) warn_of_exchange(document, found);
}

}  // namespace mdana
