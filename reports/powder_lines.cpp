// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/powder_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/version.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

constexpr double pi = std::numbers::pi;

/// The numbers of a fit, by the names of the laws' parameters.
class Fitted {
 public:
  Fitted(const Json& fit, std::span<const NamedNumber> given, std::string place)
      : fit_(fit), given_(given), place_(std::move(place)) {
    law_ = find_collision_law(fit.value("law", ""));
    if (!law_ || !fit.contains("parameters") || !fit["parameters"].is_object())
      throw InputError(place_ + ": a document of 'mdana fit-contact --json' is expected");
    if (!fit.value("usable", false))
      throw InputError(fmt::format("{}: the fit is not usable: {}", place_, fit.value("reason", "")));
  }

  const CollisionLaw& law() const { return *law_; }
  const Json& document() const { return fit_; }

  /// Given, found, a constant, or the one value that all collisions had.
  std::optional<double> find(std::string_view name) const {
    for (const NamedNumber& n : given_)
      if (n.name == name) return n.value;
    const std::string key(name);
    if (const Json* found = at("parameters", key); found && found->is_object() && found->contains("value"))
      if ((*found)["value"].is_number()) return (*found)["value"].get<double>();
    if (const Json* found = at("constants", key); found && found->is_number()) return found->get<double>();
    if (const auto range = range_of(key); range && range->first == range->second) return range->first;
    return std::nullopt;
  }

  double need(const std::string& name) const {
    if (const auto x = find(name)) return *x;
    if (const auto range = range_of(name))
      throw InputError(fmt::format("{}: {} was {:g} to {:g}; choose one by -p {}=VALUE", place_, name, range->first,
                                   range->second, name));
    throw InputError(fmt::format("{}: {} is not known; give it by -p {}=VALUE", place_, name, name));
  }

  /// Least and greatest of the collisions.
  std::optional<std::pair<double, double>> range_of(const std::string& name) const {
    const Json* found = at("range", name);
    if (!found || !found->is_array() || found->size() != 2) return std::nullopt;
    if (!(*found)[0].is_number() || !(*found)[1].is_number()) return std::nullopt;
    return std::pair{(*found)[0].get<double>(), (*found)[1].get<double>()};
  }

  /// Relaxation time of the bulk, without pressure.
  std::optional<double> relaxation() const {
    if (const auto T = find("T_vis")) return T;
    if (law_->name == "stress") return need("C") * need("R");
    return std::nullopt;
  }

  double reduced_mass() const { return (find("m") ? need("m") : density() * 4 / 3 * pi * std::pow(need("R"), 3)) / 2; }

  double density() const {
    if (const auto rho = find("rho")) return *rho;
    return need("m") / (4.0 / 3.0 * pi * std::pow(need("R"), 3));
  }

  /// Of one sphere: E* = E/(2 (1 - nu^2)) for equal ones.
  double youngs_modulus() const {
    const double nu = need("nu");
    return 2 * (1 - nu * nu) * need("E");
  }

  /// Restitution of what is not adhesion, at -p v=VALUE or the middle of the velocities.
  std::pair<double, double> restitution() const;

 private:
  const Json* at(const char* object, const std::string& key) const {
    const auto outer = fit_.find(object);
    if (outer == fit_.end() || !outer->is_object()) return nullptr;
    const auto inner = outer->find(key);
    return inner == outer->end() ? nullptr : &*inner;
  }

  const Json& fit_;
  std::span<const NamedNumber> given_;
  std::string place_;
  const CollisionLaw* law_ = nullptr;
};

std::pair<double, double> Fitted::restitution() const {
  double v = 0;
  if (const auto given = find("v")) v = *given;
  else if (const auto range = range_of("v")) v = std::sqrt(range->first * range->second);
  else v = need("v");
  const auto T = relaxation();
  const CollisionLaw* law = T ? find_collision_law("viscous-hertz") : law_;
  const bool plastic = law_->name == "thornton" || law_->name == "andrews";
  if (!law || (!T && !plastic)) return {v, 1};
  ObservedCollision c;
  c.place = place_;
  c.given = {{"R", need("R")}, {"m", 2 * reduced_mass()}, {"E", need("E")}, {"v", v}};
  std::vector<NamedNumber> constants;
  if (T) constants = {{"nu", need("nu")}, {"T_vis", *T}};
  for (const char* name : {"Y", "v_Y"})
    if (const auto x = T ? std::nullopt : find(name)) constants.push_back({name, *x});
  return {v, collide(*law, input_of(*law, c, constants)).e};
}

std::string comment(const std::string& text) { return "# " + text + "\n"; }

std::string interval_text(const Json& parameter) {
  const auto interval = parameter.find("interval");
  if (interval != parameter.end() && interval->is_array() && interval->size() == 2 && (*interval)[0].is_number() &&
      (*interval)[1].is_number())
    return fmt::format(" ({:.6g} to {:.6g})", (*interval)[0].get<double>(), (*interval)[1].get<double>());
  const auto error = parameter.find("error");
  return error != parameter.end() && error->is_number() ? fmt::format(" +- {:.2g}", error->get<double>()) : "";
}

std::string head(const Fitted& fit, const std::string& place) {
  std::string text = comment(fmt::format("mdana {}: contact by law {}, from {}", version, fit.law().name, place));
  for (const auto& [name, parameter] : fit.document()["parameters"].items())
    if (parameter.is_object() && parameter.contains("value") && parameter["value"].is_number())
      text += comment(fmt::format("{} = {:.6g}{}", name, parameter["value"].get<double>(), interval_text(parameter)));
  for (const char* name : {"R", "v"})
    if (const auto range = fit.range_of(name))
      text += comment(fmt::format("fitted for {} from {:g} to {:g}; beyond that it is extrapolated", name, range->first,
                                  range->second));
  return text + comment("units are those of the tables; friction and rolling are not known from head-on collisions");
}

/// What the law has and the code has not.
std::string missing(const Fitted& fit) {
  const std::string_view law = fit.law().name;
  std::string text;
  if (law == "krijt" || law == "stress" || law == "krijt-plastic")
    text += comment("no counterpart: the delay of the contact radius (crack law)");
  if (law == "stress") text += comment("no counterpart: growth of T with pressure; T = C R is that at none");
  if (law == "power") text += comment("no counterpart: F_dis = D E* v^alpha a^beta; no dissipation is set");
  if (law == "krijt-plastic" || law == "thornton" || law == "andrews")
    text += comment("no counterpart: plastic yield");
  return text;
}

std::string lammps(const Fitted& fit) {
  const auto T = fit.relaxation();
  const double nu = fit.need("nu"), E = fit.youngs_modulus(), gamma = fit.find("gamma").value_or(0);
  const double eta = T ? 2 * *T * fit.need("E") / (nu * nu * fit.reduced_mass()) : 0;
  std::string text = comment(fmt::format("density {:.8g}", fit.density()));
  if (T)
    text += comment(fmt::format("damping: F = 2 T E*/nu^2 a v as eta_n0 a m* v, eta_n0 = 2 T E*/(nu^2 m*) for T = {:.6g} "
                                "and m* = {:.6g}: right for this mass only", *T, fit.reduced_mass()));
  text += "variable mu equal 0.5  # friction: choose\npair_style granular\n";
  text += gamma > 0 ? fmt::format("pair_coeff * * jkr {:.8g} {:.8g} {:.8g} {:.8g}", E, eta, gamma, nu)
                    : fmt::format("pair_coeff * * hertz/material {:.8g} {:.8g} {:.8g}", E, eta, nu);
  return text + " tangential mindlin NULL 1.0 ${mu} damping viscoelastic\n";
}

std::string liggghts(const Fitted& fit) {
  const auto [v, e] = fit.restitution();
  const double gamma = fit.find("gamma").value_or(0), E = fit.need("E"), R = fit.need("R") / 2;
  std::string text = comment(fmt::format("density {:.8g}", fit.density()));
  if (fit.youngs_modulus() < 5e6)
    text += comment("a modulus below 5e6: units si or cgs need 'soft_particles yes', units lj 'hard_particles yes'");
  text += fmt::format("fix youngs all property/global youngsModulus peratomtype {:.8g}\n", fit.youngs_modulus());
  text += fmt::format("fix poisson all property/global poissonsRatio peratomtype {:.8g}\n", fit.need("nu"));
  text += comment(fmt::format("restitution without adhesion at v = {:.6g}; it depends on v and size, here it is constant", v));
  text += fmt::format("fix restitution all property/global coefficientRestitution peratomtypepair 1 {:.6g}\n", e);
  text += "fix friction all property/global coefficientFriction peratomtypepair 1 0.5\n";
  if (!(gamma > 0)) return text + "pair_style gran model hertz tangential history\npair_coeff * *\n";
  // Hertz and k 4 pi R* delta: least force -(16/3) pi^3 R*^2 k^3/E*^2, as JKR's -3 pi gamma R*.
  const double k = std::cbrt(9 * gamma * E * E / (16 * pi * pi * R));
  text += comment(fmt::format("sjkr2 is not JKR: k is chosen so that the greatest attraction is 3 pi gamma R* = {:.6g}; "
                              "right for this size only", 3 * pi * gamma * R));
  text += fmt::format("fix cohesion all property/global cohesionEnergyDensity peratomtypepair 1 {:.8g}\n", k);
  return text + "pair_style gran model hertz tangential history cohesion sjkr2\npair_coeff * *\n";
}

std::string yade(const Fitted& fit) {
  const auto [v, e] = fit.restitution();
  const double gamma = fit.find("gamma").value_or(0);
  std::string text = fmt::format("O.materials.append(FrictMat(young={:.8g}, poisson={:.8g}, density={:.8g}, "
                                 "frictionAngle=0.46))\n", fit.youngs_modulus(), fit.need("nu"), fit.density());
  text += comment(fmt::format("en: restitution without adhesion at v = {:.6g}; it depends on v and size, here it is constant", v));
  if (e > 0.95)
    text += comment("Yade's damping loses more than en says near 1: en = 0.98 gives 0.972, 0.999 gives 0.984 (Yade 2023.02)");
  if (gamma > 0) text += comment("adhesion is DMT's, 4 pi gamma R*, not JKR's: no loss by pulling off");
  text += fmt::format("InteractionLoop(\n    [Ig2_Sphere_Sphere_ScGeom()],\n    [Ip2_FrictMat_FrictMat_MindlinPhys(");
  if (gamma > 0) text += fmt::format("gamma={:.8g}, ", gamma);
  text += fmt::format("en={:.6g}, es={:.6g})],\n    [Law2_ScGeom_MindlinPhys_Mindlin(includeAdhesion={})])\n", e, e,
                      gamma > 0 ? "True" : "False");
  return text;
}

}  // namespace

std::string powder_lines(PowderCode code, const Json& document, std::span<const NamedNumber> given,
                         const std::string& place) {
  const Fitted fit(document, given, place);
  const std::string before = head(fit, place) + missing(fit);
  switch (code) {
    case PowderCode::lammps: return before + lammps(fit);
    case PowderCode::liggghts: return before + liggghts(fit);
    case PowderCode::yade: break;
  }
  return before + yade(fit);
}

}  // namespace mdana
