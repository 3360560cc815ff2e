// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "readers/scratch_file.hpp"
#include "reports/analysed_run.hpp"
#include "reports/extreme/judged.hpp"
#include "reports/extreme/made_up_collision.hpp"

namespace mdana {
namespace {

/// Published numbers of a collision, and all that was told.
struct Told {
  std::vector<PublishedValue> numbers;
  double low = 0;  ///< delta where the loop begins and ends
  std::string warnings;
};

RunOptions options_for(const MadeUpCollision& c, const ScratchFile& dump) {
  RunOptions options;
  options.dump = dump.path();
  options.units = parse_units(c.units);
  options.bodies = "type";
  options.timestep = c.interval / static_cast<double>(c.step_interval) * c.time;
  options.radius = {{c.contact_distance() / 2 * c.length, c.contact_distance() / 2 * c.length}};
  return options;
}

Told analyse(const MadeUpCollision& c) {
  const ScratchFile dump(c.dump());
  const RunOptions options = options_for(c, dump);
  const Run run = prepare_run(options);
  require_two_bodies(run);
  PlanWishes asked;
  asked.parts = {Part::force, Part::restitution, Part::contact_radius};
  asked.insist = true;
  asked.layer = 1.5 * c.length;
  RunWishes wishes;
  wishes.plan = plan_run(run, asked);
  wishes.radii = find_radii(run, options);
  wishes.contact.layer = asked.layer;
  const AnalysedRun analysed = analyse_run(run, wishes, {});
  Told told{analysed.numbers(), 0, analysed.measured.swept.damage};
  if (!analysed.curve.loops.empty()) told.low = analysed.curve.loops.front().low;
  told.numbers.push_back({"e", analysed.restitution.e});
  told.numbers.push_back({"speed_before", analysed.restitution.speed_before});
  told.numbers.push_back({"kinetic_loss", analysed.curve.kinetic_loss});
  return told;
}

double number(const Told& told, const std::string& name) {
  for (const PublishedValue& n : told.numbers)
    if (n.name == name) return n.value.value;
  return std::nan("");
}

/// The cases one after the other, each against the plain collision or against what is known of it.
class DumpCases {
 public:
  DumpCases() : plain_(analyse(MadeUpCollision{})) {}

  /// The same numbers in other units, to so many digits.
  void same(std::string what, const MadeUpCollision& c, double needed) {
    add(std::move(what), [&] {
      const Told told = analyse(c);
      Judged judged(told.warnings);
      for (const PublishedValue& n : plain_.numbers) {
        if (!(std::abs(n.value.value) > 2 * n.value.error.value_or(0))) continue;  // rounding of nought
        const Dimension d = n.value.dimension;
        const double factor = std::pow(c.mass, d.mass) * std::pow(c.length, d.length) * std::pow(c.time, d.time);
        judged.number(n.name, number(told, n.name), n.value.value * factor, needed);
      }
      return judged;
    });
  }

  /// What is known of the collision, within twice the errors that are stated.
  void honest(std::string what, const MadeUpCollision& c) {
    add(std::move(what), [&] {
      const Told told = analyse(c);
      Judged judged(told.warnings);
      const std::vector<std::pair<std::string, double>> known{{"F_max", c.force_max()},
                                                              {"delta_max", c.delta_max()},
                                                              {"hysteresis_area", c.kinetic_loss(told.low)},
                                                              {"kinetic_loss", c.kinetic_loss(told.low)},
                                                              {"speed_before", c.speed_before()},
                                                              {"e", c.e}};
      for (const auto& [name, exact] : known)
        for (const PublishedValue& n : told.numbers)
          if (n.name == name) judged.within_error(name, n.value, exact);
      return judged;
    });
  }

  /// An error or a warning with these words.
  void refused(std::string what, const MadeUpCollision& c, const std::string& words) {
    add(std::move(what), [&] {
      const Told told = analyse(c);
      Judged judged(told.warnings);
      judged.must_be_refused(words, number(told, "F_max"));
      return judged;
    }, words);
  }

  std::vector<ExtremeCase> cases;

 private:
  template <class Work>
  void add(std::string what, Work&& work, const std::string& words = {}) {
    cases.push_back(judge("collision", std::move(what), words, work));
  }

  Told plain_;
};

/// Changes of one word of one atom in the middle frame.
MadeUpCollision with_word(std::size_t column, const std::string& word) {
  MadeUpCollision c;
  c.change = [=, middle = c.frames() / 2](std::size_t frame, std::vector<std::string>& words) {
    if (frame == middle && words[0] == "7") words[column] = word;
  };
  return c;
}

void add_units(DumpCases& cases) {
  MadeUpCollision c;
  c.units = "si";
  c.length = 1e-9, c.mass = 1e-26, c.time = 1e-12;
  cases.same("nanoparticles in SI", c, 11);
  c.length = 1e9, c.mass = 1e24, c.time = 1e3;
  cases.same("planets in SI", c, 11);
  for (const double power : {-60.0, -30.0, 30.0, 60.0}) {
    const double factor = 1.0123456789 * std::pow(10.0, power);  // printed with all digits, as thermal speeds are
    c = {};
    c.length = factor;
    cases.same(fmt::format("lengths times 1e{:g}", power), c, 11);
    c = {};
    c.mass = factor;
    cases.same(fmt::format("masses times 1e{:g}", power), c, 11);
    c = {};
    c.time = factor;
    cases.same(fmt::format("times times 1e{:g}", power), c, 11);
  }
}

/// What atoms share takes as many digits of the 16 from places and speeds as it is greater than what they
/// differ by; a force, a difference of speeds over a short time, loses one more.
void add_places(DumpCases& cases) {
  for (const double far : {1e3, 1e7}) {
    MadeUpCollision c;
    c.origin = {far, -far, far};
    cases.same(fmt::format("{:g} from the origin", far), c, 14.5 - std::log10(far));
    c = {};
    c.drift = {far, 0.3 * far, -far};
    cases.same(fmt::format("on a drift of {:g}", far), c, 13.5 - std::log10(far));
  }
}

void add_numbering(DumpCases& cases) {
  MadeUpCollision c;
  c.first_id = 1'000'000'000'000;
  cases.same("ids from 1e12", c, 15);
  c = {};
  c.first_step = (std::int64_t{1} << 53) + 1;
  cases.same("steps beyond 2^53", c, 13);
  c = {};
  c.shuffled = true;
  cases.same("atoms in another order in each frame", c, 12);
}

void add_sampling(DumpCases& cases) {
  for (const double interval : {0.01, 0.05, 0.2, 0.5, 1.0}) {
    MadeUpCollision c;
    c.interval = interval;
    c.before = c.after = 6 * std::max(interval, 0.25);
    cases.honest(fmt::format("{:g} frames in contact", c.duration / interval), c);
  }
  for (const int digits : {7, 5, 4}) {
    MadeUpCollision c;
    c.digits = digits;
    cases.honest(fmt::format("{} printed digits", digits), c);
  }
  for (const double noise : {1e-4, 1e-3, 1e-2}) {
    MadeUpCollision c;
    c.noise = noise;
    cases.honest(fmt::format("noise of {:g} on places and velocities", noise), c);
  }
}

void add_bounces(DumpCases& cases) {
  for (const double e : {1.0, 0.99, 0.1, 0.01}) {
    MadeUpCollision c;
    c.e = e;
    c.after = e < 0.1 ? 40 : 3;
    cases.honest(fmt::format("e = {:g}", e), c);
  }
  for (const double speed : {1e-6, 1e-3}) {
    MadeUpCollision c;
    c.speed = speed;
    cases.honest(fmt::format("compressed by {:.0e} radii", c.delta_max() / c.ball), c);
  }
}

void add_few_atoms(DumpCases& cases) {
  MadeUpCollision c;
  c.ball = 0.5;
  cases.honest("bodies of one atom", c);
  c.ball = 1;
  cases.honest("bodies of seven atoms", c);
  c = {};
  c.change = [](std::size_t, std::vector<std::string>& words) {
    if (words[1] == "2") words.clear();
  };
  cases.refused("a body without atoms", c, "exactly two are needed");
}

void add_refusals(DumpCases& cases) {
  for (const char* word : {"nan", "inf", "-inf", "1e999"})
    cases.refused(fmt::format("a coordinate {}", word), with_word(2, word), "frame 70");
  cases.refused("a velocity nan", with_word(5, "nan"), "frame 70");
  for (const char* word : {"0", "-1", "nan"})
    cases.refused(fmt::format("a mass {}", word), with_word(8, word), "frame 70");
  cases.refused("a word that is no number", with_word(3, "0.1.2"), "0.1.2");
  MadeUpCollision c;
  c.before = c.duration = c.after = 0;
  cases.refused("one frame", c, "at least two");
  c = {};
  c.before = 5, c.after = -c.duration - 1;
  cases.refused("a collision that is not reached", c, "no contact");
  c = {};
  c.ball = 0.5, c.length = 0;
  cases.refused("a box without extent", c, "bounds of a box");
}

}  // namespace

std::vector<ExtremeCase> extreme_dumps() {
  DumpCases cases;
  add_units(cases);
  add_places(cases);
  add_numbering(cases);
  add_sampling(cases);
  add_bounces(cases);
  add_few_atoms(cases);
  add_refusals(cases);
  return std::move(cases.cases);
}

}  // namespace mdana
