// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/chosen_frames.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "analyses/slice.hpp"
#include "reports/line_numbers.hpp"

namespace mdana {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_atoms_drawn = 8000;    ///< of a slice, one by one
constexpr ViewLimits most_viewed{20000, 3000, 500};  ///< of a frame
constexpr double far_apart = 1.25;                ///< over the distance of the centres at first, or of touching bodies

struct ChosenFrame {
  std::size_t row;
  std::string label;
};

void choose(std::vector<ChosenFrame>& chosen, std::size_t row, const std::string& label) {
  const auto at = std::ranges::find(chosen, row, &ChosenFrame::row);
  if (at == chosen.end())
    chosen.push_back({row, label});
  else
    at->label += ", " + label;
}

std::size_t greatest(std::span<const double> delta) {
  std::size_t most = 0;
  for (std::size_t i = 0; i < delta.size(); ++i)
    if (delta[i] > delta[most] || std::isnan(delta[most])) most = i;
  return most;
}

/// The last frame before the bodies are far apart for good.
std::size_t last_drawn(std::span<const double> delta, std::size_t most, double radius_sum) {
  const double distance = far_apart * std::max(radius_sum - delta[0], radius_sum);
  std::size_t last = delta.size() - 1;
  while (last > most && radius_sum - delta[last] > distance) --last;
  return last;
}

std::vector<ChosenFrame> snapshot_frames(const Table& frames, double radius_sum) {
  const auto delta = frames.column("delta");
  const std::size_t most = greatest(delta), last = last_drawn(delta, most, radius_sum);
  std::vector<ChosenFrame> chosen;
  choose(chosen, 0, "start");
  choose(chosen, most, "maximum compression");
  choose(chosen, last, last + 1 == delta.size() ? "end" : "after separation");
  return chosen;
}

double value(const Table& table, const char* column, std::size_t row) {
  return table.has(column) ? table.column(column)[row] : std::numeric_limits<double>::quiet_NaN();
}

Json known(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// A pass over a single frame.
class FramePass {
 public:
  FramePass(const Run& run, const SweepOptions& sweeping, std::size_t row) : run_(run), options_(sweeping) {
    const std::uint64_t frame = sweeping.choice.first + sweeping.choice.stride * row;
    options_.choice = {frame, frame + 1, 1};
    options_.frames = 1;
    options_.selection = run.selection;
    options_.progress = nullptr;
  }

  void add(std::unique_ptr<Analysis> analysis) { analyses_.push_back(std::move(analysis)); }
  void go() { sweep(run_.dump, run_.bodies, run_.masses, analyses_, options_); }

 private:
  const Run& run_;
  SweepOptions options_;
  std::vector<std::unique_ptr<Analysis>> analyses_;
};

void add_snapshots(RunRecord& record, const Run& run, const Table& frames, double radius_sum, const SweepOptions& sweeping) {
  std::optional<double> diameter;
  if (run.scene.interaction == Interaction::aggregate && run.scene.grains.radius) diameter = 2 * *run.scene.grains.radius;
  for (const ChosenFrame& chosen : snapshot_frames(frames, radius_sum)) {
    FramePass pass(run, sweeping, chosen.row);
    pass.add(make_slice(diameter, [&](const Slice& slice) {
      diameter = slice.diameter;
      record.snapshots.push_back(snapshot_of(slice));
    }));
    pass.go();
    Snapshot& snapshot = record.snapshots.back();
    snapshot.label = chosen.label;
    snapshot.step = static_cast<std::int64_t>(frames.column("step")[chosen.row]);
    snapshot.time = value(frames, "time", chosen.row);
    snapshot.delta = value(frames, "delta", chosen.row);
  }
  limit(record.snapshots, most_atoms_drawn);
  Json list = Json::array();
  for (const Snapshot& s : record.snapshots)
    list.push_back({{"shows", s.label}, {"step", s.step}, {"time", known(s.time)}, {"delta", known(s.delta)}, {"atoms", s.atoms}});
  record.document["snapshots"] = std::move(list);
}

#ifdef MDANA_WITH_DEFECTS

std::vector<ChosenFrame> viewed_frames(const DefectHistory& history) {
  std::vector<ChosenFrame> chosen;
  const auto first = first_defect(history);
  if (!first) return chosen;
  choose(chosen, *first, "start of defects");
  choose(chosen, greatest(history.delta), "maximum compression");
  choose(chosen, history.steps.size() - 1, "end");
  std::ranges::sort(chosen, {}, &ChosenFrame::row);
  return chosen;
}

/// The numbers of a frame that a table beside the view tells.
Json told(const ChosenFrame& chosen, const DefectHistory& h, const FrameDefects& found) {
  Json json{{"shows", chosen.label}, {"step", h.steps[chosen.row]}};
  if (!h.times.empty()) json["time"] = h.times[chosen.row];
  json["delta"] = h.delta[chosen.row];
  for (const char* column : {"hcp", "bulk_defect", "fault_area", "twin_area"}) json[column] = h.table.column(column)[chosen.row];
  const Json lines = lines_json(found.lines, std::vector<std::uint32_t>(found.lines.segments.size()), found.spacing);
  for (const char* name : {"lines", "total_length", "burgers_residual"}) json[name] = lines.at(name);
  return json;
}

void add_spheres(ViewedFrame& frame, const FrameDefects& found, const Radii& radii) {
  const Eigen::Vector3d line = found.centre[1] - found.centre[0];
  for (const std::size_t body : {0, 1})
    for (ViewedLine& circle : viewed_sphere("spheres of the bodies' radii", found.centre[body], radii.value[body], line))
      frame.lines.push_back(std::move(circle));
}

void add_views(RunRecord& record, const Run& run, const DefectHistory& history, const Radii& radii, const SweepOptions& sweeping) {
  Json list = Json::array();
  for (const ChosenFrame& chosen : viewed_frames(history)) {
    DefectSettings settings;
    settings.ids = run.first.has_column("id");
    settings.lines = settings.labels = true;
    settings.product = [&](const FrameHeader&, const FrameDefects& found) {
      record.views.push_back(viewed_frame(found, fmt::format("{}, δ = {:.4g}", chosen.label, history.delta[chosen.row])));
      limit(record.views.back(), most_viewed);
      add_spheres(record.views.back(), found, radii);
      list.push_back(told(chosen, history, found));
    };
    FramePass pass(run, sweeping, chosen.row);
    pass.add(make_defects(std::move(settings)));
    pass.go();
  }
  record.document["defects"]["shown_frames"] = std::move(list);
}

#else

void add_views(RunRecord&, const Run&, const DefectHistory&, const Radii&, const SweepOptions&) {}

#endif

}  // namespace

void add_chosen_frames(RunRecord& record, const RunTask& task, const Run& run, const Table& frames, const Radii& radii,
                       const DefectHistory* history, const SweepOptions& sweeping) {
  if (task.snapshots) add_snapshots(record, run, frames, radii.sum(), sweeping);
  if (history) add_views(record, run, *history, radii, sweeping);
}

}  // namespace mdana
