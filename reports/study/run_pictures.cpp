// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/run_pictures.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "reports/defect_numbers.hpp"
#include "reports/html.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t snapshot_bytes = 2'000'000, view_bytes = 800'000;  ///< of all runs of a page

/// What each of so many runs may take [bytes].
std::size_t share(std::size_t bytes, std::size_t runs, std::size_t least, std::size_t most) {
  return std::clamp(bytes / std::max<std::size_t>(runs, 1), least, most);
}

PageFigure snapshots_on_page(const ReportedRun& run, const RunRecord& record, std::size_t runs) {
  const std::size_t bytes = share(snapshot_bytes, runs, 6000, 300'000) * 3 / 4;  // base64
  const SnapshotFigure figure = within(snapshot_figure(run, record), bytes);
  const std::string text = caption(figure);
  return {"snapshots", text, html::element("figure", html::picture(snapshot_picture(figure), text) +
                                                         html::element("figcaption", html::escape(text)))};
}

/// The frame at maximum compression; else the first one.
std::size_t shown_first(const std::vector<ViewedFrame>& frames) {
  const auto most = std::ranges::find_if(frames, [](const ViewedFrame& f) { return f.label.find("maximum") != f.label.npos; });
  return static_cast<std::size_t>(most - frames.begin()) % frames.size();
}

PageFigure view_on_page(const ReportedRun& run, const RunRecord& record, std::size_t bytes) {
  DefectView view{fmt::format("runs/{}/defects", run.file), run.name + ": lattice defects", "", symbol(run.units(), dimension::length),
                  record.views, shown_first(record.views)};
  for (ViewedFrame& frame : view.frames) limit(frame, {bytes / 128, bytes / 2000, bytes / 8000});
  std::string frames;
  for (const ViewedFrame& frame : view.frames) frames += (frames.empty() ? "" : "; ") + shown_label(frame);
  view.alt = fmt::format("Atoms of hcp order, bulk defects, faults as discs of their area and dislocation lines, in the frames: {}. "
                         "The picture shows: {}.", frames, shown_label(view.frames[view.shown]));
  return {"defects", view.alt, live_view(view)};
}

/// As they are written in a table's head.
std::string shown_family(std::string name) {
  if (name == "shockley" || name == "hirth" || name == "frank") name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name == "stair_rod" ? "stair-rod" : name;
}

std::string cell(const Json& family) {
  const auto segments = family.at("segments").get<std::size_t>();
  return segments == 0 ? "0" : fmt::format("{:.4g} ({})", family.at("length").at("value").get<double>(), segments);
}

std::string lines_table(const Json& frames) {
  std::vector<std::string> head{"frame", "step", "δ", "hcp atoms", "bulk defects", "faults", "twins"};
  for (const auto& [family, unused] : frames.front().at("lines").items()) head.push_back(shown_family(family));
  head.push_back("all lines");
  std::vector<std::vector<std::string>> rows;
  for (const Json& f : frames) {
    rows.push_back({f.at("shows"), fmt::format("{}", f.at("step").get<std::int64_t>())});
    std::vector<std::string>& row = rows.back();
    for (const char* name : {"delta", "hcp", "bulk_defect", "fault_area", "twin_area"}) row.push_back(fmt::format("{:.5g}", f.at(name).get<double>()));
    for (const auto& [unused, family] : f.at("lines").items()) row.push_back(cell(family));
    row.push_back(fmt::format("{:.4g}", f.at("total_length").at("value").get<double>()));
  }
  return html::table(head, rows);
}

}  // namespace

SnapshotFigure snapshot_figure(const ReportedRun& run, const RunRecord& record) {
  return {"snapshots", run.name, run.aggregate() ? "grain" : "atom",
          parse_units(record.document.at("units").get<std::string>()).value(), record.snapshots};
}

std::vector<PageFigure> RunPictures::of(const ReportedRun& run, const RunRecord& record) {
  std::vector<PageFigure> figures;
  if (!record.snapshots.empty()) figures.push_back(snapshots_on_page(run, record, runs_));
  if (record.views.empty()) return figures;
  PageFigure view = view_on_page(run, record, share(view_bytes, runs_, 60'000, 500'000));
  if (bytes_ > 0 && bytes_ + view.html.size() > view_bytes) {
    ++without_view_;
    return figures;
  }
  bytes_ += view.html.size();
  figures.push_back(std::move(view));
  return figures;
}

std::string structure_text(const ReportedRun& run) {
  const auto defects = run.document.find("defects");
  if (defects == run.document.end()) return {};
  const auto frames = defects->find("shown_frames");
  if (frames == defects->end() || frames->empty())
    return html::paragraph(fmt::format("No lattice defects: no frame has {:g} atoms of hcp order or in bulk defects more than the first.",
                                       least_new_defects));
  const std::string length = symbol(run.units(), dimension::length);
  return html::paragraph(fmt::format("Lattice defects: areas of faults and twins [{0}²], and length of dislocation lines [{0}] with the "
                                     "number of segments, by family.", length)) +
         lines_table(*frames);
}

}  // namespace mdana
