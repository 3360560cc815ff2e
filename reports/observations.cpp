// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/observations.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "fits/lj_particles.hpp"
#include "fits/repeats.hpp"
#include "readers/input_error.hpp"
#include "reports/whole_file.hpp"
#ifdef MDANA_WITH_HDF5
#include "readers/hdf5.hpp"
#endif

namespace mdana {
namespace {

constexpr double same_radius = 0.005;  ///< relative: the paper itself has 88.2 for 88.4

/// The JSON document in an HDF5 file of mdana.
std::string hdf5_document(const std::filesystem::path& path) {
#ifdef MDANA_WITH_HDF5
  const hdf5::Group file = hdf5::open_file(path);
  if (!file.has_dataset("document"))
    throw InputError(fmt::format("{}: no results of mdana: it has no dataset 'document'", path.string()));
  const std::vector<std::string> texts = file.dataset("document").read_texts({});
  return texts.empty() ? std::string() : texts.front();
#else
  throw InputError(fmt::format("{}: this build does not read HDF5; give the JSON document instead", path.string()));
#endif
}

bool is_hdf5(std::string_view text) { return text.starts_with("\x89HDF\r\n\x1a\n"); }

bool is_json(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

/// Adds what a file tells; what mdana compress tells, to `compressed`.
void read_file(const std::filesystem::path& path, Wanted wanted, Observations& all,
               std::vector<ObservedCollision>& compressed) {
  WholeFile content = read_whole(path);
  const bool hdf5 = is_hdf5(content.text);
  if (hdf5) content.text = hdf5_document(path);
  ObservedDocument read = hdf5 || is_json(content.text)
                              ? parse_observed_document(content.text, path.string(), wanted)
                              : ObservedDocument{parse_collision_table(content.text, path.string()), "table"};
  auto& into = read.command == "compress" ? compressed : all.seen;
  std::ranges::move(read.seen, std::back_inserter(into));
  all.files.push_back({content.record, read.command});
}

/// What was seen with and what without an error; sticking collisions need none.
struct Errors {
  const ObservedCollision* with = nullptr;
  const ObservedCollision* without = nullptr;
  std::string_view what;
};

Errors errors_of(std::span<const ObservedCollision> seen) {
  Errors errors;
  for (const ObservedCollision& s : seen)
    for (const auto& [name, m] : {std::pair{"e", &s.e}, {"delta_max", &s.delta_max}, {"t_max", &s.t_max}}) {
      if (!m->known() || (s.stuck && m == &s.e)) continue;
      if (m->error > 0)
        errors.with = errors.with ? errors.with : &s;
      else if (!errors.without)
        errors.without = &s, errors.what = name;
    }
  return errors;
}

}  // namespace

bool Observations::given(std::string_view name) const {
  return std::ranges::any_of(seen, [&](const ObservedCollision& s) { return s.find(name).has_value(); });
}

Observations read_observations(std::span<const std::filesystem::path> files, Wanted wanted) {
  Observations all;
  std::vector<ObservedCollision> compressed;
  for (const auto& path : files) read_file(path, wanted, all, compressed);
  set_errors_by_repeats(compressed);
  std::ranges::move(compressed, std::back_inserter(all.seen));
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
