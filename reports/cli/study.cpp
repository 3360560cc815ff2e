// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "readers/input_error.hpp"
#include "reports/atomic_file.hpp"
#include "reports/cli/command.hpp"
#include "reports/study.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;
namespace fs = std::filesystem;

void add_options(Options& options) {
  options.add_options()                                                                          //
      ("output,o", po::value<std::string>()->value_name("FILE"),
       "study file to write, in DIR (default: DIR/study.toml)")  //
      ("print", po::bool_switch(), "print it instead")                                           //
      ("force", po::bool_switch(), "replace a study file that is there");
}

fs::path directory_of(const Values& values) {
  if (values["input"].as<std::string>() != "init")
    throw UsageError(fmt::format("study {}: 'init' is expected", values["input"].as<std::string>()));
  if (!values.count("more") || values["more"].as<std::vector<std::string>>().size() != 1)
    throw UsageError("study init: one directory is expected");
  const fs::path directory = values["more"].as<std::vector<std::string>>().front();
  if (!fs::is_directory(directory)) throw InputError(fmt::format("{}: no such directory", directory.string()));
  return directory;
}

int run_command(const Values& values) {
  const fs::path directory = directory_of(values);
  const fs::path file = values.count("output") ? fs::path(values["output"].as<std::string>()) : directory / "study.toml";
  const std::string text = study_toml(read_study(directory));
  if (values["print"].as<bool>()) return print(text), done;
  if (!fs::is_directory(file.parent_path().empty() ? "." : file.parent_path()) ||
      !fs::equivalent(file.parent_path().empty() ? "." : file.parent_path(), directory))
    throw UsageError(fmt::format("-o {}: paths in a study file count from where it is, so it must be in {}", file.string(),
                                 directory.string()));
  if (fs::exists(file) && !values["force"].as<bool>())
    throw InputError(fmt::format("{}: is there already; --force replaces it", file.string()));
  write_file(file, text);
  print(file.string() + "\n");
  return done;
}

}  // namespace

extern const Command study_command;
const Command study_command{
    "study",
    "init DIR...",
    "a study file of the runs in a directory, to be edited",
    "study init DIR looks for scene files in DIR and below it and writes DIR/study.toml: the runs with their groups,\n"
    "what is analysed, which laws are fitted, which figures are drawn, and dumps that lack a scene file. mdana report\n"
    "reads it.",
    "  mdana study init sample-data --print\n"
    "  mdana study init runs",
    add_options,
    run_command};

}  // namespace mdana::cli
