// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/network.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analyses/local_filling.hpp"
#include "fits/aggregate_constants.hpp"
#include "readers/last_digit.hpp"
#include "readers/positions.hpp"
#include "readers/trajectory.hpp"

namespace mdana {
namespace {

void complete(Grains& grains, const Grains& scene) {
  const auto take = [](std::optional<double>& value, const std::optional<double>& other) {
    if (!value) value = other;
  };
  take(grains.surface_energy, scene.surface_energy);
  take(grains.modulus, scene.modulus);
  take(grains.poisson_ratio, scene.poisson_ratio);
  take(grains.rolling_displacement, scene.rolling_displacement);
}

/// The radius of every grain; nothing if the dump's column tells them. The option comes first.
std::optional<double> settle_radius(const Run& run, const Grains& given, std::string& source) {
  source = "option";
  if (given.radius) return given.radius;
  source = "column radius";
  if (run.first.has_column("radius")) return std::nullopt;
  source = "scene";
  if (run.scene.grains.radius) return run.scene.grains.radius;
  throw InputError(
      fmt::format("{}: the dump has no column 'radius'; add --grain-radius LENGTH, or "
                  "[grains] radius in the scene file",
                  run.first.place));
}

std::vector<Grain> first_grains(const Run& run, const std::optional<double>& radius) {
  ColumnSet wanted{"x", "y", "z"};
  const bool followed = run.first.has_column("id");
  if (!radius) wanted.add("radius");
  if (followed) wanted.add("id");
  wanted.add(run.bodies.columns());
  std::vector<Grain> grains;
  std::vector<BodyIndex> body;
  for_first_frame(
      run.dump, wanted,
      [&](const AtomBlock& block) {
        run.bodies.label(block, body);
        const auto x = block.real("x"), y = block.real("y"), z = block.real("z");
        for (std::size_t i = 0; i < x.size(); ++i)
          if (body[i] == 1 || body[i] == 2)
            grains.push_back({{x[i], y[i], z[i]},
                              radius ? *radius : block.real("radius")[i],
                              body[i],
                              followed ? block.integer("id")[i] : 0});
      },
      run.selection);
  return grains;
}

/// Grains are followed by id, from positions that are not wrapped: the first frame is read by
/// itself.
std::string why_not_followed(const Run& run) {
  if (!run.first.has_column("id")) return "the dump has no column 'id' to follow grains by";
  if (position_source(run.first.columns)->may_jump(run.first.box))
    return "positions are wrapped at periodic faces; dump xu yu zu";
  return {};
}

std::shared_ptr<const ReferenceNetwork> reference_of(std::span<const Grain> grains,
                                                     std::span<const GrainContact> contacts) {
  auto reference = std::make_shared<ReferenceNetwork>();
  for (const Grain& grain : grains) reference->ids.push_back(grain.id);
  std::sort(reference->ids.begin(), reference->ids.end());
  reference->touching = touching_pairs(grains, contacts);
  return reference;
}

/// Frames of a list of contacts, asked for by ascending steps.
class ListedFrames {
 public:
  explicit ListedFrames(const NetworkOptions& options)
      : dump_(options.contacts, options.contact_columns) {}

  /// Null if the list has no such step.
  const LocalFrame* at(std::int64_t step) {
    while (!ended_ && (!frame_ || frame_->step < step)) {
      frame_ = dump_.next();
      ended_ = !frame_;
    }
    return frame_ && frame_->step == step ? &*frame_ : nullptr;
  }

 private:
  LocalDump dump_;
  std::optional<LocalFrame> frame_;
  bool ended_ = false;
};

void take_list(const Run& run, const NetworkOptions& options, NetworkSetup& setup) {
  if (options.contacts.empty()) return;
  if (!run.first.has_column("id"))
    throw InputError(fmt::format("{}: contacts are listed by id, but the dump has no column 'id'",
                                 run.first.place));
  setup.list = LocalDump(options.contacts, options.contact_columns).record();
  const auto frames = std::make_shared<ListedFrames>(options);
  setup.settings.listed = [frames](std::int64_t step) { return frames->at(step); };
}

/// Contacts of the first frame, as later frames have theirs.
std::vector<GrainContact> first_contacts(const Run& run, std::span<const Grain> grains,
                                         const NetworkOptions& options, const GrainLaw& law) {
  std::vector<GrainContact> contacts = told_of(run, [&] { return find_contacts(grains, law); });
  if (options.contacts.empty()) return contacts;
  ListedFrames frames(options);
  if (const LocalFrame* list = frames.at(run.first.step))
    decide_by_list(grains, contacts, list->contacts);
  return contacts;
}

/// Value that 99 of 100 are not above.
double high_percentile(std::vector<double> values) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Three standard deviations of the force at rest that come of the printed digits of two positions.
double force_noise(const Run& run, const ElasticContact& contact) {
  return 3 * std::sqrt(2.0) * rounding_of(run.dump, "x") * contact_stiffness(contact);
}

/// JKR of the grains, if gamma, E and nu are known.
void settle_law(const Run& run, const NetworkOptions& options, NetworkSetup& setup) {
  const Grains& g = setup.grains;
  const std::size_t known =
      g.surface_energy.has_value() + g.modulus.has_value() + g.poisson_ratio.has_value();
  const std::string missing =
      "--surface-energy, --grain-modulus and --poisson-ratio, or [grains] in the scene file";
  if (known == 1 || known == 2)
    throw InputError(
        fmt::format("{}: forces need gamma, E and nu of the grains, and {} is not known; add {}",
                    run.dump.string(),
                    !g.surface_energy ? "gamma"
                    : !g.modulus      ? "E"
                                      : "nu",
                    missing));
  const ForceLaw* jkr = find_force_law("jkr");
  if (known == 0 || !jkr) {
    setup.no_contact = jkr ? "gamma, E and nu of the grains are not known; add " + missing
                           : "this build has no law jkr";
    return;
  }
  const ElasticContact contact =
      grain_contact(*g.radius, *g.modulus, *g.poisson_ratio, *g.surface_energy);
  setup.contact = contact;
  const auto of = [contact](double reduced) {
    ElasticContact c = contact;
    c.radius = reduced;
    return c;
  };
  setup.settings.law = {
      [=](double overlap, double reduced) { return jkr->force(overlap, of(reduced)); },
      [=](double reduced) { return jkr->least_delta(of(reduced)); }};
  setup.settings.force_noise = force_noise(run, contact);
  setup.settings.strong_force =
      options.strong_share.value_or(default_strong_share) * pull_force(contact);
}

void settle_filling(const Run& run, const Radii& radii, std::span<const Grain> grains,
                    NetworkSetup& setup) {
  setup.filling_source = "scene";
  if (run.scene.filling_factor) {
    setup.filling = *run.scene.filling_factor;
    return;
  }
  const auto cube = [](double r) { return r * r * r; };
  const double whole = std::max(radii.value[0], radii.value[1]);
  for (const Grain& grain : grains) setup.filling += cube(grain.radius / whole);
  setup.filling /= cube(radii.value[0] / whole) + cube(radii.value[1] / whole);
  setup.filling_source = "grains of the first frame over the bodies' spheres";
}

}  // namespace

NetworkSetup network_setup(const Run& run, const Radii& radii, const NetworkOptions& options) {
  NetworkSetup setup;
  setup.grains = options.grains;
  complete(setup.grains, run.scene.grains);
  setup.settings.radius = radii.value;
  setup.settings.grain_radius = settle_radius(run, options.grains, setup.radius_source);
  const std::vector<Grain> grains = first_grains(run, setup.settings.grain_radius);
  if (grains.empty()) throw InputError(run.first.place + ": no grains in the bodies");
  const auto [least, most] = std::ranges::minmax_element(grains, {}, &Grain::radius);
  setup.count = grains.size();
  setup.smallest = least->radius;
  setup.largest = most->radius;
  setup.grains.radius = mean_radius(grains);
  settle_law(run, options, setup);
  settle_filling(run, radii, grains, setup);
  take_list(run, options, setup);
  const auto contacts = first_contacts(run, grains, options, setup.settings.law);
  setup.settings.compacted =
      options.compacted ? *options.compacted : high_percentile(local_filling(grains));
  setup.not_followed = why_not_followed(run);
  if (setup.not_followed.empty()) setup.settings.reference = reference_of(grains, contacts);
  return setup;
}

MeasuredNetwork measure_network(const Run& run, const Radii& radii, const NetworkSetup& setup,
                                SweepOptions options) {
  options.selection = run.selection;
  if (setup.list) options.threads = 1;  // the list is read in its order
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_motion({}));
  analyses.push_back(make_contact_network(setup.settings));
  MeasuredNetwork measured;
  measured.swept = sweep(run.dump, run.bodies, run.masses, analyses, options);
  const Table &motion = measured.swept.tables[0], &network = measured.swept.tables[1];
  if (setup.list &&
      std::ranges::all_of(network.column("listed"), [](double n) { return std::isnan(n); }))
    throw InputError(setup.list->path + ": lists no contacts at a step of the dump's frames");
  std::vector<double> distance, delta;
  for (std::size_t row = 0; row < motion.rows(); ++row) {
    const auto [a, b] = body_motion(motion, row);
    distance.push_back((b.position - a.position).norm());
    delta.push_back(radii.sum() - distance.back());
  }
  measured.most_compressed =
      static_cast<std::size_t>(std::ranges::max_element(delta) - delta.begin());
  Table& table = measured.table;
  const auto& steps = measured.swept.steps;
  table.add_column({"step", dimension::none}, std::vector<double>(steps.begin(), steps.end()));
  if (const auto times = frame_times(run, measured.swept); !times.empty())
    table.add_column({"time", dimension::time}, times);
  table.add_column({"X", dimension::length}, distance);
  table.add_column({"delta", dimension::length}, delta);
  for (std::size_t c = 0; c < network.columns().size(); ++c)
    table.add_column(network.columns()[c], {network.column(c).begin(), network.column(c).end()});
  return measured;
}

}  // namespace mdana
