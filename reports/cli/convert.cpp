// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "readers/input_error.hpp"
#include "readers/trajectory.hpp"
#include "reports/cli/command.hpp"
#include "reports/cli/signals.hpp"
#include "reports/conversion.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> addable{"body", "mass", "ke", "xu"};
constexpr std::array<std::string_view, 2> omittable{"units", "time"};

/// "a,b,c" without twins. Throws UsageError.
std::vector<std::string> list_option(const Values& values, const std::string& option) {
  std::vector<std::string> list;
  if (!values.count(option)) return list;
  const std::string& text = values[option].as<std::string>();
  std::istringstream stream(text + ",");
  for (std::string word; std::getline(stream, word, ',');) {
    if (word.empty() || std::ranges::find(list, word) != list.end())
      throw UsageError(fmt::format("--{} {}: names separated by commas expected, none twice", option,
                                   text));
    list.push_back(word);
  }
  return list;
}

/// The same of certain words only.
std::vector<std::string> words_option(const Values& values, const std::string& option,
                                      std::span<const std::string_view> words) {
  std::vector<std::string> list = list_option(values, option);
  for (const std::string& word : list)
    if (std::ranges::find(words, word) == words.end())
      throw UsageError(fmt::format("--{} {}: {} expected", option, word, fmt::join(words, ", ")));
  return list;
}

bool has(const std::vector<std::string>& list, std::string_view word) {
  return std::ranges::find(list, word) != list.end();
}

/// All formats that can be written: "lammps_text (.dump ...)".
std::string writable() {
  std::vector<std::string> known;
  for (const Format* format : formats())
    if (format->create) known.push_back(fmt::format("{} ({})", format->name, format->ending));
  return fmt::format("{}", fmt::join(known, ", "));
}

const Format& format_option(const Values& values, const fs::path& output) {
  const bool named = values.count("format");
  for (const Format* format : formats())
    if (format->create && named && format->name == values["format"].as<std::string>())
      return *format;
  if (const Format* format = named ? nullptr : format_to_write(output)) return *format;
  if (named)
    throw UsageError(fmt::format("--format {}: one of these expected: {}",
                                 values["format"].as<std::string>(), writable()));
  throw UsageError(fmt::format("-o {}: the name's ending tells no format; add --format, or end it "
                               "as one of these does: {}", output.string(), writable()));
}

/// What the command line says by itself.
Conversion conversion_of(const Values& values) {
  Conversion conversion;
  conversion.output = values["output"].as<std::string>();
  conversion.format = &format_option(values, conversion.output);
  conversion.columns = list_option(values, "columns");
  if (values.count("sort")) conversion.sort = values["sort"].as<std::string>();
  if (!conversion.sort.empty() && kind_of_column(conversion.sort) != ColumnKind::integer)
    throw UsageError(fmt::format("--sort {}: a column of whole numbers expected, such as id",
                                 conversion.sort));
  const auto omitted = words_option(values, "omit", omittable);
  conversion.omit_units = has(omitted, "units");
  conversion.omit_time = has(omitted, "time");
  conversion.choice = frame_choice(values);
  conversion.strict = values["strict"].as<bool>();
  conversion.threads = threads_option(values);
  conversion.stop = &stop_signal();
  conversion.progress = progress_printer();
  return conversion;
}

/// What dump, scene and options say together, with the words for the document.
class Settings {
 public:
  Settings(const RunOptions& options, Conversion& conversion, Document& document)
      : options_(options),
        first_(first_header(options.dump)),
        scene_(find_scene(options)),
        conversion_(conversion),
        document_(document) {}

  void settle(const std::vector<std::string>& added) {
    document_.line("dump", options_.dump.string());
    if (options_.units || first_.units || scene_.units) units();
    conversion_.timestep = options_.timestep;
    if (!first_.time && !options_.timestep) conversion_.timestep = scene_.timestep;
    for (const std::string& word : added) add(word);
  }

 private:
  Units units() {
    const StatedUnits stated = find_units(options_, first_, scene_);
    conversion_.units = stated.units;
    document_.json("units", name(stated.units));
    document_.json("units_source", stated.source);
    return stated.units;
  }

  void add(const std::string& word) {
    if (word == "body") conversion_.added.push_back(added_bodies(bodies()));
    if (word == "mass") conversion_.added.push_back(added_masses(masses()));
    if (word == "ke") conversion_.added.push_back(added_kinetic_energy(masses(), units()));
    if (word == "xu") unwrapped();
  }

  Bodies bodies() {
    const bool own_rule = !options_.bodies.empty();
    Bodies bodies = find_bodies(options_.dump, first_, own_rule ? options_.bodies : scene_.bodies);
    document_.text("bodies", bodies.rule());
    return bodies;
  }

  Masses masses() {
    std::vector<std::string> warnings;
    Masses masses = find_masses(options_, first_, scene_, units(), warnings);
    if (!has(document_.warnings(), warnings.empty() ? "" : warnings[0]))
      for (const std::string& warning : warnings) document_.warn(warning);
    document_.json("masses_source", masses.source());
    return masses;
  }

  void unwrapped() {
    if (first_.has_column("xu"))
      document_.left_out("unwrapped positions", "the dump has xu yu zu");
    else
      conversion_.added.push_back(added_unwrapped());
  }

  const RunOptions& options_;
  FrameHeader first_;
  Scene scene_;
  Conversion& conversion_;
  Document& document_;
};

void add_result(Document& document, const Conversion& conversion, const Converted& converted) {
  SweepResult as_swept;  // says input, damage and time in the same words as every command
  as_swept.steps.resize(converted.frames);
  as_swept.inputs = converted.inputs;
  as_swept.damage = converted.damage;
  as_swept.seconds = converted.seconds;
  document.sweep(as_swept, format_of(conversion.dump));
  document.json("steps", {converted.first_step, converted.last_step});
  document.line("steps", fmt::format("{} to {}", converted.first_step, converted.last_step));
  document.json("atoms", {converted.least_atoms, converted.most_atoms});
  document.line("atoms", converted.least_atoms == converted.most_atoms
                             ? fmt::format("{}", converted.most_atoms)
                             : fmt::format("{} to {}", converted.least_atoms, converted.most_atoms));
  document.json("columns", converted.columns);
  document.line("columns", fmt::format("{}", fmt::join(converted.columns, " ")));
  document.json("output", {{"path", conversion.output.string()},
                           {"size", converted.size},
                           {"format", conversion.format->name}});
  document.line("output", fmt::format("{} ({}, {} bytes)", conversion.output.string(),
                                      conversion.format->name, converted.size));
  if (converted.positions_may_jump && has(converted.columns, "xu"))
    document.warn("xu yu zu are the wrapped positions: there are no image flags to unwrap them by");
  if (converted.columns_change) document.warn("the columns change between frames");
}

void add_options(Options& options) {
  options.add_options()  //
      ("output,o", po::value<std::string>()->value_name("OUT")->required(),
       "the new file; written whole or not at all")  //
      ("format", po::value<std::string>()->value_name("NAME"),
       "format of the new file (default: by the ending of its name)")  //
      ("columns", po::value<std::string>()->value_name("LIST"),
       "these columns of the dump only, in this order, as id,type,x,y,z")  //
      ("add", po::value<std::string>()->value_name("LIST"),
       "columns that mdana computes: body (c_mdana_body: 1, 2, ...; 0 for none), mass "
       "(c_mdana_mass), ke (c_mdana_ke, kinetic energy of each atom), xu (xu yu zu, unwrapped "
       "positions)")  //
      ("sort", po::value<std::string>()->value_name("COLUMN"),
       "sort the atoms of each frame by id or another column of whole numbers; takes memory for "
       "the whole frame")  //
      ("omit", po::value<std::string>()->value_name("LIST"),
       "units, time: do not state them, for programs that do not know these lines (MDAnalysis)");
  add_dump_options(options);
  add_frame_options(options);
  add_threads_option(options);
  options.add_options()("json", po::bool_switch(), "print one JSON document on the standard output");
}

int run_command(const Values& values) {
  Conversion conversion = conversion_of(values);
  const auto added = words_option(values, "add", addable);
  const RunOptions options = run_options(values);
  conversion.dump = options.dump;
  conversion.selection = options.selection;
  check_directory(conversion.output);
  Document document("convert");
  Settings(options, conversion, document).settle(added);
  const Converted converted = convert_dump(conversion);
  add_result(document, conversion, converted);
  print(values["json"].as<bool>() ? document.to_json() : document.to_terminal());
  return document.damaged() ? damaged_input : done;
}

}  // namespace

extern const Command convert_command;
const Command convert_command{
    "convert",
    "DUMP",
    "the dump in another format, with other or more columns",
    "Writes every column of the dump as it stands: numbers as the shortest decimals that read back\n"
    "as the same bits, positions neither wrapped nor unwrapped. Columns of its own (--add) are named\n"
    "c_mdana_..., like those of a compute of LAMMPS. Units are stated as by the dump, the scene or\n"
    "--units, times as by --timestep, the dump or the scene. A set of files becomes one.",
    "  mdana convert dump.bin -o dump.lammpstrj.gz\n"
    "  mdana convert 'run/dump.*.%.lammpstrj' -o all.lammpstrj --sort id --stride 10\n"
    "  mdana convert sample-data/adhesive-tiny/dump.lammpstrj.gz -o extended.dump --add body,mass,ke\n"
    "  mdana convert dump.lammpstrj -o small.dump --columns id,type,x,y,z --omit units,time",
    add_options,
    run_command};

}  // namespace mdana::cli
