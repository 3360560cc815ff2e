// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <iostream>

#include <fmt/format.h>

#include "analyses/stage_seconds.hpp"
#include "analyses/sweep.hpp"
#include "readers/ranks.hpp"
#include "reports/cli/command.hpp"
#include "reports/cli/signals.hpp"
#include "reports/version.hpp"

namespace mdana::cli {
namespace {

namespace po = boost::program_options;

std::string overview() {
  std::string text = fmt::format(
      "mdana {}: contact mechanics out of molecular-dynamics dumps of colliding particles\n\n"
      "usage: mdana COMMAND [options] INPUT\n\ncommands:\n", version);
  for (const Command* c : commands()) text += fmt::format("  {:<16}{}\n", c->name, c->summary);
  text += "\nmdana COMMAND --help tells the options of a command and shows examples.\n"
          "exit codes: 0 done, 1 failed, 2 usage, 3 damaged input (what could be computed is "
          "written),\n4 not converged, 75 stopped by SIGTERM or SIGUSR1, 130 interrupted\n";
  return text;
}

Options all_options(const Command& command) {
  Options options("options", 100, 50);
  command.add_options(options);
  options.add_options()("help,h", po::bool_switch(), "print this help");
  return options;
}

std::string help(const Command& command) {
  std::ostringstream options;
  options << all_options(command);
  return fmt::format("usage: mdana {} [options] {}\n\n{}\n\n{}\nexamples:\n{}\n", command.name,
                     command.positional, command.description, options.str(), command.examples);
}

const Command* find(std::string_view name) {
  for (const Command* c : commands())
    if (c->name == name) return c;
  return nullptr;
}

Values parse(const Command& command, int argc, char** argv) {
  Options visible = all_options(command);
  Options all;
  all.add(visible).add_options()("input", po::value<std::string>());
  po::positional_options_description positional;
  positional.add("input", 1);
  if (command.positional.find("...") != std::string_view::npos) {
    all.add_options()("more", po::value<std::vector<std::string>>());
    positional.add("more", -1);
  }
  Values values;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).run(), values);
  return values;
}

/// Where the time of a command went. What only one thread does bounds what more of them can gain (Amdahl).
void tell_timings(double wall) {
  const StageSeconds s = stage_seconds();
  const auto line = [&](const char* what, double seconds) {
    std::cerr << fmt::format("{:<58} {:9.3f} s {:5.1f} %\n", what, seconds, 100 * seconds / wall);
  };
  line("blocks cut out of the file, one after the other", s.cut);
  line("numbers converted and analysed, all threads together", s.work);
  line("partials merged, one after the other", s.collect);
  line("whole frames analysed (neighbours)", s.whole);
  line("besides: start, first looks, fits, output", wall - s.sweeps - s.whole);
  line("in all", wall);
}

int run(const Command& command, int argc, char** argv) {
  const auto start = std::chrono::steady_clock::now();
  Values values = parse(command, argc, argv);
  if (values["help"].as<bool>()) {
    print(help(command));
    return done;
  }
  po::notify(values);  // required options; after help, which needs none
  if (!command.positional.empty() && command.positional[0] != '[' && !values.count("input"))
    throw UsageError(fmt::format("{} is missing", command.positional));
  if (command.positional.empty() && values.count("input"))
    throw UsageError(fmt::format("{}: {} reads no file", values["input"].as<std::string>(), command.name));
  if (rank_count() > 1 && !command.on_ranks)
    throw UsageError(fmt::format("{} does not share its work among processes; start it without mpirun", command.name));
  catch_signals();
  const int code = command.run(values);
  if (values.count("timings") && values["timings"].as<bool>())
    tell_timings(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return code;
}

Ending wrong_usage(std::string_view name, std::string_view what) {
  const std::string command = find(name) ? fmt::format("{} ", name) : "";
  return {usage, fmt::format("{}\nTry: mdana {}--help", what, command)};
}

int dispatch(std::string_view name, int argc, char** argv) {
  if (name.empty()) throw UsageError("a command is missing");
  if (name == "--help" || name == "-h" || name == "help") {
    print(overview());
    return done;
  }
  if (name == "--version") {
    print(fmt::format("mdana {}\n", version));
    return done;
  }
  const Command* command = find(name);
  if (!command) throw UsageError(fmt::format("there is no command '{}'", name));
  return run(*command, argc - 1, argv + 1);
}

/// Runs the program and turns every way to end into one.
Ending run_guarded(int argc, char** argv) {
  const std::string_view name = argc > 1 ? argv[1] : "";
  try {
    join_ranks();
    if (!is_first_rank()) std::cerr.setstate(std::ios::badbit);  // which would say everything once more
    return {dispatch(name, argc, argv), {}};
  } catch (const po::error& e) {
    return wrong_usage(name, e.what());
  } catch (const UsageError& e) {
    return wrong_usage(name, e.what());
  } catch (const Interrupted& e) {
    return {code_after(e.signal), "stopped; nothing was written"};
  } catch (const RankLeft& e) {
    return {e.code, fmt::format("rank {}: {}", e.rank, e.why)};
  } catch (const std::exception& e) {
    return {failed, e.what()};
  }
}

}  // namespace
}  // namespace mdana::cli

int main(int argc, char** argv) {
  const mdana::Ending ending = mdana::end_of_ranks(mdana::cli::run_guarded(argc, argv));
  mdana::cli::end_progress();
  if (!ending.told.empty() && mdana::is_first_rank()) std::cerr << "mdana: " << ending.told << "\n";
  mdana::leave_ranks(ending.code);
  return ending.code;
}
