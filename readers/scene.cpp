// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/scene.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "readers/input_error.hpp"
#include "readers/shown.hpp"
#include "readers/toml_text.hpp"

namespace mdana {
namespace {

constexpr std::array<std::string_view, 4> interaction_names{"unknown", "hertz", "adhesive",
                                                            "aggregate"};

/// One table of the file; values are taken out by name and the names that nobody took are errors.
class Reader {
 public:
  Reader(const toml::table& table, std::string path, std::string prefix = "")
      : table_(table), path_(std::move(path)), prefix_(std::move(prefix)) {}

  [[noreturn]] void fail(const toml::node& node, std::string_view key, std::string what) const {
    throw InputError(fmt::format("{}:{}: {}{}: {}", path_, node.source().begin.line, prefix_,
                                 shown(key), what));
  }

  std::string text(std::string_view key) {
    const toml::node* node = take(key);
    if (!node) return {};
    if (!node->is_string()) fail(*node, key, "a text in quotes is expected");
    return *node->value<std::string>();
  }

  std::optional<double> number(std::string_view key) {
    const toml::node* node = take(key);
    if (!node) return std::nullopt;
    const auto value = node->value<double>();
    if (!value || !std::isfinite(*value)) fail(*node, key, "a finite number is expected");
    return value;
  }

  std::optional<double> positive(std::string_view key) {
    const auto value = number(key);
    if (value && !(*value > 0)) fail(*table_.get(key), key, "must be greater than zero");
    return value;
  }

  std::optional<bool> truth(std::string_view key) {
    const toml::node* node = take(key);
    if (!node) return std::nullopt;
    if (!node->is_boolean()) fail(*node, key, "true or false is expected");
    return *node->value<bool>();
  }

  const toml::node* take(std::string_view key) {
    taken_.emplace_back(key);
    return table_.get(key);
  }

  void ignore(std::string_view key) { taken_.emplace_back(key); }

  void finish() const {
    for (const auto& [key, node] : table_)
      if (std::find(taken_.begin(), taken_.end(), key.str()) == taken_.end())
        fail(node, key.str(), "unknown key");
  }

  const std::string& path() const { return path_; }

 private:
  const toml::table& table_;
  std::string path_;
  std::string prefix_;
  std::vector<std::string> taken_;
};

const toml::table* subtable(Reader& reader, std::string_view key) {
  const toml::node* node = reader.take(key);
  if (node && !node->is_table()) reader.fail(*node, key, "a table is expected");
  return node ? node->as_table() : nullptr;
}

void read_units(Reader& reader, Scene& scene) {
  const std::string text = reader.text("units");
  if (text.empty()) return;
  scene.units = parse_units(text);
  if (!scene.units)
    reader.fail(*reader.take("units"), "units", fmt::format("unknown (known: {})", units_names()));
}

void read_interaction(Reader& reader, Scene& scene) {
  const std::string text = reader.text("interaction");
  if (text.empty()) return;
  const auto it = std::find(interaction_names.begin() + 1, interaction_names.end(), text);
  if (it == interaction_names.end())
    reader.fail(*reader.take("interaction"), "interaction", "hertz, adhesive or aggregate expected");
  scene.interaction = static_cast<Interaction>(it - interaction_names.begin());
}

void read_masses(Reader& reader, Scene& scene) {
  const toml::table* masses = subtable(reader, "masses");
  if (!masses) return;
  Reader entries(*masses, reader.path(), "masses.");
  for (const auto& [key, node] : *masses) {
    const std::string_view text = key.str();
    std::int64_t type = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), type);
    if (error != std::errc{} || end != text.data() + text.size())
      entries.fail(node, text, "the key must be an atom type, a whole number");
    scene.masses[type] = *entries.positive(text);
  }
}

/// Four numbers; anything else that stands there is not for mdana.
std::optional<std::array<double, 4>> read_orientation(Reader& body) {
  const toml::node* node = body.take("orientation");
  const toml::array* list = node ? node->as_array() : nullptr;
  if (!list || list->size() != 4) return std::nullopt;
  std::array<double, 4> turn{};
  for (std::size_t k = 0; k < turn.size(); ++k) {
    const auto value = list->get(k)->value<double>();
    if (!value || !std::isfinite(*value)) return std::nullopt;
    turn[k] = *value;
  }
  return turn;
}

void read_bodies(Reader& reader, Scene& scene) {
  const toml::node* node = reader.take("body");
  if (!node) return;
  if (!node->is_array_of_tables()) reader.fail(*node, "body", "[[body]] tables are expected");
  for (const toml::node& entry : *node->as_array()) {
    Reader body(*entry.as_table(), reader.path(), "body.");
    if (const auto radius = body.positive("radius")) scene.radii.push_back(*radius);
    scene.radius_definition = body.text("radius_definition");
    if (const auto turn = read_orientation(body)) scene.orientations.push_back(*turn);
    for (const char* key : {"name", "type", "atoms"}) body.ignore(key);
    body.finish();
  }
  if (!scene.radii.empty() && scene.radii.size() != node->as_array()->size())
    reader.fail(*node, "body", "every body or none must state its radius");
}

void read_material(Reader& reader, Scene& scene) {
  const toml::table* table = subtable(reader, "material");
  if (!table) return;
  Reader material(*table, reader.path(), "material.");
  scene.surface_energy = material.positive("gamma");
  scene.poisson_ratio = material.number("nu");
  material.finish();
}

void read_aggregate(Reader& reader, Scene& scene) {
  const toml::table* table = subtable(reader, "aggregate");
  if (!table) return;
  Reader aggregate(*table, reader.path(), "aggregate.");
  scene.filling_factor = aggregate.positive("filling_factor");
  if (scene.filling_factor && *scene.filling_factor > 1)
    aggregate.fail(*table->get("filling_factor"), "filling_factor", "must be at most 1");
  aggregate.finish();
}

void read_grains(Reader& reader, Scene& scene) {
  const toml::table* table = subtable(reader, "grains");
  if (!table) return;
  Reader grains(*table, reader.path(), "grains.");
  scene.grains.radius = grains.positive("radius");
  scene.grains.density = grains.positive("density");
  scene.grains.surface_energy = grains.positive("surface_energy");
  scene.grains.modulus = grains.positive("modulus");
  scene.grains.poisson_ratio = grains.number("poisson_ratio");
  if (const auto nu = scene.grains.poisson_ratio; nu && !(*nu > -1 && *nu <= 0.5))
    grains.fail(*table->get("poisson_ratio"), "poisson_ratio", "must be above -1 and at most 0.5");
  scene.grains.rolling_displacement = grains.positive("rolling_displacement");
  grains.finish();
}

Scene read(const toml::table& table, const std::filesystem::path& file) {
  Reader reader(table, file.string());
  Scene scene;
  scene.file = file;
  const auto schema = reader.number("schema");
  if (!schema || *schema != 1)
    throw InputError(fmt::format("{}: 'schema = 1' is expected", file.string()));
  scene.name = reader.text("name");
  scene.dump = reader.text("dump");
  read_units(reader, scene);
  read_interaction(reader, scene);
  scene.timestep = reader.positive("timestep");
  scene.sigma = reader.positive("sigma");
  scene.cutoff = reader.positive("cutoff");
  scene.shift = reader.truth("shift");
  scene.bodies = reader.text("bodies");
  read_masses(reader, scene);
  read_bodies(reader, scene);
  read_material(reader, scene);
  read_aggregate(reader, scene);
  read_grains(reader, scene);
  if (const toml::table* made = subtable(reader, "generator")) {
    Reader generator(*made, reader.path(), "generator.");
    scene.impact_velocity = generator.number("velocity");
    if (const toml::node* seed = generator.take("seed")) scene.seed = seed->value<double>();
  }
  reader.finish();
  return scene;
}

}  // namespace

std::string_view name(Interaction interaction) {
  return interaction_names[static_cast<std::size_t>(interaction)];
}

Scene load_scene(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file))
    throw InputError(fmt::format("{}: no such scene file", file.string()));
  try {
    return read(toml::parse(toml_text(file), file.string()), file);
  } catch (const toml::parse_error& e) {
    throw InputError(fmt::format("{}:{}: {}", file.string(), e.source().begin.line,
                                 e.description()));
  }
}

Scene scene_beside(const std::filesystem::path& dump) {
  const auto file = dump.parent_path() / "scene.toml";
  if (!std::filesystem::is_regular_file(file)) return {};
  Scene scene = load_scene(file);
  return scene.dump == dump.filename().string() ? scene : Scene{};
}

}  // namespace mdana
