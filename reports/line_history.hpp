// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "analyses/defects.hpp"
#include "analyses/line_tracks.hpp"

namespace mdana {

/// The dislocation lines of a run, frame by frame; only numbers are kept.
class LineHistory {
 public:
  LineHistory();
  void keep_points() { keeps_points_ = true; }

  /// Frames in order.
  void add(const FrameDefects& found);
  void finish() { tracks_.finish(); }

  bool empty() const { return frames_.empty(); }
  const nlohmann::ordered_json& frame(std::size_t frame) const { return frames_[frame]; }  ///< lines_json
  const LineTracks& tracks() const { return tracks_; }
  /// A row for each segment of each frame.
  const Table& segments() const { return segments_; }
  /// Those of each segment from end to end, with its row; empty unless they are kept.
  const Table& points() const { return points_; }

 private:
  void add_points(const DislocationSegment& segment);

  LineTracks tracks_;
  std::vector<nlohmann::ordered_json> frames_;
  Table segments_, points_;
  bool keeps_points_ = false;
};

}  // namespace mdana
