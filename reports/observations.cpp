// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/observations.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "fits/lj_particles.hpp"
#include "fits/repeats.hpp"
#include "readers/trajectory.hpp"
#include "readers/input_error.hpp"
#include "reports/hdf5_results.hpp"
#include "reports/whole_file.hpp"

namespace mdana {
namespace {

constexpr double same_radius = 0.005;  ///< relative: the paper itself has 88.2 for 88.4

bool is_hdf5(std::string_view text) { return text.starts_with("\x89HDF\r\n\x1a\n"); }

bool is_json(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

/// What one of the formats recognises, but for results of mdana, which are HDF5 as H5MD is.
bool is_dump(const std::filesystem::path& path) {
  const auto format = recognised_format(path);
  return format && (*format != "h5md" || !holds_results(path));
}

/// Files as they are read; what mdana compress tells waits for the others, since its errors are by repeats.
class Reading {
 public:
  explicit Reading(const ObservationSettings& settings) : settings_(settings) {}

  void read(const std::filesystem::path& path) {
    if (is_dump(path)) return read_dump(path);
    const WholeFile content = read_whole(path);
    const std::string place = path.string();
    if (is_hdf5(content.text))
      take(parse_observed_document(hdf5_document(path), place, settings_.wanted, motion_rows(path)), content.record);
    else if (is_json(content.text))
      take(parse_observed_document(content.text, place, settings_.wanted), content.record);
    else
      take(read_table(read_csv(content.text, place), place), content.record);
  }

  Observations finish() {
    set_errors_by_repeats(compressed_);
    std::ranges::move(compressed_, std::back_inserter(all_.seen));
    return std::move(all_);
  }

 private:
  void read_dump(const std::filesystem::path& path) {
    ObservedDump dump = observe_dump(path, settings_);
    all_.seen.push_back(std::move(dump.seen));
    for (const InputRecord& record : dump.records) all_.files.push_back({record, dump.format});
  }

  static ObservedDocument read_table(const CsvText& table, const std::string& place) {
    if (is_motion(table)) return {{observed_motion(table, place)}, "motion"};
    return {observed_collisions(table), "table"};
  }

  std::vector<MotionSample> motion_rows(const std::filesystem::path& path) const {
    return settings_.wanted == Wanted::motion ? hdf5_motion(path) : std::vector<MotionSample>();
  }

  void take(ObservedDocument read, const InputRecord& record) {
    std::ranges::move(read.seen, std::back_inserter(read.command == "compress" ? compressed_ : all_.seen));
    all_.files.push_back({record, read.command});
  }

  const ObservationSettings& settings_;
  Observations all_;
  std::vector<ObservedCollision> compressed_;
};

void require_one_kind(std::span<const ObservedCollision> seen) {
  const auto followed = [](const ObservedCollision& s) { return !s.motion.empty(); };
  const auto motion = std::ranges::find_if(seen, followed), other = std::ranges::find_if_not(seen, followed);
  if (motion != seen.end() && other != seen.end())
    throw InputError(fmt::format("{} is a motion, {} is a collision without one: fit them apart", motion->place,
                                 other->place));
}

/// What was seen with and what without an error; sticking collisions need none.
struct Errors {
  const ObservedCollision* with = nullptr;
  const ObservedCollision* without = nullptr;
  std::string_view what;
};

Errors errors_of(std::span<const ObservedCollision> seen) {
  Errors errors;
  for (const ObservedCollision& s : seen) {
    for (const MotionSample& sample : s.motion)
      if (!(sample.delta.error > 0)) errors.without = &s, errors.what = "delta";
    for (const auto& [name, m] : {std::pair{"e", &s.e}, {"delta_max", &s.delta_max}, {"t_max", &s.t_max}}) {
      if (!m->known() || (s.stuck && m == &s.e)) continue;
      if (m->error > 0)
        errors.with = errors.with ? errors.with : &s;
      else if (!errors.without)
        errors.without = &s, errors.what = name;
    }
  }
  return errors;
}

}  // namespace

bool Observations::given(std::string_view name) const {
  return std::ranges::any_of(seen, [&](const ObservedCollision& s) { return s.find(name).has_value(); });
}

Observations read_observations(std::span<const std::filesystem::path> files, const ObservationSettings& settings) {
  Reading reading(settings);
  for (const auto& path : files) reading.read(path);
  Observations all = reading.finish();
  require_one_kind(all.seen);
  const Errors errors = errors_of(all.seen);
  if (errors.with && errors.without)
    throw InputError(fmt::format("{}: {} has no standard error, but others have one ({}); give all or none",
                                 errors.without->place, errors.what, errors.with->place));
  all.known_errors = !errors.without;
  return all;
}

void fill_from_lj_particles(Observations& observations, std::span<const std::string> leave) {
  for (ObservedCollision& s : observations.seen) {
    const auto radius = s.find("R");
    if (!radius) throw InputError(fmt::format("{}: Table II is by R, which is not given", s.place));
    const auto particle = std::ranges::find_if(lj_particles, [&](const LjParticle& p) {
      return std::abs(p.radius - *radius) <= same_radius * p.radius;
    });
    if (particle == lj_particles.end())
      throw InputError(fmt::format("{}: R = {:g} is not in Table II (29.6, 58.9, 88.4, 147, 294)", s.place, *radius));
    for (const auto& [name, value] :
         {std::pair{"m", particle->atoms}, {"E", particle->modulus}, {"gamma", lj_surface_energy},
          {"nu", lj_poisson_ratio}, {"spacing", lj_spacing}})
      if (!s.find(name) && std::ranges::find(leave, name) == leave.end()) s.given.push_back({name, value});
  }
}

}  // namespace mdana
