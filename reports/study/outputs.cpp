// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/outputs.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "readers/physical.hpp"
#include "reports/atomic_file.hpp"
#include "reports/csv.hpp"
#include "reports/live_figure.hpp"
#include "reports/study/aggregate_record.hpp"
#include "reports/study/hdf5_file.hpp"
#include "reports/study/page.hpp"
#include "reports/study/pooled_figures.hpp"
#include "reports/study/provenance.hpp"
#include "reports/study/run_pictures.hpp"
#include "reports/version.hpp"

namespace mdana {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Series without a point would not be drawn, and a figure without a series would be an error of gnuplot.
bool drawable(Figure& figure) {
  std::erase_if(figure.series, [](const Series& s) {
    for (std::size_t i = 0; i < s.x.size(); ++i)
      if (std::isfinite(s.x[i]) && std::isfinite(s.y[i])) return false;
    return true;
  });
  return !figure.series.empty();
}

/// Tables and figures of one run.
void write_run(const ReportedRun& run, const RunRecord& record, const fs::path& directory) {
  fs::create_directories(directory);
  for (const NamedTable& named : record.tables)
    if (named.table.rows() > 0) write_file(directory / (named.name + ".csv"), to_csv(named.table));
  for (Figure figure : record.figures)
    if (drawable(figure)) draw(figure, directory);
  if (!record.snapshots.empty()) draw(snapshot_figure(run, record), directory);
}

PageFigure on_page(const Figure& figure) { return {figure.name, figure.alt, live_figure(figure)}; }

/// Named by its run, as each run has a figure of that name; curves that are not of laws are of the run.
PageFigure on_page(Figure figure, const ReportedRun& run) {
  for (Series& s : figure.series)
    if (s.style != Series::Style::dashed) s.run = run.name;
  const std::string name = std::exchange(figure.name, fmt::format("runs/{}/{}", run.file, figure.name));
  return {name, figure.alt, live_figure(figure)};
}

ReportedRun reported(const StudyRun& run) {
  ReportedRun r;
  r.name = run.plan->name;
  r.group = run.plan->group;
  r.file = run.file;
  r.scene = run.scene;
  r.left_out = run.state == RunState::left_out;
  if (!run.done()) r.failure = run.why.empty() ? "not run" : run.why;
  return r;
}

Json run_json(const ReportedRun& run) {
  Json json{{"name", run.name}, {"group", run.group}};
  if (run.measured()) {
    json["directory"] = "runs/" + run.file;
    json.update(run.document);
  } else {
    json[run.left_out ? "not_run" : "failure"] = run.failure;
  }
  return json;
}

Json left_out_json(const std::vector<LeftOut>& list) {
  Json json = Json::array();
  for (const LeftOut& l : list) json.push_back({{"what", l.what}, {"reason", l.reason}});
  return json;
}

/// What units lj stand for (P1, Table I).
Table units_table() {
  Table table;
  std::vector<std::string> names{"argon", "water", "silver"};
  const std::pair<const char*, Dimension> columns[] = {
      {"mass", dimension::mass},         {"length", dimension::length}, {"energy", dimension::energy},
      {"time", dimension::time},         {"velocity", dimension::velocity}, {"force", dimension::force},
      {"pressure", dimension::pressure}, {"surface_energy", dimension::surface_energy}};
  table.add_column({"material", {}, names}, {0, 1, 2});
  for (const auto& [name, d] : columns) {
    std::vector<double> values;
    for (const std::string& material : names) values.push_back(parse_physical(material).of(d));
    table.add_column({std::string(name) + "_SI", d}, std::move(values));
  }
  return table;
}

/// The report as it is made.
class Report {
 public:
  Report(const StudyPlan& plan, const std::vector<StudyRun>& runs, const RunCache& cache, fs::path directory,
         const ReportOptions& options)
      : plan_(plan), cache_(cache), directory_(std::move(directory)), options_(options), figures_(plan.settings.figures) {
    for (const StudyRun& run : runs) reported_.push_back(reported(run));
    for (const ReportedRun& run : reported_) pointers_.push_back(&run);
  }

  WrittenReport write() {
    for (const char* folder : {"figures", "tables", "runs"}) fs::create_directory(directory_ / folder);
    write_runs();
    StudyHdf5 hdf5(directory_ / "results.h5");
    read_runs(hdf5);
    fits_ = fit_study(pointers_, std::move(aggregates_), plan_.settings);
    draw_pooled();
    write_tables(hdf5);
    list_left_out();
    const Json document = results();
    hdf5.finish(document);
    const std::string json = to_text(document);
    write_file(directory_ / "results.json", json);
    write_file(directory_ / "results.csv", to_csv(runs_table(pointers_)));
    write_file(directory_ / "index.html", study_page({plan_.title, place(), sections_, pooled_, fits_, left_out_}));
    return {json, std::ranges::any_of(reported_, is_damaged)};
  }

 private:
  static bool is_damaged(const ReportedRun& run) {
    return run.measured() && std::ranges::any_of(run.document["warnings"], [](const Json& warning) {
             return warning.get<std::string>().starts_with("damaged input");
           });
  }

  fs::path place_of(const ReportedRun& run) const { return directory_ / "runs" / run.file; }
  std::string place() const { return (plan_.file.empty() ? plan_.directory : plan_.file).string(); }

  /// Each run in a process.
  void write_runs() {
    std::vector<Work> works;
    for (const ReportedRun& run : reported_)
      if (run.measured()) works.push_back([&] { write_run(run, cache_.load(run.file), place_of(run)); });
    do_all(works);
  }

  /// What a report cannot do without.
  void do_all(const std::vector<Work>& works) {
    run_in_processes(works, options_.jobs, options_.sweeping.stop, [](const WorkDone& done) {
      if (!done.failure.empty()) throw std::runtime_error(done.failure);
    });
  }

  void read_runs(StudyHdf5& hdf5) {
    RunPictures pictures(static_cast<std::size_t>(std::ranges::count_if(reported_, &ReportedRun::measured)));
    for (ReportedRun& run : reported_) {
      sections_.push_back({&run, {}});
      if (!run.measured()) continue;
      RunRecord record = cache_.load(run.file);
      run.document = record.document;
      run.numbers = record.numbers;
      figures_.add(run, record);
      hdf5.add_run(run, record);
      if (run.aggregate()) aggregates_.push_back(compressed_of(run.name, record));
      sections_.back().figures = pictures.of(run, record);
      sections_.back().structure = structure_text(run);
      for (Figure& figure : record.figures)
        if (drawable(figure)) sections_.back().figures.push_back(on_page(std::move(figure), run));
    }
    if (pictures.without_view() > 0)
      left_out_.push_back({fmt::format("3-D views of {} runs with lattice defects", pictures.without_view()),
                           "the page would grow too large; mdana defects --vtp writes them"});
  }

  void draw_pooled() {
    std::vector<Figure> figures = figures_.finish(pointers_, fits_);
    std::erase_if(figures, [](Figure& figure) { return !drawable(figure); });
    std::vector<Work> works;
    for (const Figure& figure : figures) works.push_back([&] { draw(figure, directory_ / "figures"); });
    do_all(works);
    for (const Figure& figure : figures) pooled_.push_back(on_page(figure));
  }

  void write_tables(StudyHdf5& hdf5) {
    const auto first = std::ranges::find_if(reported_, &ReportedRun::measured);
    const Units units = first == reported_.end() ? Units::lj : first->units();
    std::vector<NamedTable> tables = fits_.tables;
    tables.push_back({"velocities", velocities_table(pointers_)});
    const bool lj = std::ranges::any_of(reported_, [](const ReportedRun& r) { return r.measured() && r.units() == Units::lj; });
    if (lj) tables.push_back({"units", units_table()});
    for (const NamedTable& named : tables) {
      if (named.table.rows() == 0) continue;
      write_file(directory_ / "tables" / (named.name + ".csv"), to_csv(named.table));
      hdf5.add_table(named, units);
    }
    hdf5.add_table({"runs", runs_table(pointers_)}, units);
  }

  void list_left_out() {
    for (const LeftOut& l : figures_.left_out()) left_out_.push_back(l);
    if (!StudyHdf5::available()) left_out_.push_back({"results.h5", "this build has no HDF5"});
    const bool undrawn = std::ranges::any_of(
        pooled_, [&](const PageFigure& f) { return !fs::exists(directory_ / "figures" / (f.name + ".svg")); });
    if (undrawn) left_out_.push_back({"SVG and PDF of figures", "gnuplot is not installed; their data and scripts are there"});
  }

  Json results() const {
    Json json{{"command", "report"}, {"mdana_version", version}, {"provenance", provenance()},
              {"directory", plan_.directory.string()}, {"study", plan_.file.empty() ? Json() : Json(plan_.file.filename().string())},
              {"title", plan_.title}, {"runs", Json::array()}};
    for (const ReportedRun& run : reported_) json["runs"].push_back(run_json(run));
    json["sizes"] = fits_.sizes;
    json["laws"] = fits_.laws;
    json["aggregates"] = fits_.aggregates;
    json["figures"] = Json::array();
    for (const PageFigure& figure : pooled_)
      json["figures"].push_back({{"name", figure.name}, {"table", "figures/" + figure.name + ".csv"}, {"shows", figure.alt}});
    json["left_out"] = left_out_json(fits_.left_out);
    for (const Json& l : left_out_json(left_out_)) json["left_out"].push_back(l);
    return json;
  }

  const StudyPlan& plan_;
  const RunCache& cache_;
  fs::path directory_;
  const ReportOptions& options_;
  std::vector<ReportedRun> reported_;
  std::vector<const ReportedRun*> pointers_;
  std::vector<CompressedRun> aggregates_;
  std::vector<PageContent::Section> sections_;
  std::vector<PageFigure> pooled_;
  PooledFigures figures_;
  StudyFits fits_;
  std::vector<LeftOut> left_out_;
};

}  // namespace

WrittenReport write_report(const StudyPlan& plan, const std::vector<StudyRun>& runs, const RunCache& cache,
                         const fs::path& directory, const ReportOptions& options) {
  return Report(plan, runs, cache, directory, options).write();
}

}  // namespace mdana
