// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/line_tracks.hpp"

#include <algorithm>
#include <cmath>

#include "analyses/defects.hpp"

namespace mdana {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr std::size_t resampled = 17;  ///< points of a segment that are compared

/// Evenly along the line.
Points evenly(const Points& points) {
  std::vector<double> s{0};
  for (std::size_t i = 1; i < points.size(); ++i) s.push_back(s.back() + (points[i] - points[i - 1]).norm());
  Points even;
  std::size_t i = 1;
  for (std::size_t k = 0; k < resampled; ++k) {
    const double at = s.back() * static_cast<double>(k) / (resampled - 1);
    while (i + 1 < s.size() && s[i] < at) ++i;
    const double whole = s[i] - s[i - 1];
    const double part = whole > 0 ? std::clamp((at - s[i - 1]) / whole, 0.0, 1.0) : 0;
    even.push_back(points[i - 1] + part * (points[i] - points[i - 1]));
  }
  return even;
}

bool is_closed(const DislocationSegment& s) { return s.ends[0] == LineEnd::closed; }

/// The points of a closed line from the one on that makes it nearest to another.
void start_like(Points& points, const Points& other) {
  points.pop_back();
  double least = HUGE_VAL;
  std::size_t best = 0;
  for (std::size_t shift = 0; shift < points.size(); ++shift) {
    double sum = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      sum += (points[(k + shift) % points.size()] - other[k]).squaredNorm();
    if (sum >= least) continue;
    least = sum;
    best = shift;
  }
  std::ranges::rotate(points, points.begin() + static_cast<std::ptrdiff_t>(best));
  points.push_back(points.front());
}

/// The mean distance of the points of one to the nearest of the other, the greater of both ways.
double distance(const Points& a, const Points& b) {
  const auto mean = [](const Points& from, const Points& to) {
    double sum = 0;
    for (const auto& p : from) {
      double least = HUGE_VAL;
      for (const auto& q : to) least = std::min(least, (p - q).squaredNorm());
      sum += std::sqrt(least);
    }
    return sum / static_cast<double>(from.size());
  };
  return std::max(mean(a, b), mean(b, a));
}

/// Sum of line x motion: the area that a line sweeps, as a vector.
Eigen::Vector3d swept_area(const Points& before, const Points& now) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (std::size_t k = 1; k < before.size(); ++k) {
    const Eigen::Vector3d line = (before[k] - before[k - 1] + now[k] - now[k - 1]) / 2;
    const Eigen::Vector3d motion = (now[k] - before[k] + now[k - 1] - before[k - 1]) / 2;
    area += line.cross(motion);
  }
  return area;
}

/// 1 or -1: the sign of the first component that is not 0.
double sign(const Eigen::Vector3d& v) {
  for (const double x : v)
    if (std::abs(x) > 1e-9) return x > 0 ? 1 : -1;
  return 1;
}

bool same(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).cwiseAbs().maxCoeff() < 1e-3; }

}  // namespace

void LineTracks::follow_lattices(const LineFrame& frame) {
  for (std::size_t b = 0; b < 2; ++b)
    if (frame.lattice[b]) lattice_[b] = lattice_[b] ? nearest_turn(*frame.lattice[b], *lattice_[b]) : frame.lattice[b];
}

Eigen::Vector3d LineTracks::followed(const DislocationSegment& segment, const LineFrame& frame) const {
  const std::size_t b = segment.body - 1u;
  if (!frame.lattice[b] || !segment.aligned) return segment.burgers;
  return lattice_[b]->conjugate() * (*frame.lattice[b] * segment.burgers);
}

std::vector<std::uint32_t> LineTracks::add(const LineFrame& frame) {
  follow_lattices(frame);
  std::vector<Seen> now;
  for (const DislocationSegment& s : frame.lines.segments) {
    now.push_back({s, followed(s, frame), evenly(s.points)});
    for (auto& p : now.back().shape) p -= frame.centre[s.body - 1u];
  }
  go_on(now, frame);
  std::vector<std::uint32_t> found;
  for (Seen& seen : now) {
    note(seen);
    found.push_back(seen.track);
  }
  last_ = std::move(now);
  ++frames_;
  return found;
}

/// Gives tracks of the last frame to the segments, nearest first.
void LineTracks::go_on(std::vector<Seen>& now, const LineFrame& frame) {
  struct Pair {
    double distance;
    std::size_t before, now;
    bool turned;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < last_.size(); ++i)
    for (std::size_t k = 0; k < now.size(); ++k) {
      const bool straight = same(last_[i].burgers, now[k].burgers), turned = same(last_[i].burgers, -now[k].burgers);
      if (last_[i].segment.body != now[k].segment.body || (!straight && !turned)) continue;
      const double d = distance(last_[i].shape, now[k].shape);
      if (d < farthest * frame.spacing) pairs.push_back({d, i, k, turned});
    }
  std::ranges::stable_sort(pairs, {}, &Pair::distance);
  std::vector<char> gone(last_.size());
  for (const Pair& pair : pairs) {
    if (gone[pair.before] || now[pair.now].track != no_track) continue;
    gone[pair.before] = 1;
    now[pair.now].track = last_[pair.before].track;
    sweep(last_[pair.before], now[pair.now], pair.turned, frame.volume[now[pair.now].segment.body - 1u]);
  }
}

/// Notes a segment of this frame in its track, or in a new one.
void LineTracks::note(Seen& seen) {
  const DislocationSegment& s = seen.segment;
  if (seen.track == no_track) {
    seen.track = static_cast<std::uint32_t>(tracks_.size());
    tracks_.push_back({s.body, s.family, seen.burgers, frames_, frames_, 0, s.points[s.points.size() / 2]});
  }
  LineTrack& track = tracks_[seen.track];
  track.last = frames_;
  track.longest = std::max(track.longest, s.length.value);
}

void LineTracks::sweep(const Seen& before, const Seen& now, bool turned, double volume) {
  if (!(volume > 0)) return;
  const Points& a = before.shape;
  Points b = now.shape;
  if (turned) std::ranges::reverse(b);
  if (is_closed(before.segment) && is_closed(now.segment)) start_like(b, a);
  const Eigen::Vector3d area = swept_area(a, b);
  const DislocationSegment& s = before.segment;
  const Eigen::Vector3d burgers = s.crystal * s.burgers_here;
  distortion_[s.body - 1u] += burgers * area.transpose() / volume;
  if (!s.slip_plane) return;
  const Eigen::Vector3d normal = (s.crystal * s.slip_plane->cast<double>()).normalized();
  const double shear = burgers.norm() * normal.dot(area) / volume * sign(s.burgers_here);
  const Eigen::Vector3d positive = sign(s.burgers_here) * s.burgers_here;
  auto system = std::ranges::find_if(slip_, [&](const SlipSystem& known) {
    return known.body == s.body && known.plane == *s.slip_plane && same(known.burgers, positive);
  });
  if (system == slip_.end()) system = slip_.insert(slip_.end(), {s.body, *s.slip_plane, positive, 0, 0});
  system->shear += std::abs(shear);
  if (shear < 0) system->reversed += std::abs(shear);
}

void LineTracks::finish() {
  for (SlipSystem& system : slip_) system.reversed = std::min(system.reversed, system.shear - system.reversed);
  std::ranges::stable_sort(slip_, std::greater(), &SlipSystem::shear);
}

}  // namespace mdana
