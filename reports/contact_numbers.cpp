// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/contact_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analyses/contact_patch.hpp"
#include "analyses/contact_radius.hpp"
#include "readers/clusters.hpp"
#include "readers/trajectory.hpp"

namespace mdana {
namespace {

#ifdef MDANA_WITH_CONTACT_PATCH
constexpr bool with_patch = true;
#else
constexpr bool with_patch = false;
#endif

/// A definition, the columns of its value and (with "_error") its error, and what it says.
struct Definition {
  std::string_view name, column, text;
};

constexpr std::array<Definition, 3> definitions{{
    {"gyration", "contact_radius", "sqrt(2) r_g of the atoms in the layer"},
    {"alpha", "contact_radius_alpha",
     "sqrt(A/pi), A the alpha shape of the layer's atoms with half a cell about its edge"},
    {"neighbours", "contact_radius_neighbours",
     "sqrt(A/pi), A the same of the atoms with one of the other body within the cutoff"},
}};

std::span<const Definition> measured_definitions() {
  return std::span(definitions).first(with_patch ? 3 : 1);
}

constexpr std::size_t spacing_sample = 20'000;  ///< atoms; enough for a median, quick to search

/// The positions nearest to the first one given, up to spacing_sample of them.
class Nearest {
 public:
  void add(const Eigen::Vector3d& position) {
    positions_.push_back(position);
    if (positions_.size() >= 2 * spacing_sample) cut();
  }
  std::vector<Eigen::Vector3d> take() {
    if (positions_.size() > spacing_sample) cut();
    return std::move(positions_);
  }

 private:
  /// A position that is not finite stays: it is refused later.
  void cut() {
    const Eigen::Vector3d centre = positions_.front();
    const auto distance = [&](const Eigen::Vector3d& p) {
      return centre.allFinite() && p.allFinite() ? (p - centre).squaredNorm() : -1.0;
    };
    std::nth_element(positions_.begin() + 1, positions_.begin() + spacing_sample, positions_.end(),
                     [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
                       return distance(p) < distance(q);
                     });
    positions_.resize(spacing_sample);
  }

  std::vector<Eigen::Vector3d> positions_;
};

/// Of the atoms of both bodies in the first frame, those about the first one.
std::vector<Eigen::Vector3d> first_positions(const Run& run) {
  Nearest positions;
  ColumnSet wanted{"x", "y", "z"};
  wanted.add(run.bodies.columns());
  std::vector<BodyIndex> body;
  const auto take = [&](const AtomBlock& block) {
    run.bodies.label(block, body);
    const auto x = block.real("x"), y = block.real("y"), z = block.real("z");
    for (std::size_t i = 0; i < body.size(); ++i)
      if (body[i] == 1 || body[i] == 2) positions.add({x[i], y[i], z[i]});
  };
  for_first_frame(run.dump, wanted, take, run.selection);
  return positions.take();
}

/// Median distance to the nearest neighbour in the first frame, of the atoms about the first one.
double first_spacing(const Run& run) {
  const std::vector<Eigen::Vector3d> positions = first_positions(run);
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = positions[i];
  return find_clusters(points).link_distance / 1.5;
}

/// The table that has a column; null if none has.
const Table* table_with(const MeasuredMotion& measured, std::string_view column) {
  for (const Table& table : measured.swept.tables)
    if (table.has(column)) return &table;
  return nullptr;
}

struct Series {
  std::span<const double> value, error;
  Value at(std::size_t i) const { return {value[i], error[i], dimension::length}; }
};

Series series(const MeasuredMotion& measured, const Definition& definition) {
  const Table* table = table_with(measured, definition.column);
  return {table->column(definition.column),
          table->column(std::string(definition.column) + "_error")};
}

std::size_t index_of_max(std::span<const double> values) {
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

}  // namespace

ContactSetup contact_setup(const Run& run, const ContactOptions& options) {
  ContactSetup setup;
  setup.half_layer = half_layer(run, options.layer);
  if (!with_patch) return setup;
  setup.spacing = options.spacing ? *options.spacing : told_of(run, [&] { return first_spacing(run); });
  setup.spacing_source = options.spacing ? "option" : "median of the first frame";
  setup.cutoff = options.cutoff.value_or(default_neighbour_cutoff * setup.spacing);
  return setup;
}

std::vector<std::unique_ptr<Analysis>> contact_analyses(const Radii& radii,
                                                        const ContactSetup& setup) {
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_contact_radius({radii.value, setup.half_layer}));
#ifdef MDANA_WITH_CONTACT_PATCH
  analyses.push_back(
      make_contact_patch({radii.value, setup.half_layer, setup.spacing, setup.cutoff}));
#endif
  return analyses;
}

ContactNumbers contact_numbers(const MeasuredMotion& measured, double radius_sum) {
  std::vector<double> delta;
  for (const double x : measured.motion.distance()) delta.push_back(radius_sum - x);
  const std::size_t turn = index_of_max(delta);
  ContactNumbers numbers;
  for (const Definition& definition : measured_definitions()) {
    const Series a = series(measured, definition);
    numbers.definitions.push_back({definition.name, a.at(index_of_max(a.value)), a.at(turn),
                                   a.at(a.value.size() - 1)});
  }
  const Series a = series(measured, definitions[0]);
  numbers.hysteresis = contact_hysteresis(delta, {a.value.begin(), a.value.end()},
                                          {a.error.begin(), a.error.end()});
  return numbers;
}

void add_contact_radius(Document& document, const ContactNumbers& numbers,
                        const ContactSetup& setup) {
  const auto length = [&](const std::string& name, double value) {
    document.number(name, {value, {}, dimension::length});
  };
  for (std::size_t k = 0; k < numbers.definitions.size(); ++k) {
    const ContactRadiusNumbers& n = numbers.definitions[k];
    const std::string name = fmt::format("contact_radius.{}.", n.definition);
    document.number(name + "max", n.max);
    document.number(name + "at_delta_max", n.at_delta_max);
    document.number(name + "end", n.end);
    if (n.definition == "neighbours")
      length(name + "cutoff", setup.cutoff);
    else
      length(name + "layer", 2 * setup.half_layer);
    if (n.definition == "alpha") length(name + "circumradius", greatest_circumradius * setup.spacing);
    document.json(name + "definition", definitions[k].text);
  }
  document.number("contact_radius.hysteresis", numbers.hysteresis.difference);
  document.number("contact_radius.hysteresis.at_delta", numbers.hysteresis.delta);
  document.json("contact_radius.hysteresis.definition", "gyration");
  if (!setup.spacing_source.empty()) {
    length("contact_radius.spacing", setup.spacing);
    document.json("contact_radius.spacing.source", setup.spacing_source);
  }
}

std::vector<std::string> contact_disagreements(const ContactNumbers& numbers, Units units) {
  std::vector<std::string> sentences;
  const auto compare = [&](const ContactRadiusNumbers& a, const ContactRadiusNumbers& b,
                           Value ContactRadiusNumbers::*which, std::string_view where) {
    const Value &x = a.*which, &y = b.*which;
    if (std::abs(x.value - y.value) <= std::hypot(*x.error, *y.error)) return;
    sentences.push_back(fmt::format("the contact radii by {} and by {} {} differ by more than their "
                                    "errors: {} and {}; state the definition with the number",
                                    a.definition, b.definition, where, to_text(x, units),
                                    to_text(y, units)));
  };
  const auto& all = numbers.definitions;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      compare(all[i], all[j], &ContactRadiusNumbers::at_delta_max, "at the greatest delta");
      compare(all[i], all[j], &ContactRadiusNumbers::end, "at the end");
    }
  return sentences;
}

void add_contact_columns(Table& table, const MeasuredMotion& measured) {
  for (std::size_t t = 1; t < measured.swept.tables.size(); ++t) {
    const Table& radii = measured.swept.tables[t];
    for (std::size_t k = 0; k < radii.columns().size(); ++k) {
      const auto column = radii.column(k);
      table.add_column(radii.columns()[k], {column.begin(), column.end()});
    }
  }
}

void add_law_column(Table& table, const std::vector<double>& delta, const ForceLaw& law,
                    const ElasticContact& contact) {
  std::vector<double> a;
  for (const double d : delta) a.push_back(law.contact_radius(d, contact));
  table.add_column({fmt::format("a_{}", law.name), dimension::length}, std::move(a));
}

}  // namespace mdana
