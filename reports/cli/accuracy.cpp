// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <deque>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/input_error.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/cli/contact_options.hpp"
#include "reports/cli/error_option.hpp"
#include "reports/cli/measuring_options.hpp"
#include "reports/cli/signals.hpp"
#include "reports/study.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;
namespace fs = std::filesystem;

/// Subjects that are dear, or what others say together.
constexpr std::array<std::string_view, 2> only_if_named{"defects", "collision"};

/// What the command line asks of every input.
struct Wishes {
  std::vector<std::string> only, knobs, judged;
  std::optional<double> error;
  int repetitions;
};

bool asked(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::ranges::find(names, name) != names.end();
}

/// Something that subjects are measured of.
struct Input {
  std::string name;
  std::vector<AccuracySubject> subjects;
};

/// Ladders of all subjects, and what is told of them.
class Told {
 public:
  Told(const Wishes& wishes, bool several) : wishes_(wishes), several_(several) {}

  void add(const Input& input) {
    if (several_) document_.line("input", input.name);
    Json subjects = Json::array();
    for (const AccuracySubject& subject : input.subjects) try {
        subjects.push_back(told_of_subject(judged_by(subject, wishes_.judged), input.name));
      } catch (const InputError& error) {
        left_out(subject.name, error.what());
        failure_ = error.what();
      }
    inputs_.push_back({{"input", input.name}, {"subjects", std::move(subjects)}});
  }

  void left_out(const std::string& what, const std::string& reason) { document_.left_out(what, reason); }
  Document& document() { return document_; }

  int emit(const Values& values) {
    if (rows_.empty())
      throw InputError("nothing could be measured: " + (failure_.empty() ? "no analysis or knob of that name applies" : failure_));
    document_.json("results", std::move(inputs_));
    const Table table = accuracy_table(rows_);
    const int code = cli::emit(values, document_, &table);
    return code == done && !met_ ? not_converged : code;
  }

 private:
  using Json = nlohmann::ordered_json;

  Json told_of_subject(const AccuracySubject& subject, const std::string& input) {
    std::vector<Ladder> ladders;
    Json json{{"subject", subject.name}, {"knobs", Json::array()}};
    for (const Knob& knob : subject.knobs) {
      if (!asked(wishes_.knobs, knob.name)) continue;
      if (stop_signal()) throw Interrupted(stop_signal());
      ladders.push_back(climb(subject, knob, wishes_.repetitions));
      add_ladder_lines(document_, ladders.back());
      json["knobs"].push_back(to_json(ladders.back()));
      for (const AccuracyRow& row : ladders.back().rows) add_row(row, input);
    }
    json["fixed"] = Json::array();
    for (const FixedChoice& fixed : subject.fixed)
      if (asked(wishes_.knobs, fixed.name)) json["fixed"].push_back(told_of_fixed(subject, fixed, input));
    if (wishes_.error && !ladders.empty()) json["recommended"] = recommended(subject, ladders);
    return json;
  }

  Json told_of_fixed(const AccuracySubject& subject, const FixedChoice& fixed, const std::string& input) {
    add_fixed_line(document_, subject.name, fixed);
    add_row(fixed_row(subject, fixed), input);
    return to_json(fixed);
  }

  void add_row(AccuracyRow row, const std::string& input) {
    if (several_) row.input = input;
    rows_.push_back(std::move(row));
  }

  Json recommended(const AccuracySubject& subject, const std::vector<Ladder>& ladders) {
    const Recommendation r = recommend(subject, ladders, *wishes_.error);
    if (r.settings.empty()) return nullptr;
    document_.line(subject.name + ", recommended", to_text(r));
    met_ = met_ && r.met();
    return to_json(r);
  }

  const Wishes& wishes_;
  bool several_;
  Document document_{"accuracy"};
  Json inputs_ = Json::array();
  std::vector<AccuracyRow> rows_;
  std::string failure_;  ///< of the last subject that could not be measured
  bool met_ = true;
};

void add_options(Options& options) {
  const auto list = [] { return po::value<std::vector<std::string>>()->composing(); };
  options.add_options()                                                                                  //
      ("error", po::value<double>()->value_name("E"), "recommend the cheapest setting with this error, as a part of the numbers "
       "(exit code 4 if there is none)")                                                                 //
      ("only", list()->value_name("NAMES"), "analyses: force, contact-radius, energy, fit-hertz, fit-force, surface-energy, compress, network; defects and collision "
       "only if they are named")  //
      ("knob", list()->value_name("NAMES"), "knobs: stride, digits, source ... (default: all)")          //
      ("judge", list()->value_name("NAMES"), "numbers whose error counts: F_max, E_star ... (default: all)")  //
      ("repeat", po::value<int>()->default_value(3)->value_name("N"), "measurements of each setting, for the time")  //
      ("law", po::value<std::string>()->value_name("NAME"),
       "a law of collisions: its predictions without an input, its fit to inputs that mdana fit-contact reads; all: of these "
       "what mdana compare-laws says")  //
      ("parameter,p", list()->value_name("NAME=VALUE"), "a parameter of the law")                        //
      ("free", list()->value_name("NAMES"), "parameters that the fit is to find")                        //
      ("table2", po::bool_switch(), "as of mdana fit-contact")                                           //
      ("motion", po::bool_switch(), "as of mdana fit-contact");
  add_run_options(options);
  add_contact_options(options);
  add_potential_options(options);
  add_output_options(options, true);
}

Wishes wishes_of(const Values& values) {
  Wishes wishes{names_option(values, "only"), names_option(values, "knob"), names_option(values, "judge"), wanted_error(values),
                values["repeat"].as<int>()};
  if (wishes.repetitions < 1 || wishes.repetitions > 1000) throw UsageError("--repeat must be 1 to 1000");
  return wishes;
}

std::vector<std::string> inputs_of(const Values& values) {
  std::vector<std::string> names;
  if (values.count("input")) names.push_back(values["input"].as<std::string>());
  if (values.count("more"))
    for (const std::string& name : values["more"].as<std::vector<std::string>>()) names.push_back(name);
  return names;
}

/// The dumps of a study, or a dump itself.
std::vector<RunOptions> runs_of(const std::string& name, const RunOptions& options) {
  if (!fs::is_directory(name) && fs::path(name).extension() != ".toml") {
    RunOptions one = options;
    one.dump = name;
    return {one};
  }
  std::vector<RunOptions> runs;
  const StudyPlan plan = read_study(name);
  for (const PlannedRun& planned : plan.runs) {
    RunOptions one = options;
    one.scene = plan.directory / planned.scene;
    const Scene scene = load_scene(one.scene);
    if (scene.dump.empty()) throw InputError(fmt::format("{}: the scene names no dump", one.scene.string()));
    one.dump = one.scene.parent_path() / scene.dump;
    runs.push_back(std::move(one));
  }
  return runs;
}

int of_dumps(const Values& values, const Wishes& wishes) {
  const SweepOptions sweeping = sweep_options(values);
  const ContactOptions contact = contact_options(values);
  const PotentialOptions potential = potential_options(values);
  std::vector<RunOptions> all;
  for (const std::string& name : inputs_of(values))
    for (RunOptions& run : runs_of(name, run_options(values))) all.push_back(std::move(run));
  Told told(wishes, all.size() > 1);
  std::deque<Run> runs;  // the subjects refer to them
  for (const RunOptions& options : all) {
    runs.push_back(prepare_run(options));
    const Run& run = runs.back();
    require_two_bodies(run);
    DumpQuestion question{run, options, sweeping, contact, potential};
    question.defects.surface = question.defects.lines = true;
    DumpSubjects subjects = dump_subjects(question);
    for (const auto& [what, reason] : subjects.left_out)
      if (asked(wishes.only, what)) told.left_out(what, reason);
    std::erase_if(subjects.subjects, [&](const AccuracySubject& s) {
      return !asked(wishes.only, s.name) || (wishes.only.empty() && std::ranges::find(only_if_named, s.name) != only_if_named.end());
    });
    told.add({run.dump.string(), std::move(subjects.subjects)});
  }
  return told.emit(values);
}

const CollisionLaw& law_of(const Values& values) {
  const std::string text = values["law"].as<std::string>();
  if (const CollisionLaw* law = find_collision_law(text)) return *law;
  std::vector<std::string_view> names;
  for (const CollisionLaw* law : collision_laws()) names.push_back(law->name);
  throw UsageError(fmt::format("--law {}: all or one of {} is expected", text, fmt::join(names, ", ")));
}

int of_all_laws(const Values& values, const Wishes& wishes) {
  if (!values.count("input")) throw UsageError("--law all: collisions that were seen are missing");
  if (values.count("free")) throw UsageError("--law all: --free is of one law");
  ContactFitSettings settings;
  settings.constants = constants_option(values);
  const Observations observations = observations_option(values, {});
  Told told(wishes, false);
  add_inputs(told.document(), observations);
  told.add({values["input"].as<std::string>(), {compare_laws_subject(observations, settings)}});
  return told.emit(values);
}

int of_law(const Values& values, const Wishes& wishes) {
  const CollisionLaw& law = law_of(values);
  Told told(wishes, false);
  if (!values.count("input")) {
    told.add({"", {predict_subject(law, collision_input(law, parameters_option(values)), {})}});
    return told.emit(values);
  }
  ContactFitSettings settings;
  settings.constants = constants_option(values);
  const std::vector<std::string> names = names_option(values, "free");
  const mdana::Wanted wanted = law.name == "andrews" ? mdana::Wanted::compression : mdana::Wanted::restitution;
  const Observations observations = observations_option(values, names, wanted);
  for (const std::string& name : names) settings.free.push_back({name});
  if (names.empty()) settings.free = free_by_default(law, observations, settings);
  if (settings.free.empty()) throw UsageError(fmt::format("law {}: nothing is free; name what is to be found by --free", law.name));
  add_inputs(told.document(), observations);
  told.add({values["input"].as<std::string>(), {fit_contact_subject(law, observations.seen, settings)}});
  return told.emit(values);
}

int run_command(const Values& values) {
  check_output(values, true);
  const Wishes wishes = wishes_of(values);
  if (values.count("law")) return values["law"].as<std::string>() == "all" ? of_all_laws(values, wishes) : of_law(values, wishes);
  if (!values.count("input")) throw UsageError("a dump, a study or --law is missing");
  return of_dumps(values, wishes);
}

}  // namespace

extern const Command accuracy_command;
const Command accuracy_command{
    "accuracy",
    "[DUMP|STUDY|TABLE...]",
    "run time against error over the knobs of every analysis and fit",
    "Measures each number at all values of each knob of an analysis, one knob at a time: frame stride, derivative window,\n"
    "force source, digits of the input, layer, neighbour cutoff, fit method, tolerance, starts, bootstrap, threads ... The\n"
    "error is the distance from the number where that is known, else from the finest setting with its own error by\n"
    "Richardson's extrapolation (knobs without a finest setting: the change from the default); 'stated' is the error that\n"
    "the number gives of itself. Seconds are medians of --repeat measurements. Of differences (least force, loop area,\n"
    "energies) errors are parts of F_max and of the kinetic energy. With --error the cheapest setting is recommended; other\n"
    "commands choose it themselves with their --error. The table (-o FILE.csv) is drawn by mdana plot work-precision.",
    "  mdana accuracy sample-data/adhesive-tiny/dump.lammpstrj.gz --only force --error 0.1\n"
    "  mdana accuracy --law krijt -p R=147 -p m=14434147 -p E=65.5 -p gamma=3.17 -p nu=0.25 -p T_vis=0.075 -p v=0.1 -o krijt.csv\n"
    "  mdana accuracy runs/study.toml -o accuracy.csv\n"
    "  mdana accuracy runs.csv --law all -p gamma=3.17 --knob starts\n"
    "  mdana accuracy runs.csv --law jkr -p E=65.5 --free gamma --knob bootstrap",
    add_options,
    run_command};

}  // namespace mdana::cli
