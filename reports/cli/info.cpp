// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/input_error.hpp"
#include "readers/positions.hpp"
#include "readers/thermo_log.hpp"
#include "readers/trajectory.hpp"
#include "reports/cli/command.hpp"
#include "reports/cli/signals.hpp"
#include "reports/plan.hpp"
#include "reports/thermo_summary.hpp"

namespace mdana::cli {
namespace {

/// What a walk over the frames' headers tells; atoms are passed over unread.
struct Walk {
  std::uint64_t frames = 0;
  std::int64_t first_step = 0, last_step = 0;
  std::uint64_t least_atoms = 0, most_atoms = 0;
  bool columns_change = false;
  std::string damage;
  std::vector<InputRecord> inputs;
  double seconds = 0;
};

void look(Walk& walk, const FrameHeader& header, const FrameHeader& first) {
  if (walk.frames == 0) {
    walk.first_step = header.step;
    walk.least_atoms = header.atoms;
  }
  walk.last_step = header.step;
  walk.least_atoms = std::min(walk.least_atoms, header.atoms);
  walk.most_atoms = std::max(walk.most_atoms, header.atoms);
  walk.columns_change = walk.columns_change || header.columns != first.columns;
}

Walk walk_frames(const std::filesystem::path& dump, const FrameHeader& first) {
  const auto start = std::chrono::steady_clock::now();
  const auto progress = progress_printer();
  Walk walk;
  const auto source = open_trajectory(dump, {});
  FrameHeader header;
  try {
    Chunk chunk;
    while (source->next(header)) {
      while (source->cut(chunk)) {
        if (stop_signal()) throw Interrupted(stop_signal());
      }
      look(walk, header, first);  // a frame counts when it is whole
      ++walk.frames;
      if (progress) progress({walk.frames, source->share()});
    }
  } catch (const InputError& error) {
    walk.damage = error.what();
  }
  walk.inputs = source->records();
  walk.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return walk;
}

std::string box_text(const Box& box) {
  const Eigen::Vector3d size = box.edges.colwise().norm();
  const bool orthogonal = box.edges.isDiagonal(0);
  return fmt::format("{:.6g} x {:.6g} x {:.6g}{}, periodic: {}", size[0], size[1], size[2],
                     orthogonal ? "" : ", tilted",
                     box.any_periodic() ? fmt::format("{}{}{}", box.periodic[0] ? "x" : "",
                                                      box.periodic[1] ? "y" : "",
                                                      box.periodic[2] ? "z" : "")
                                        : "none");
}

nlohmann::ordered_json box_json(const Box& box) {
  auto edges = nlohmann::ordered_json::array();
  for (int k = 0; k < 3; ++k)
    edges.push_back({box.edges(0, k), box.edges(1, k), box.edges(2, k)});
  return {{"origin", {box.origin.x(), box.origin.y(), box.origin.z()}},
          {"edges", edges},
          {"periodic", {box.periodic[0], box.periodic[1], box.periodic[2]}}};
}

void add_ability(Document& document, const std::string& what, const std::string& obstacle) {
  if (obstacle.empty()) {
    document.line("can compute", what);
    return;
  }
  document.line("left out", what + ": " + obstacle);
  document.left_out(what, obstacle);
}

/// The main things that commands can do with the dump, or why they cannot; mdana plan tells all.
void add_abilities(Document& document, const Run& run) {
  const auto add = [&](Part part, const std::string& how = {}) {
    std::string why = run.scene.interaction == Interaction::unknown ? "" : not_needed(part, run);
    if (why.empty()) why = obstacle(part, run);
    add_ability(document, std::string(name(part)) + how, why);
  };
  const bool force = obstacle(Part::force, run).empty();
  add(Part::force, force ? " from " + std::string(name(best_force_source(run))) : "");
  if (run.scene.interaction == Interaction::aggregate) add(Part::network);
  for (const Part part : {Part::contact_radius, Part::hertz_fit}) add(part);
}

void add_options(Options& options) {
  add_run_options(options);
  options.add_options()("json", boost::program_options::bool_switch(),
                        "print one JSON document on the standard output")(
      "output,o", boost::program_options::value<std::string>()->value_name("FILE"),
      output_help(false).c_str());
}

/// What analyses need beyond the dump itself: told as far as it is known.
Document settings(const RunOptions& options) {
  try {
    const Run run = prepare_run(options);
    Document document("info", run);
    document.json("body_count", run.bodies.count());
    document.text("timestep_source", run.timestep_source);
    if (run.scene.interaction != Interaction::unknown)
      document.text("interaction", std::string(name(run.scene.interaction)));
    add_abilities(document, run);
    return document;
  } catch (const InputError& error) {
    Document document("info");
    document.line("dump", options.dump.string());
    add_ability(document, "all analyses", error.what());
    return document;
  }
}

void add_frames(Document& document, const FrameHeader& first, const Walk& walk,
                std::string_view format) {
  SweepResult as_swept;  // says input, damage and time in the same words as every command
  as_swept.steps.resize(walk.frames);
  as_swept.inputs = walk.inputs;
  as_swept.damage = walk.damage;
  as_swept.seconds = walk.seconds;
  const auto positions = position_source(first.columns);
  as_swept.unwrapped = positions && positions->may_jump(first.box);
  document.sweep(as_swept, format);
  document.text("format", std::string(format));
  document.json("steps", {walk.first_step, walk.last_step});
  document.line("steps", fmt::format("{} to {}", walk.first_step, walk.last_step));
  document.json("atoms", {walk.least_atoms, walk.most_atoms});
  document.line("atoms", walk.least_atoms == walk.most_atoms
                             ? fmt::format("{}", walk.most_atoms)
                             : fmt::format("{} to {}", walk.least_atoms, walk.most_atoms));
  document.json("columns", first.columns);
  document.line("columns", fmt::format("{}", fmt::join(first.columns, " ")));
  document.json("box", box_json(first.box));
  document.line("box", box_text(first.box));
  if (walk.columns_change) document.warn("the columns change between frames");
}

int run_command(const Values& values) {
  check_output(values, false);
  const RunOptions options = run_options(values);
  if (is_lammps_log(options.dump))
    return emit(values, thermo_summary(read_thermo_log(options.dump)), nullptr);
  const FrameHeader first = first_header(options.dump);
  const Walk walk = walk_frames(options.dump, first);
  if (walk.frames == 0) throw InputError(walk.damage);
  Document document = settings(options);
  add_frames(document, first, walk, format_of(options.dump));
  return emit(values, document, nullptr);
}

}  // namespace

extern const Command info_command;
const Command info_command{
    "info",
    "FILE",
    "what is in a dump and what can be computed from it, or what is in a log of LAMMPS",
    "Frames, atoms, columns, units, box, the bodies found, and which analyses the dump allows.\n"
    "Reads the frames' headers only; the atoms of the first frame are read to tell the bodies apart.\n"
    "Of a log.lammps: runs, steps, columns of the thermodynamic output, units and time step.",
    "  mdana info sample-data/adhesive-tiny/dump.lammpstrj.gz\n"
    "  mdana info dump.lammpstrj --units metal --masses 1=107.87 --json\n"
    "  mdana info log.lammps",
    add_options,
    run_command};

}  // namespace mdana::cli
