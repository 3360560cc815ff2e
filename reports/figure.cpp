// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/figure.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include "reports/atomic_file.hpp"
#include "reports/csv.hpp"
#include "reports/series_colours.hpp"

extern char** environ;

namespace mdana {
namespace {

constexpr std::size_t most_named = 12;  ///< curves in a key
constexpr double key_width = 640, key_row = 19, key_sample = 56, key_letter = 8.5;  ///< about [pixels]

/// A gnuplot string: nothing in it is interpreted.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' ? std::string("''") : c == '\n' ? " " : std::string(1, c);
  return result + "'";
}

bool has_errors(const Series& series) { return series.y_error.size() == series.y.size() && !series.y.empty(); }

/// An error that is not known is not drawn.
double error_drawn(const Series& series, std::size_t i) {
  return std::isfinite(series.y_error[i]) ? series.y_error[i] : 0.0;
}

std::string data_block(const Series& series, std::size_t index) {
  std::string text = fmt::format("$data{} << EOD\n", index);
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) continue;
    text += fmt::format("{} {}", series.x[i], series.y[i]);
    if (has_errors(series)) text += fmt::format(" {}", error_drawn(series, i));
    text += '\n';
  }
  return text + "EOD\n";
}

/// Where the text stands in the list, to which it is added if it does not.
std::size_t place_of(std::vector<std::string>& list, const std::string& text) {
  const auto at = std::ranges::find(list, text);
  if (at != list.end()) return static_cast<std::size_t>(at - list.begin());
  list.push_back(text);
  return list.size() - 1;
}

/// Where runs are compared the place of a series' run among the labels, else that of its own label.
std::vector<std::size_t> colour_places(const Figure& figure) {
  std::set<std::string> runs;
  for (const Series& s : figure.series)
    if (!s.run.empty()) runs.insert(s.run);
  std::vector<std::string> keys;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < figure.series.size(); ++k) {
    const Series& s = figure.series[k];
    places.push_back(place_of(keys, runs.size() > 1 && !s.run.empty() ? s.run : fmt::format("series {}", k)));
  }
  return places;
}

/// Curves that the key names: those of no single run, then the first ones.
std::vector<bool> named_curves(const Figure& figure) {
  std::vector<bool> named(figure.series.size());
  std::size_t count = 0;
  for (const bool laws : {true, false})
    for (std::size_t k = 0; k < named.size(); ++k)
      if (figure.series[k].run.empty() == laws && count < most_named) named[k] = true, ++count;
  return named;
}

struct Key {
  std::string commands;
  double height = 0;  ///< of its rows [pixels]
};

/// Above the plot; if it is long below it, on paper that is as much longer.
Key key_of(const Figure& figure, const std::vector<bool>& named) {
  const auto count = static_cast<std::size_t>(std::ranges::count(named, true));
  if (named.size() <= 4) return {"set key outside top center horizontal\n"};
  std::size_t longest = 0;
  for (std::size_t k = 0; k < named.size(); ++k)
    if (named[k]) longest = std::max(longest, figure.series[k].label.size());
  const auto in_row = std::max(1.0, std::floor(key_width / (key_sample + key_letter * static_cast<double>(longest))));
  double rows = 1 + std::ceil(static_cast<double>(count) / in_row);
  std::string commands = "set key outside bottom center horizontal\n";
  if (count < named.size()) {
    commands += fmt::format("set key title {}\n", quoted(fmt::format("{} of {} curves, all in {}.csv", count, named.size(), figure.name)));
    ++rows;
  }
  return {commands, key_row * rows};
}

std::string plot_clause(const Series& series, std::size_t index, std::size_t place, bool named) {
  const std::string_view colour = series_colours[place % series_colours.size()];
  const char* style = "";
  switch (series.style) {
    case Series::Style::line: style = "lines lw 2"; break;
    case Series::Style::dashed: style = "lines lw 2 dt 2"; break;
    case Series::Style::dotted: style = "lines lw 2 dt 3"; break;
    case Series::Style::dash_dotted: style = "lines lw 2 dt 4"; break;
    case Series::Style::points: style = has_errors(series) ? "yerrorbars pt 7 ps 0.5" : "points pt 7 ps 0.5"; break;
  }
  return fmt::format("$data{} using {} with {} lc rgb '{}' {}", index, has_errors(series) ? "1:2:3" : "1:2", style, colour,
                     named ? "title " + quoted(series.label) : "notitle");
}

/// The environment with a UTF-8 locale, for labels beyond ASCII, and UTC, for dates of one length.
std::vector<std::string> utf8_environment() {
  std::vector<std::string> variables{"LC_ALL=C.UTF-8", "TZ=UTC"};
  for (char** v = environ; *v; ++v)
    if (std::strncmp(*v, "LC_ALL=", 7) != 0 && std::strncmp(*v, "TZ=", 3) != 0) variables.emplace_back(*v);
  return variables;
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The PDF tells when it was made, which would make the same figure other bytes each time.
void undate(const std::filesystem::path& pdf) {
  constexpr std::string_view key = "/CreationDate (D:", date = "19700101000000";
  std::string text = read_text(pdf);
  const std::size_t at = text.find(key);
  if (at == text.npos || at + key.size() + date.size() > text.size()) return;
  text.replace(at + key.size(), date.size(), date);
  write_file(pdf, text);
}

/// A range for values that are all the same, about which gnuplot would complain; empty for others.
std::string range_command(const Figure& figure, char axis, std::vector<double> Series::*values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Series& series : figure.series)
    for (std::size_t i = 0; i < series.x.size(); ++i)
      if (std::isfinite(series.x[i]) && std::isfinite(series.y[i]))
        low = std::min(low, (series.*values)[i]), high = std::max(high, (series.*values)[i]);
  if (low != high) return {};
  const double margin = low == 0 ? 1 : 0.1 * std::abs(low);
  return fmt::format("set {}range [{}:{}]\n", axis, low - margin, high + margin);
}

std::string plot_command(const Figure& figure, const std::vector<bool>& named) {
  const std::vector<std::size_t> places = colour_places(figure);
  std::string text = "plot ";
  for (std::size_t k = 0; k < figure.series.size(); ++k)
    text += (k ? ", \\\n     " : "") + plot_clause(figure.series[k], k, places[k], named[k]);
  return text + "\n";
}

}  // namespace

std::string gnuplot_script(const Figure& figure) {
  const std::vector<bool> named = named_curves(figure);
  const Key key = key_of(figure, named);
  const double height = 460 + key.height;
  std::string text = fmt::format("# gnuplot {0}.gp writes {0}.svg and {0}.pdf\n", figure.name);
  text += "set encoding utf8\nset termoption noenhanced\nset grid lc rgb '#dddddd'\n";
  text += key.commands;
  text += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", quoted(figure.title), quoted(figure.x_label),
                      quoted(figure.y_label));
  if (figure.log_x) text += "set logscale x\nset format x '%.0e'\n";
  if (figure.log_y) text += "set logscale y\nset format y '%.0e'\n";
  text += range_command(figure, 'x', &Series::x) + range_command(figure, 'y', &Series::y);
  for (std::size_t k = 0; k < figure.series.size(); ++k) text += data_block(figure.series[k], k);
  text += fmt::format("set terminal svg size 720,{:.0f} dynamic noenhanced font 'Helvetica,14' background '#ffffff'\n"
                      "set output {}\n", height, quoted(figure.name + ".svg")) + plot_command(figure, named);
  text += fmt::format("set terminal pdfcairo size 16cm,{:.2f}cm noenhanced font 'Helvetica,12'\nset output {}\n",
                      10.2 * height / 460, quoted(figure.name + ".pdf")) + plot_command(figure, named);
  return text;
}

Table figure_table(const Figure& figure) {
  std::vector<std::string> labels;
  std::vector<double> series, x, y, error, point;
  std::vector<std::string> points{""};
  bool any_error = false;
  for (const Series& s : figure.series) {
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      series.push_back(static_cast<double>(labels.size()));
      x.push_back(s.x[i]);
      y.push_back(s.y[i]);
      error.push_back(has_errors(s) ? s.y_error[i] : std::numeric_limits<double>::quiet_NaN());
      point.push_back(static_cast<double>(place_of(points, i < s.names.size() ? s.names[i] : "")));
    }
    any_error = any_error || has_errors(s);
    labels.push_back(s.label);
  }
  Table table;
  if (!labels.empty()) table.add_column({"series", dimension::none, std::move(labels)}, std::move(series));
  table.add_column({figure.x_name, dimension::none}, std::move(x));
  table.add_column({figure.y_name, dimension::none}, std::move(y));
  if (any_error) table.add_column({figure.y_name + "_error", dimension::none}, std::move(error));
  if (points.size() > 1) table.add_column({"point", dimension::none, std::move(points)}, std::move(point));
  return table;
}

bool run_gnuplot(const std::filesystem::path& directory, const std::string& name) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  std::string program = "gnuplot", argument = name + ".gp";
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
  if (status != 0) throw std::runtime_error(fmt::format("gnuplot failed on {}", (directory / (name + ".gp")).string()));
  undate(directory / (name + ".pdf"));
  return true;
}

std::string draw(const Figure& figure, const std::filesystem::path& directory) {
  write_file(directory / (figure.name + ".gp"), gnuplot_script(figure));
  write_file(directory / (figure.name + ".csv"), to_csv(figure_table(figure)));
  if (!run_gnuplot(directory, figure.name)) return {};
  return read_text(directory / (figure.name + ".svg"));
}

}  // namespace mdana
