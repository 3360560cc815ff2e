// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/figure.hpp"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include "reports/atomic_file.hpp"
#include "reports/series_colours.hpp"

extern char** environ;

namespace mdana {
namespace {

/// A gnuplot string: nothing in it is interpreted.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' ? std::string("''") : c == '\n' ? " " : std::string(1, c);
  return result + "'";
}

std::string data_block(const Series& series, std::size_t index) {
  std::string text = fmt::format("$data{} << EOD\n", index);
  for (std::size_t i = 0; i < series.x.size(); ++i)
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i]))
      text += fmt::format("{} {}\n", series.x[i], series.y[i]);
  return text + "EOD\n";
}

std::string plot_clause(const Series& series, std::size_t index) {
  const std::string_view colour = series_colours[index % series_colours.size()];
  const char* style = "";
  switch (series.style) {
    case Series::Style::line: style = "lines lw 2"; break;
    case Series::Style::dashed: style = "lines lw 2 dt 2"; break;
    case Series::Style::points: style = "points pt 7 ps 0.5"; break;
  }
  return fmt::format("$data{} using 1:2 with {} lc rgb '{}' title {}", index, style, colour,
                     quoted(series.label));
}

/// The environment with a UTF-8 locale, for labels beyond ASCII.
std::vector<std::string> utf8_environment() {
  std::vector<std::string> variables{"LC_ALL=C.UTF-8"};
  for (char** v = environ; *v; ++v)
    if (std::strncmp(*v, "LC_ALL=", 7) != 0) variables.emplace_back(*v);
  return variables;
}

/// Runs gnuplot in the directory without a shell; false if it is not installed.
bool run_gnuplot(const std::filesystem::path& directory, const std::string& script) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  std::string program = "gnuplot", argument = script;
  char* arguments[] = {program.data(), argument.data(), nullptr};
  std::vector<std::string> variables = utf8_environment();
  std::vector<char*> environment;
  for (std::string& v : variables) environment.push_back(v.data());
  environment.push_back(nullptr);
  pid_t child = 0;
  const int error = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments,
                                 environment.data());
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) return false;
  if (error != 0) throw std::runtime_error(fmt::format("gnuplot: {}", std::strerror(error)));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (status != 0) throw std::runtime_error(fmt::format("gnuplot failed on {}", script));
  return true;
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

std::string gnuplot_script(const Figure& figure) {
  std::string text = fmt::format("# gnuplot {0}.gp writes {0}.svg\n", figure.name);
  text += "set terminal svg size 720,460 dynamic font 'Helvetica,14' background '#ffffff'\n"
          "set encoding utf8\nset termoption noenhanced\nset grid lc rgb '#dddddd'\n";
  text += figure.series.size() > 4 ? "set key outside right top vertical\n"
                                   : "set key outside top center horizontal\n";
  text += fmt::format("set output {}\nset title {}\nset xlabel {}\nset ylabel {}\n",
                      quoted(figure.name + ".svg"), quoted(figure.title), quoted(figure.x_label),
                      quoted(figure.y_label));
  if (figure.log_x) text += "set logscale x\nset format x '%.0e'\n";
  if (figure.log_y) text += "set logscale y\nset format y '%.0e'\n";
  for (std::size_t k = 0; k < figure.series.size(); ++k) text += data_block(figure.series[k], k);
  text += "plot ";
  for (std::size_t k = 0; k < figure.series.size(); ++k)
    text += (k ? ", \\\n     " : "") + plot_clause(figure.series[k], k);
  return text + "\n";
}

std::string draw(const Figure& figure, const std::filesystem::path& directory) {
  const std::string script = figure.name + ".gp";
  write_file(directory / script, gnuplot_script(figure));
  if (!run_gnuplot(directory, script)) return {};
  return read_text(directory / (figure.name + ".svg"));
}

}  // namespace mdana
