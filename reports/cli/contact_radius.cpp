// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_radius.hpp"
#include "readers/input_error.hpp"
#include "reports/cli/command.hpp"
#include "reports/measured.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

/// step, [time,] X, delta, and the columns of the analysis.
Table contact_table(const MeasuredMotion& measured, double radius_sum) {
  Table table;
  const RelativeMotion& motion = measured.motion;
  table.add_column({"step", dimension::none},
                   std::vector<double>(motion.steps.begin(), motion.steps.end()));
  if (!motion.times.empty()) table.add_column({"time", dimension::time}, motion.times);
  const std::vector<double> distance = motion.distance();
  std::vector<double> delta;
  for (const double x : distance) delta.push_back(radius_sum - x);
  table.add_column({"X", dimension::length}, distance);
  table.add_column({"delta", dimension::length}, delta);
  const Table& radii = measured.swept.tables[1];
  for (std::size_t k = 0; k < radii.columns().size(); ++k) {
    const auto column = radii.column(k);
    table.add_column(radii.columns()[k], {column.begin(), column.end()});
  }
  return table;
}

void add_options(Options& options) {
  add_run_options(options);
  options.add_options()("layer", po::value<double>()->value_name("LENGTH"),
                        "thickness of the layer about the contact plane (default: 1 sigma of the "
                        "scene, 1 in lj units)");
  add_output_options(options, true);
}

int run_command(const Values& values) {
  check_output(values, true);
  const RunOptions options = run_options(values);
  const SweepOptions sweeping = sweep_options(values);
  std::optional<double> layer;
  if (values.count("layer")) layer = positive(values["layer"].as<double>(), "layer");
  const Run run = prepare_run(options);
  require_two_bodies(run);
  const Radii radii = find_radii(run, options);
  const double half = half_layer(run, layer);
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(make_contact_radius({radii.value, half}));
  const MeasuredMotion measured = measure_motion(run, {}, std::move(analyses), sweeping);
  const ContactRadiusNumbers numbers = contact_radius_numbers(measured, measured.swept.tables[1]);
  if (!(numbers.max.value > 0))
    throw InputError(run.dump.string() + ": no contact in this dump: the layer about the contact "
                                         "plane never holds atoms of both bodies (repulsive bodies "
                                         "under a small load keep farther apart: try a thicker "
                                         "--layer)");

  Document document("contact-radius", run);
  document.sweep(measured.swept, run.format);
  add_contact_radius(document, numbers, half);
  document.text("radius_source", radii.source);
  document.left_out("force, velocities", "not needed for the contact radius; only positions are read");
  const Table table = contact_table(measured, radii.sum());
  return emit(values, document, &table);
}

}  // namespace

extern const Command contact_radius_command;
const Command contact_radius_command{
    "contact-radius",
    "DUMP",
    "contact radius from the atoms at the contact plane",
    "a = sqrt(2) r_g, with r_g the radius of gyration, within the contact plane, of the atoms of\n"
    "both bodies in a layer about it. Zero while the layer lacks atoms of one of the bodies.",
    "  mdana contact-radius sample-data/adhesive-tiny/dump.lammpstrj.gz\n"
    "  mdana contact-radius dump.lammpstrj --units metal --masses 1=107.87 --layer 2.64 -o a.csv",
    add_options,
    run_command};

}  // namespace mdana::cli
