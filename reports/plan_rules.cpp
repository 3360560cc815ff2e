// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts a scene calls for, what each needs, and why it is computed as it is.
#include "reports/plan_rules.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "fits/force_law.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

/// What the work throws; empty if it does not.
template <class Work>
std::string thrown(Work&& work) {
  try {
    work();
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string first_of(std::initializer_list<std::string> obstacles) {
  for (const std::string& text : obstacles)
    if (!text.empty()) return text;
  return {};
}

const AnalysisMember* member(std::string_view name) {
  for (const AnalysisMember* m : analysis_members())
    if (m->name == name) return m;
  return nullptr;
}

std::string not_built(std::string_view name) {
  return member(name) ? std::string() : fmt::format("this build has no {}", name);
}

// ---- what the scene calls for ----------------------------------------------------------------------------------------

constexpr const char* no_solid_sphere =
    "an aggregate of grains is no solid sphere and has no crystal lattice; mdana network tells of its contacts";

std::string of_spheres(const Asked& a) { return a.interaction() == Interaction::aggregate ? no_solid_sphere : ""; }

std::string of_aggregates(const Asked& a) {
  return a.interaction() == Interaction::aggregate ? "" : "the scene is not of aggregates";
}

std::string of_any(const Asked&) { return {}; }

std::string by_energy(const Asked& a) {
  return a.interaction() == Interaction::aggregate ? "not part of what a report tells of aggregates; mdana energy tells it" : "";
}

std::string of_repulsion(const Asked& a) {
  switch (a.interaction()) {
    case Interaction::hertz: return {};
    case Interaction::adhesive: return "the scene is adhesive: Hertz's law has no adhesion";
    case Interaction::aggregate: return no_solid_sphere;
    case Interaction::unknown: break;
  }
  return "the scene does not state a hertz interaction";
}

std::string of_attraction(const Asked& a) {
  switch (a.interaction()) {
    case Interaction::hertz: return "the scene has no attraction between bodies";
    case Interaction::aggregate: return no_solid_sphere;
    case Interaction::adhesive: return {};
    case Interaction::unknown: break;
  }
  return "the scene does not state an adhesive interaction";
}

std::string of_one_at_rest(const Asked& a) {
  if (a.run.bodies.count() != 2) return of_spheres(a);
  const char* collide = "it is that of a particle at rest, not of a collision; mdana surface-energy tells it";
  return first_of({of_attraction(a), collide});
}

std::string if_structure(const Asked& a) {
  return first_of({of_spheres(a), a.wishes.structure ? "" : "the study file says defects = false"});
}

std::string if_checked(bool wanted, const char* setting) {
  return wanted ? "" : fmt::format("the study file says {} = false", setting);
}
std::string if_pictures(const Asked& a) {
  return a.wishes.pictures ? "" : "they are not among the kinds of figures in the study file";
}
std::string if_accuracy(const Asked& a) { return if_checked(a.wishes.accuracy, "accuracy"); }
std::string if_stability(const Asked& a) { return if_checked(a.wishes.stability, "stability"); }

// ---- what the dump and the build allow -------------------------------------------------------------------------------

std::string two_bodies(const Asked& a) {
  const std::size_t count = a.run.bodies.count();
  if (count == 2) return {};
  return fmt::format("needs two bodies, {} found by {}", count, a.run.bodies.rule());
}

std::string a_force(const Asked& a) {
  return first_of({two_bodies(a), thrown([&] { a.source(); })});
}

std::string velocities(const Asked& a) {
  if (const std::string bodies = two_bodies(a); !bodies.empty()) return bodies;
  for (const char* column : {"vx", "vy", "vz"})
    if (!a.run.first.has_column(column))
      return fmt::format("no column {}; energies need the velocities of the atoms", column);
  return not_built("energy");
}

std::string a_layer(const Asked& a) {
  return first_of({two_bodies(a), thrown([&] { half_layer(a.run, a.wishes.layer); }), not_built("contact_radius")});
}

std::string a_patch(const Asked& a) { return first_of({a_layer(a), not_built("contact_patch")}); }

std::string potential(const Asked& a) {
  const std::string obstacle = velocities(a);
  return obstacle.empty() ? choose_potential(a.run, a.wishes.potential).obstacle : obstacle;
}

std::string a_law(const char* name) { return find_force_law(name) ? "" : "this build has no such law"; }

std::string hertz_law(const Asked& a) { return first_of({a_force(a), a_law("hertz")}); }

std::string an_attraction(const Asked& a) { return a.interaction() == Interaction::hertz ? of_attraction(a) : ""; }

std::string jkr_constants(const Asked& a) {
  return first_of({two_bodies(a), a.wishes.surface_energy ? "" : an_attraction(a), a_law("jkr"),
                   a.has_gamma() ? "" : gamma_not_known, a.wishes.modulus ? "" : modulus_not_known});
}

std::string energy_of_atoms(const Asked& a) {
  const auto known = [](const std::string& column) { return column.starts_with("c_pe"); };
  if (std::ranges::none_of(a.run.first.columns, known))
    return "no column of the atoms' potential energies (c_pe...); or add --energy U";
  if (!a.run.scene.cutoff) return "the cutoff of the potential is not known; add --cutoff LENGTH (or none)";
  return not_built("surface_energy");
}

std::string a_lattice(const Asked&) { return not_built("defects"); }

std::string times(const Asked& a) {
  if (!a.run.first.time && !a.run.timestep) return times_not_known;
  return first_of({a_force(a), not_built("halves")});
}

std::string grains(const Asked& a) {
  if (const std::string bodies = two_bodies(a); !bodies.empty()) return bodies;
  if (!a.wishes.grains && !a.run.first.has_column("radius") && !a.run.scene.grains.radius)
    return "no column 'radius', and the scene does not state [grains] radius";
  return not_built("contact_network");
}

// ---- why so, and from what -------------------------------------------------------------------------------------------

std::string force_source(const Asked& a) {
  const std::string why = a.wishes.source ? ", as asked for" : ", the best that the dump has";
  return fmt::format("from {}{}", name(a.source()), why);
}

std::string potential_source(const Asked& a) {
  if (!a.wishes.potential.log.empty()) return "of the log " + a.wishes.potential.log.string();
  return "column " + choose_potential(a.run, a.wishes.potential).column;
}

ColumnSet motion(const Asked& a) {
  ColumnSet columns{"x", "y", "z"};
  const ForceSource source = a.source();
  if (source == ForceSource::forces) columns.add(ColumnSet{"fx", "fy", "fz"});
  if (source == ForceSource::velocities) columns.add(ColumnSet{"vx", "vy", "vz"});
  return columns;
}

ColumnSet potential_column(const Asked& a) {
  ColumnSet columns;
  if (const std::string column = choose_potential(a.run, a.wishes.potential).column; !column.empty()) columns.add(column);
  return columns;
}

/// Of the member of the list as it makes itself for the run.
ColumnSet columns_of(const Asked& a, std::string_view name) {
  return member(name)->make({a.run.scene, a.run.first})->needs().columns;
}

ColumnSet positions(const Asked&) { return {"x", "y", "z"}; }
ColumnSet kinetic(const Asked&) { return {"x", "y", "z", "vx", "vy", "vz"}; }
ColumnSet of_the_lattice(const Asked& a) { return columns_of(a, "defects"); }

/// Grains are followed by id.
ColumnSet of_the_grains(const Asked& a) {
  ColumnSet columns = columns_of(a, "contact_network");
  if (a.run.first.has_column("id")) columns.add("id");
  return columns;
}

using Text = std::string;

const std::array all_rules{
    Rule{Part::force, "force", of_any, a_force, force_source, motion},
    Rule{Part::rotation, "rotation", by_energy, velocities,
         [](const Asked&) -> Text { return "its energy before and after, from positions and velocities"; }, kinetic},
    Rule{Part::restitution, "coefficient of restitution", of_any, a_force,
         [](const Asked&) -> Text { return "speeds before and after, if the bodies separate; 0 if they stick"; }, motion},
    Rule{Part::contact_radius, "contact radius", of_spheres, a_layer,
         [](const Asked&) -> Text { return "gyration of the atoms in the layer about the contact plane"; }, positions},
    Rule{Part::contact_areas, "contact radius by area and by neighbours", of_spheres, a_patch,
         [](const Asked&) -> Text { return "two more definitions, to tell how much the radius depends on it"; }, positions},
    Rule{Part::plasticity, "signs of plasticity", of_spheres, a_force,
         [](const Asked&) -> Text { return "far sides of the bodies, delta that is left, pressure of the contact"; }, positions},
    Rule{Part::energies, "energies", by_energy, velocities,
         [](const Asked&) -> Text { return "translation, heat and rotation of each body: the dump has velocities"; }, kinetic},
    Rule{Part::potential_energy, "W", by_energy, potential, potential_source, potential_column},
    Rule{Part::hertz_fit, "Hertz fit", of_repulsion, hertz_law,
         [](const Asked&) -> Text { return "E* and R: the bodies only repel each other"; }, motion},
    Rule{Part::jkr, "JKR (laws with adhesion)", of_attraction, jkr_constants,
         [](const Asked&) -> Text { return "beside what was measured: gamma and E* are known"; }, motion},
    Rule{Part::surface_energy, "surface energy", of_one_at_rest, energy_of_atoms,
         [](const Asked&) -> Text { return "of the particle at rest, from the energy of its atoms"; },
         [](const Asked& a) { return columns_of(a, "surface_energy"); }},
    Rule{Part::structure, "lattice defects", if_structure, a_lattice,
         [](const Asked&) -> Text { return "crystal structure of every atom, faults, twins"; }, of_the_lattice},
    Rule{Part::dislocations, "surfaces and dislocation lines", of_spheres, a_lattice,
         [](const Asked&) -> Text { return "of every frame"; }, of_the_lattice, "defects"},
    Rule{Part::compression, "compression of aggregates", of_aggregates, times,
         [](const Asked&) -> Text { return "delta_max and t_max by both splits of the grains"; },
         [](const Asked& a) { return columns_of(a, "halves"); }},
    Rule{Part::coordination, "coordination", of_aggregates, grains,
         [](const Asked&) -> Text { return "contacts of the grains in the first frame"; },
         of_the_grains},
    Rule{Part::network, "contact network", of_aggregates, grains,
         [](const Asked&) -> Text { return "contacts of the grains in every frame"; },
         of_the_grains, "network"},
    Rule{Part::pictures, "snapshots and views of defects", if_pictures, a_force,
         [](const Asked&) -> Text { return "start, maximum compression and end: these frames once more, with dislocation lines"; },
         [](const Asked&) { return ColumnSet{"x", "y", "z"}; }},
    Rule{Part::accuracy, "error against run time", if_accuracy, a_force,
         [](const Asked&) -> Text { return "the published numbers again, with fewer frames and other methods"; }, motion},
    Rule{Part::stability, "numerical stability", if_stability, a_force,
         [](const Asked&) -> Text { return "the published numbers again, with the last digits of the dump moved"; }, motion},
};

}  // namespace

std::span<const Rule> plan_rules() { return all_rules; }

}  // namespace mdana
