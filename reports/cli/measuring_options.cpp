// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/measuring_options.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

auto number(const char* name) { return po::value<double>()->value_name(name); }

}  // namespace

void add_contact_options(Options& options) {
  options.add_options()                                                                      //
      ("layer", number("LENGTH"),
       "thickness of the layer about the contact plane (default: 1 sigma of the scene, 1 in lj "
       "units)")                                                                             //
      ("spacing", number("LENGTH"),
       "distance of nearest neighbours in a body (default: median of the first frame)")      //
      ("neighbour-cutoff", number("LENGTH"),
       "atoms of the two bodies nearer than this are neighbours (default: 1.5 spacings)");
}

ContactOptions contact_options(const Values& values) {
  return {positive_option(values, "layer"), positive_option(values, "spacing"),
          positive_option(values, "neighbour-cutoff")};
}

void add_material_options(Options& options) {
  options.add_options()                                                                      //
      ("modulus", number("E*"), "contact modulus, for JKR (fit-hertz measures it in a repulsive run)")  //
      ("surface-energy", number("GAMMA"),
       "gamma of one surface, for JKR (default: of the scene)");
}

Material material_options(const Values& values, const Scene& scene) {
  Material material{positive_option(values, "modulus"), positive_option(values, "surface-energy")};
  if (!material.surface_energy) material.surface_energy = scene.surface_energy;
  return material;
}

void add_membership_options(Options& options) {
  options.add_options()("final-clusters", po::bool_switch(),
                        "look for atoms that went over to the other body also in frames of more "
                        "than 250000 atoms (100 bytes each)");
}

void add_potential_options(Options& options) {
  options.add_options()                                              //
      ("potential", po::value<std::string>()->value_name("COLUMN"),
       "column of the potential energies of atoms (default: c_pe, c_peatom or pe, if there is "
       "exactly one)")                                               //
      ("log", po::value<std::string>()->value_name("FILE"),
       "take the potential energy from this log of LAMMPS instead, by the step");
}

PotentialOptions potential_options(const Values& values) {
  PotentialOptions options;
  if (values.count("potential")) options.column = values["potential"].as<std::string>();
  if (values.count("log")) options.log = values["log"].as<std::string>();
  if (values.count("potential") && values.count("log"))
    throw UsageError("--potential and --log: give one of them");
  return options;
}

}  // namespace mdana::cli
