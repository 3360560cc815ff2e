// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/fits.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/compression_study.hpp"
#include "reports/contact_fitted.hpp"
#include "reports/hertz_sizes.hpp"
#include "reports/observations.hpp"
#include "reports/study/aggregate_record.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;
using Runs = std::span<const ReportedRun* const>;

constexpr double same_filling = 0.01;  ///< relative: aggregates of one filling factor

/// Usable Hertz fits of one system of units; several systems are not pooled.
void fit_sizes(Runs runs, StudyFits& fits) {
  std::vector<HertzRun> hertz;
  Document document("fit-hertz");
  for (const ReportedRun* run : runs) {
    const Value *modulus = run->number("E_star"), *radius = run->number("R");
    const auto usable = run->document.find("usable");
    if (!modulus || !radius || usable == run->document.end() || *usable != true) continue;
    document.set_units(run->units());
    hertz.push_back({run->document.value("/atoms/0"_json_pointer, 0.0), *modulus, *radius});
  }
  if (hertz.empty()) return fits.left_out.push_back({"E* against R", "no Hertz fit is usable"});
  const std::vector<HertzSize> sizes = pool_by_size(hertz);
  add_sizes(document, sizes);
  fits.sizes = document.content();
  fits.tables.push_back({"sizes", size_table(sizes)});
}

/// What laws need of a run besides what its document gives: E* of the Hertz run, gamma, nu, spacing.
void give_constants(const ReportedRun& run, ObservedCollision& seen) {
  const auto give = [&](const char* name, double value) {
    if (value > 0 && !seen.find(name)) seen.given.push_back({name, value});
  };
  give("E", run.document.value("/constants/E_star"_json_pointer, 0.0));
  give("gamma", run.scene.surface_energy.value_or(0));
  give("nu", run.scene.poisson_ratio.value_or(0));
  const Value* spacing = run.number("contact_radius.spacing");
  if (spacing) give("spacing", spacing->value);
}

/// The collisions of a group that tell e or sticking.
std::vector<ObservedCollision> observed_in(Runs runs, const std::string& group) {
  std::vector<ObservedCollision> all;
  for (const ReportedRun* run : runs) {
    if (run->group != group || run->aggregate() || !run->measured()) continue;
    try {
      auto seen = parse_observed_document(run->document.dump(), run->name, Wanted::restitution).seen.front();
      give_constants(*run, seen);
      all.push_back(std::move(seen));
    } catch (const InputError&) {  // an outcome that is not known, or no speed before: tells nothing
    }
  }
  return all;
}

bool given_in(const std::vector<ObservedCollision>& seen, const std::string& name) {
  return std::ranges::any_of(seen, [&](const ObservedCollision& s) { return s.find(name).has_value(); });
}

void fit_law(const CollisionLaw& law, const std::string& group, const std::vector<ObservedCollision>& seen, StudyFits& fits) {
  const std::string what = fmt::format("law {} of group '{}'", law.name, group);
  ContactFitSettings settings;
  settings.free = usual_free_parameters(law);
  std::erase_if(settings.free, [&](const FreeParameter& f) { return given_in(seen, f.name); });
  const std::size_t least = settings.free.empty() ? 1 : 2;
  if (seen.size() < least)
    return fits.left_out.push_back({what, fmt::format("{} collision{} of the group tell{} e or sticking; at least {} needed",
                                                      seen.size(), seen.size() == 1 ? "" : "s", seen.size() == 1 ? "s" : "",
                                                      least == 1 ? "one is" : "two are")});
  try {
    const ContactFit fit = fit_contact(law, seen, settings);
    Document document("fit-contact");
    document.text("group", group);
    add_contact_fit(document, law, settings, seen, fit);
    fits.laws.push_back(document.content());
    if (fit.usable) std::ranges::move(curves_of(law, group, seen, fit), std::back_inserter(fits.curves));
  } catch (const InputError& error) {
    fits.left_out.push_back({what, error.what()});
  }
}

void fit_laws(Runs runs, const std::vector<std::string>& laws, StudyFits& fits) {
  std::map<std::string, std::vector<ObservedCollision>> groups;
  for (const ReportedRun* run : runs)
    if (!run->aggregate() && run->measured() && !groups.contains(run->group))
      groups[run->group] = observed_in(runs, run->group);
  for (const std::string& name : laws)
    for (const auto& [group, seen] : groups) fit_law(*find_collision_law(name), group, seen, fits);
}

/// Aggregates by their filling factor; those without one together.
std::vector<std::vector<CompressedRun>> by_filling(std::vector<CompressedRun> runs) {
  std::ranges::stable_sort(runs, {}, [](const CompressedRun& r) { return r.filling_factor.value_or(0); });
  std::vector<std::vector<CompressedRun>> all;
  for (CompressedRun& run : runs) {
    const double least = all.empty() ? 0 : all.back().front().filling_factor.value_or(0);
    if (all.empty() || run.filling_factor.value_or(0) > (1 + same_filling) * least) all.emplace_back();
    all.back().push_back(std::move(run));
  }
  return all;
}

/// phi, E* and Y of a fit that determines them.
void add_filling(const CompressionStudy& study, double phi, Table& fillings) {
  if (!study.fits || !study.fits->both.usable) return;
  std::array<double, 5> row{phi, 0, 0, 0, 0};
  for (const Estimate& p : study.fits->both.parameters) {
    const std::size_t at = p.name == "E" ? 1 : 3;
    row[at] = p.value;
    row[at + 1] = p.error;
  }
  fillings.add_row(row);
}

void fit_aggregates(std::vector<CompressedRun> runs, const std::map<std::string, std::string>& groups, StudyFits& fits) {
  Table fillings({{"phi", {}}, {"E_star", dimension::pressure}, {"E_star_error", dimension::pressure},
                  {"Y", dimension::pressure}, {"Y_error", dimension::pressure}});
  for (std::vector<CompressedRun>& together : by_filling(std::move(runs))) {
    const auto phi = together.front().filling_factor;
    const std::string what = phi ? fmt::format("aggregates of filling factor {:g} together", *phi) : "aggregates together";
    if (together.size() < 2) {
      fits.left_out.push_back({what, "there is one run of them"});
      continue;
    }
    try {
      const CompressionStudy study = study_compression(std::move(together), study_split, {});
      Document document("compress");
      if (phi) document.json("phi", *phi);
      add_compression_study(document, study);
      fits.aggregates.push_back(document.content());
      std::ranges::move(curves_of(study, groups), std::back_inserter(fits.curves));
      if (phi) add_filling(study, *phi, fillings);
    } catch (const InputError& error) {
      fits.left_out.push_back({what, error.what()});
    }
  }
  if (fillings.rows() > 0) fits.tables.push_back({"fillings", fillings});
}

}  // namespace

StudyFits fit_study(Runs runs, std::vector<CompressedRun> aggregates, const StudySettings& settings) {
  StudyFits fits;
  fits.laws = fits.aggregates = Json::array();
  try {
    if (settings.sizes) fit_sizes(runs, fits);
  } catch (const InputError& error) {
    fits.left_out.push_back({"E* against R", error.what()});
  }
  fit_laws(runs, settings.laws, fits);
  std::map<std::string, std::string> groups;
  for (const ReportedRun* run : runs) groups[run->name] = run->group;
  if (settings.aggregates) fit_aggregates(std::move(aggregates), groups, fits);
  return fits;
}

}  // namespace mdana
