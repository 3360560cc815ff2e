// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <boost/program_options.hpp>

#include "analyses/table.hpp"
#include "fits/named_value.hpp"
#include "reports/document.hpp"
#include "reports/run.hpp"

namespace mdana::cli {

/// What the program ends with.
enum ExitCode {
  done = 0,
  failed = 1,
  usage = 2,
  damaged_input = 3,   ///< what could be computed is written
  not_converged = 4,
  resumable = 75,      ///< stopped by SIGTERM or SIGUSR1: to be run again
  interrupted = 130,   ///< stopped by SIGINT
};

/// The command line itself is wrong.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using Options = boost::program_options::options_description;
using Values = boost::program_options::variables_map;

/// A subcommand: one file and one word in MDANA_COMMANDS in CMakeLists.txt; each defines
/// `extern const Command <name>_command`. Help is printed from this table.
struct Command {
  std::string_view name;
  std::string_view positional;  ///< "DUMP"; "DUMP..." takes several: `input` and the list `more`; "[DUMP]" need not be
  std::string_view summary;
  std::string_view description;
  std::string_view examples;    ///< one command line a line
  void (*add_options)(Options& options);
  int (*run)(const Values& values);
  bool on_ranks = false;        ///< shares its work among the processes of mpirun; see readers/ranks.hpp
};

/// All subcommands of this build.
std::span<const Command* const> commands();

/// Options that say what a dump does not: --scene --units --masses --select --bodies --timestep; for a run
/// --radius and --physical besides.
void add_dump_options(Options& options);
void add_run_options(Options& options);
/// Throws UsageError at a value that cannot be understood.
RunOptions run_options(const Values& values);

/// -p NAME=VALUE ... of a law. Throws UsageError at one without its sign.
std::vector<NamedValue> parameters_option(const Values& values);

/// "T_vis=0.075" of an option taken apart. Throws UsageError.
NamedValue named_value(std::string_view option, const std::string& text);

/// A finite number in the text of an option. Throws UsageError with the whole text.
double number_option(std::string_view option, const std::string& whole, std::string_view text);

/// "C,B,zeta", in one option or in several. Throws UsageError.
std::vector<std::string> names_option(const Values& values, const char* option);

/// Parts of "FIRST:LAST:COUNT"; `expected` is what a UsageError says. COUNT is 2 to 1000000.
std::array<std::string_view, 3> three_parts(std::string_view text, std::string_view expected);
double finite_number(std::string_view text, std::string_view expected);
std::size_t count_number(std::string_view text, std::string_view expected);
/// So many values at equal distances, the ends included.
std::vector<double> evenly(double first, double last, std::size_t count);

/// --frames, --stride and --strict, which every command that reads all frames has, and the choice.
void add_frame_options(Options& options);
FrameChoice frame_choice(const Values& values);

/// Options of every command that measures: frames, resources, --json, -o.
void add_output_options(Options& options, bool table);
SweepOptions sweep_options(const Values& values);

/// What -o writes, for help: "write the document (.json) ...".
std::string output_help(bool table);

/// --threads alone.
void add_threads_option(Options& options);
std::size_t threads_option(const Values& values);

/// --threads and --memory, which every command that reads atoms has, and their values.
void add_resource_options(Options& options);
void set_resources(const Values& values, SweepOptions& sweeping);

/// Refuses an -o that cannot be written before work begins: an unknown suffix, CSV of a command
/// without a table, a directory that does not exist.
void check_output(const Values& values, bool table);

/// The file of -o, if there is one, holds the document's other tables, too.
bool output_holds_all_tables(const Values& values);

/// Throws std::runtime_error if the directory of an output does not exist.
void check_directory(const std::filesystem::path& output);

/// Prints on the standard output (of the first rank); throws std::runtime_error if that is full or closed.
void print(const std::string& text);

/// Prints the document (text, or JSON with --json) and writes -o; the exit code that follows from
/// the document.
int emit(const Values& values, const Document& document, const Table* table);

/// The value if it is finite and greater than zero. Throws UsageError naming the option.
double positive(double value, const char* option);

/// The number of an option, greater than zero; nothing if it is not given. Throws UsageError.
std::optional<double> positive_option(const Values& values, const char* name);

/// The value of an option that must be one of a list. Throws UsageError.
std::size_t choice(const Values& values, const std::string& option,
                   std::span<const std::string_view> names);

}  // namespace mdana::cli
