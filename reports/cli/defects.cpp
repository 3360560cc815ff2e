// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/defect_numbers.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "readers/ranks.hpp"
#include "readers/trajectory.hpp"
#include "reports/accuracy_subjects.hpp"
#include "reports/atomic_file.hpp"
#include "reports/ca.hpp"
#include "reports/cli/error_option.hpp"
#include "reports/csv.hpp"
#include "reports/defect_pictures.hpp"
#include "reports/labelled_dump.hpp"
#include "reports/plan.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

constexpr std::array<std::string_view, 2> neighbour_searches{"cells", "cgal"};

DefectSettings defect_settings(const Values& values) {
  DefectSettings settings;
  for (const std::string& name : names_option(values, "label")) {
    if (name != "bcc" && name != "ico")
      throw UsageError(fmt::format("--label {}: bcc or ico expected", name));
    (name == "bcc" ? settings.bcc : settings.ico) = true;
  }
  settings.spacing = positive_option(values, "spacing");
  settings.by_cgal = choice(values, "neighbours", neighbour_searches) == 1;
  settings.surface = !values["no-surface"].as<bool>();
  settings.lines = !values["no-lines"].as<bool>();
  settings.lines_everywhere = values["lines-everywhere"].as<bool>();
  for (const char* wanted : {"ca", "segments"})
    if (!settings.lines && values.count(wanted))
      throw UsageError(fmt::format("--{} and --no-lines: give one of them", wanted));
  settings.labels = values.count("dump") > 0;
  settings.centro_symmetry = values["csp"].as<bool>();
  settings.coordination = values["coordination"].as<bool>();
  if ((settings.centro_symmetry || settings.coordination) && !settings.labels)
    throw UsageError("--csp and --coordination are columns of --dump FILE, which is missing");
  return settings;
}

const Format* dump_format(const Values& values) {
  if (!values.count("dump")) return nullptr;
  const std::string& name = values["dump"].as<std::string>();
  const Format* format = format_to_write(name);
  if (!format)
    throw UsageError(fmt::format("--dump {}: the name's ending tells no format that can be written "
                                 "(.lammpstrj, .dump ...; see mdana convert --help)", name));
  check_directory(name);
  return format;
}

/// What --frames says: "all", "last", or as for every command; and --memory.
SweepOptions frames_of(Values values, const RunOptions& options) {
  const std::string text = values.count("frames") ? values["frames"].as<std::string>() : "all";
  if (text == "all" || text == "last") values.erase("frames");
  SweepOptions sweeping = sweep_options(values);
  if (text == "last" && sweeping.choice.stride > 1)
    throw UsageError("--frames last and --stride: give one of them");
  if (text == "last") sweeping.choice.first = count_frames(options.dump) - 1;
  if (sweeping.frame_memory) {  // --memory is for all of it
    sweeping.memory = *sweeping.frame_memory / 4;
    *sweeping.frame_memory -= sweeping.memory;
  }
  return sweeping;
}

/// Pictures of frames as files PREFIX.surfaces.STEP.vtp, PREFIX.faults.STEP.vtp and PREFIX.lines.STEP.vtp, as far as
/// they are found.
class Pictures {
 public:
  Pictures(std::string prefix, const DefectSettings& settings)
      : prefix_(std::move(prefix)), surfaces_(settings.surface), lines_(settings.lines) {
    check_directory(prefix_ + ".vtp");
  }

  void add(const FrameHeader& header, const FrameDefects& found) const {
    if (surfaces_) write("surfaces", header, surface_picture(found.surfaces));
    write("faults", header, fault_picture(found.planes));
    if (lines_) write("lines", header, line_picture(found.lines));
  }

 private:
  void write(const char* what, const FrameHeader& header, PolyData data) const {
    data.time = header.time.value_or(static_cast<double>(header.step));
    write_vtp(fmt::format("{}.{}.{}.vtp", prefix_, what, header.step), data);
  }

  std::string prefix_;
  bool surfaces_, lines_;
};

/// Where frames go as they are found.
struct Products {
  std::optional<LabelledDump> dump;
  std::optional<Pictures> pictures;
  std::optional<std::string> ca;  ///< prefix
  bool points = false;            ///< of lines are kept
};

/// One pass over the frames.
DefectHistory history_of(const Run& run, const RunOptions& options, const SweepOptions& sweeping,
                         DefectSettings settings, Products& products, SweepResult& swept) {
  DefectHistory history;
  if (products.points) history.lines.keep_points();
  const bool lines = settings.lines;
  settings.ids = run.first.has_column("id");
  settings.types = settings.labels && run.first.has_column("type");
  settings.product = [&](const FrameHeader& header, const FrameDefects& found) {
    history.planes.push_back(found.planes);
    if (lines) history.lines.add(found);
    if (products.ca) write_ca(fmt::format("{}.{}.ca", *products.ca, header.step), found.lines, header.box);
    if (products.dump) products.dump->add(header, *found.atoms);
    if (products.pictures) products.pictures->add(header, found);
  };
  const bool two = run.bodies.count() == 2;
  const double sum = two ? find_radii(run, options).sum() : 0;
  std::vector<std::unique_ptr<Analysis>> analyses;
  if (two) analyses.push_back(make_motion({}));
  analyses.push_back(make_defects(std::move(settings)));
  swept = sweep(run.dump, run.bodies, run.masses, analyses, sweeping);
  history.lines.finish();
  history.steps = swept.steps;
  history.times = frame_times(run, swept);
  history.table = std::move(swept.tables.back());
  if (!two) return history;
  for (std::size_t row = 0; row < swept.steps.size(); ++row) {
    const auto bodies = body_motion(swept.tables.front(), row);
    history.delta.push_back(sum - (bodies[1].position - bodies[0].position).norm());
  }
  return history;
}

void add_options(Options& options) {
  options.add_options()                                                                          //
      ("dump", po::value<std::string>()->value_name("FILE"),
       "write the bodies' atoms with their labels: columns id, type, x y z and c_mdana_body, "
       "_structure, _site, _margin, _cluster; opens in OVITO and ASE")                           //
      ("vtp", po::value<std::string>()->value_name("PREFIX"),
       "write surfaces, planar faults (as discs) and dislocation lines of each frame as PREFIX.surfaces.STEP.vtp, "
       "PREFIX.faults.STEP.vtp and PREFIX.lines.STEP.vtp, for ParaView")                         //
      ("ca", po::value<std::string>()->value_name("PREFIX"),
       "write the dislocation lines of each frame as PREFIX.STEP.ca, for OVITO")                 //
      ("segments", po::value<std::string>()->value_name("FILE"),
       "write a CSV table of all segments of dislocations: step, track, body, family, Burgers vector, length, ...")  //
      ("csp", po::bool_switch(), "column c_mdana_csp in --dump: centro-symmetry")                //
      ("coordination", po::bool_switch(),
       "column c_mdana_coordination in --dump: atoms within 1.2071 spacings")                    //
      ("label", po::value<std::vector<std::string>>()->composing()->value_name("LIST"),
       "label these structures besides fcc and hcp: bcc, ico (they are counted in any case)")    //
      ("no-surface", po::bool_switch(),
       "leave out area, volume, radius and voids of the bodies and the contact patch, which take most of "
       "the time")    //
      ("no-lines", po::bool_switch(), "leave out dislocation lines")                             //
      ("lines-everywhere", po::bool_switch(),
       "look for lines among all atoms, not only near defects: much slower, to test that they are the same")  //
      ("spacing", po::value<double>()->value_name("LENGTH"),
       "distance of nearest neighbours (default: found in each frame)")                          //
      ("neighbours", po::value<std::string>()->default_value("cells")->value_name("HOW"),
       "cells, or cgal: by CGAL's k-d tree, much slower, gives the same labels");
  add_error_option(options, "the frame stride");
  add_run_options(options);
  add_output_options(options, true);
}

int run_command(const Values& values) {
  check_output(values, true);
  DefectSettings settings = defect_settings(values);
  const Format* format = dump_format(values);
  for (const char* output : {"segments", "ca"})
    if (values.count(output)) check_directory(values[output].as<std::string>());
  const RunOptions options = run_options(values);
  SweepOptions sweeping = frames_of(values, options);
  const Run run = prepare_run(options);
  sweeping.selection = run.selection;
  DumpQuestion question{run, options, sweeping};
  question.defects = settings;
  const auto chosen = choose_stride(values, defects_subject(question), sweeping);
  Plan plan = plan_command(run, "defects");
  if (!settings.surface && !settings.lines) plan.leave_out(Part::dislocations, "--no-surface, --no-lines");
  Products products;
  if (format && is_first_rank()) products.dump.emplace(values["dump"].as<std::string>(), *format, run);
  if (values.count("vtp")) products.pictures.emplace(values["vtp"].as<std::string>(), settings);
  if (values.count("ca")) products.ca = values["ca"].as<std::string>();
  products.points = output_holds_all_tables(values);
  SweepResult swept;
  const DefectHistory history =
      history_of(run, options, sweeping, std::move(settings), products, swept);
  if (!is_first_rank()) return done;  // the products are there
  Document document("defects", run);
  document.sweep(swept, run.format);
  add_plan(document, plan);
  add_defects(document, history);
  if (products.dump) {
    products.dump->commit();
    document.text("dump_written", values["dump"].as<std::string>());
  }
  if (values.count("segments")) {
    write_file(values["segments"].as<std::string>(), to_csv(history.lines.segments()));
    document.text("segments_written", values["segments"].as<std::string>());
  }
  if (products.points && !history.lines.empty()) {
    document.further_table({"lines", "segments", history.lines.segments()});
    document.further_table({"lines", "points", history.lines.points()});
  }
  tell_choice(document, chosen);
  const Table table = defect_table(history);
  return choice_code(chosen, emit(values, document, &table));
}

}  // namespace

extern const Command defects_command;
const Command defects_command{
    "defects",
    "DUMP",
    "crystal structure of the atoms, stacking faults, twins, surfaces, dislocation lines",
    "Labels every atom fcc, hcp or other by common neighbours with a local cutoff (nothing to choose),\n"
    "with a repair of what thermal noise hides; other atoms as surface, contact (with the other body)\n"
    "or bulk defect. Stacking faults and twins from layers of hcp atoms, with their areas; the turn\n"
    "of each body's lattice; its surface, voids and contact patch; dislocation lines with exact Burgers vectors,\n"
    "followed from frame to frame. --frames takes all (default), last, or A:B[:K].\n"
    "A frame that needs more than --memory (if it is not given, half of what is free) is done in slabs, by way\n"
    "of temporary files in $TMPDIR: the same results, and less memory.",
    "  mdana defects sample-data/adhesive-tiny/dump.lammpstrj.gz\n"
    "  mdana defects sample-data/adhesive-tiny/dump.lammpstrj.gz --frames last --dump labels.lammpstrj --csp\n"
    "  mdana defects sample-data/adhesive-tiny/dump.lammpstrj.gz --frames last --vtp last --ca last\n"
    "  mdana defects run/dump.lammpstrj.gz --stride 10 -o defects.csv",
    add_options,
    run_command,
    /*on_ranks=*/true};

}  // namespace mdana::cli
