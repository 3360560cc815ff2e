// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/lines/segments.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "analyses/moments.hpp"

namespace mdana::defects {
namespace {

constexpr double end_error = 0.5;  ///< [spacings] of an end, at a node or where the crystal ends; ends err alike
constexpr double most_tilt = 25 * std::numbers::pi / 180;  ///< mean angle of a line to its slip plane

LineEnd end_of(const LineNode& node) {
  switch (node.kind) {
    case NodeKind::surface: return LineEnd::surface;
    case NodeKind::contact: return LineEnd::contact;
    case NodeKind::lattice: return LineEnd::lattice;
    case NodeKind::inside: return LineEnd::inside;
    case NodeKind::junction: break;
  }
  return node.passed ? LineEnd::closed : LineEnd::junction;
}

/// A cube about a line, in the axes of the grain.
struct Frame {
  Eigen::Matrix3d turn;
  std::size_t atoms = 0;
};

/// The cubes about the atoms along a segment, the most frequent first; those that differ by a turn of the cube
/// into itself count as one.
std::vector<Frame> frames_along(const LineSegment& segment, const ZoneCrystal& crystal) {
  std::vector<Frame> frames;
  for (const std::uint32_t atom : segment.atoms) {
    if (!crystal.framed[atom]) continue;
    const Eigen::Matrix3d turn = crystal.turn[atom].cast<double>();
    const auto same = std::ranges::find_if(frames, [&](const Frame& f) {
      const Eigen::Matrix3d between = f.turn.transpose() * turn;
      return (between - between.array().round().matrix()).cwiseAbs().maxCoeff() < 1e-3;
    });
    if (same == frames.end())
      frames.push_back({turn, 1});
    else
      ++same->atoms;
  }
  std::ranges::stable_sort(frames, std::greater(), &Frame::atoms);
  if (frames.empty()) frames.push_back({Eigen::Matrix3d::Identity(), 0});
  return frames;
}

/// The four twins of each frame, behind them all.
void add_twins(std::vector<Frame>& frames) {
  const std::size_t count = frames.size();
  for (std::size_t k = 0; k < count; ++k)
    for (const OrderedTurn& t : lattice_turns().subspan(24, 96))
      if (t.turn.matrix.trace() == -LatticeTurn::parts) frames.push_back({frames[k].turn * t.turn.real(), 0});
}

/// A vector of the grain in the axes of a cube; 0 if it has no whole components there.
Ideal seen_from(const Eigen::Matrix3d& turn, const Ideal& v) {
  const Eigen::Vector3d here = turn.transpose() * v.cast<double>();
  const Ideal whole = here.array().round().matrix().cast<int>();
  return (here - whole.cast<double>()).cwiseAbs().maxCoeff() < 0.05 ? whole : Ideal::Zero();
}

bool is_cube(const Eigen::Matrix3d& turn) {
  return (turn - turn.array().round().matrix()).cwiseAbs().maxCoeff() < 1e-3;
}

class Describer {
 public:
  Describer(const LineNetwork& network, const LineNetwork& less_smooth, const Zone& zone, const ZoneCrystal& crystal)
      : network_(network), less_smooth_(less_smooth), zone_(zone), crystal_(crystal), spacing_(zone.spacing) {}

  DislocationLines describe() {
    DislocationLines lines;
    for (const LineNode& node : network_.nodes) lines.nodes.push_back(end_of(node));
    for (std::size_t k = 0; k < network_.segments.size(); ++k)
      lines.segments.push_back(segment(network_.segments[k], length(less_smooth_, less_smooth_.segments[k])));
    std::ranges::stable_sort(lines.segments, std::greater(), [](const DislocationSegment& s) { return s.length.value; });
    const double shortest = network_.absorbed_straight * spacing_;
    const double longest = std::max(shortest, network_.absorbed * spacing_);
    lines.absorbed = {(longest + shortest) / 2, (longest - shortest) / 2, dimension::length};
    lines.residual = residual();
    lines.unresolved = unresolved();
    return lines;
  }

 private:
  DislocationSegment segment(const LineSegment& s, double other_length) const {
    DislocationSegment told;
    const std::uint32_t atom = s.atoms.front();
    told.body = zone_.body[atom];
    told.aligned = crystal_.grains[crystal_.grain[atom]].aligned;
    told.nodes = {s.from, s.to};
    told.ends = {end_of(network_.nodes[s.from]), end_of(network_.nodes[s.to])};
    told.burgers = s.burgers.cast<double>() / ideal_parts;
    const Frame frame = name(s, told);
    set_geometry(s, frame, told);
    const double smooth_length = length(network_, s);
    const double ends = static_cast<double>(std::ranges::count_if(told.ends, [](LineEnd end) { return end != LineEnd::closed; }));
    const double error = std::hypot((other_length - smooth_length) / 2, end_error * ends);
    told.length = {smooth_length * spacing_, error * spacing_, dimension::length};
    for (const Eigen::Vector3d& p : s.points) told.points.push_back(zone_.origin + spacing_ * p);
    return told;
  }

  /// Family in the most frequent cube in which it has one, else in a twin of one.
  Frame name(const LineSegment& s, DislocationSegment& told) const {
    std::vector<Frame> frames = frames_along(s, crystal_);
    for (Frame& f : frames)
      if (is_cube(f.turn)) f.turn.setIdentity();
    add_twins(frames);
    const auto known = std::ranges::find_if(
        frames, [&](const Frame& f) { return family_of(seen_from(f.turn, s.burgers)) != LineFamily::other; });
    const Frame& frame = known != frames.end() ? *known : frames.front();
    const Ideal here = seen_from(frame.turn, s.burgers);
    told.family = family_of(here);
    told.burgers_here = (frame.turn.transpose() * told.burgers);
    if (!here.isZero()) told.burgers_here = here.cast<double>() / ideal_parts;
    told.turn = frame.turn;
    told.in_twin = !is_cube(frame.turn);
    return frame;
  }

  /// Character and slip plane, by the directions of the line in the ideal crystal.
  void set_geometry(const LineSegment& s, const Frame& frame, DislocationSegment& told) const {
    Eigen::Matrix3d map = Eigen::Matrix3d::Zero();
    for (const std::uint32_t atom : s.atoms) map += crystal_.map[atom].cast<double>();
    map *= ideal_parts / static_cast<double>(s.atoms.size());
    told.crystal = spacing_ * map * frame.turn;
    const std::vector<Eigen::Vector3d> line = pieces(s, frame.turn.transpose() * map.inverse());
    if (line.empty()) return;
    const Eigen::Vector3d b = told.burgers_here.normalized();
    const Moments<1> angle = angle_to(b, line);
    told.character = angle.mean[0];
    told.character_spread = std::sqrt(angle.spread / angle.weight);
    double least = most_tilt;
    for (const Eigen::Vector3i& plane : {Eigen::Vector3i(1, 1, 1), {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}}) {
      const Eigen::Vector3d normal = plane.cast<double>().normalized();
      const double tilt = std::numbers::pi / 2 - angle_to(normal, line).mean[0];
      if (!(std::abs(normal.dot(b)) < 1e-6) || !(tilt < least)) continue;
      least = tilt;
      told.slip_plane = plane;
    }
  }

  /// From point to point, after a map.
  static std::vector<Eigen::Vector3d> pieces(const LineSegment& s, const Eigen::Matrix3d& map) {
    std::vector<Eigen::Vector3d> all;
    for (std::size_t i = 1; i < s.points.size(); ++i) {
      all.emplace_back(map * (s.points[i] - s.points[i - 1]));
      if (!(all.back().norm() > 0)) all.pop_back();
    }
    return all;
  }

  /// The angle between a direction and pieces of a line, by their lengths [rad]: 0 to pi/2.
  static Moments<1> angle_to(const Eigen::Vector3d& direction, const std::vector<Eigen::Vector3d>& line) {
    Moments<1> angle;
    for (const Eigen::Vector3d& piece : line) {
      const double l = piece.norm(), cosine = std::min(1.0, std::abs(direction.dot(piece)) / l);
      angle.merge({1, l, Moments<1>::Vector(std::acos(cosine)), 0});
    }
    return angle;
  }

  /// What segments bring to each region without a known lattice, body by body.
  std::vector<UnresolvedEnds> unresolved() const {
    std::map<std::pair<std::uint32_t, BodyIndex>, std::pair<UnresolvedEnds, Ideal>> regions;
    const auto add = [&](const LineSegment& s, std::uint32_t node, const Ideal& arriving) {
      const LineNode& end = network_.nodes[node];
      if (end.kind != NodeKind::lattice) return;
      const BodyIndex body = zone_.body[s.atoms.front()];
      const auto [at, fresh] = regions.try_emplace({end.region, body});
      auto& [told, sum] = at->second;
      if (fresh) {
        told = {body, 0, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
        sum.setZero();
      }
      ++told.segments;
      told.centre += zone_.origin + spacing_ * end.at;
      sum += arriving;
    };
    for (const LineSegment& s : network_.segments) {
      add(s, s.from, -s.burgers);
      add(s, s.to, s.burgers);
    }
    std::vector<UnresolvedEnds> all;
    for (auto& [key, region] : regions) {
      auto& [told, sum] = region;
      told.burgers = sum.cast<double>() / ideal_parts;
      told.centre /= static_cast<double>(told.segments);
      all.push_back(told);
    }
    return all;
  }

  /// Exact: whole numbers are added.
  double residual() const {
    std::vector<Ideal> sum(network_.nodes.size(), Ideal::Zero());
    for (const LineSegment& s : network_.segments) {
      sum[s.from] -= s.burgers;
      sum[s.to] += s.burgers;
    }
    double all = 0;
    for (std::size_t node = 0; node < sum.size(); ++node) {
      const NodeKind kind = network_.nodes[node].kind;
      if (kind == NodeKind::junction || kind == NodeKind::inside) all += sum[node].cast<double>().norm() / ideal_parts;
    }
    return all;
  }

  const LineNetwork& network_;
  const LineNetwork& less_smooth_;
  const Zone& zone_;
  const ZoneCrystal& crystal_;
  double spacing_;
};

}  // namespace

LineFamily family_of(const Ideal& burgers) {
  std::array<int, 3> size{std::abs(burgers[0]), std::abs(burgers[1]), std::abs(burgers[2])};
  std::ranges::sort(size, std::greater());
  constexpr int sixth = ideal_parts / 6;
  const auto is = [&](int a, int b, int c) { return size == std::array{a * sixth, b * sixth, c * sixth}; };
  if (is(3, 3, 0)) return LineFamily::perfect;
  if (is(2, 1, 1)) return LineFamily::shockley;
  if (is(1, 1, 0)) return LineFamily::stair_rod;
  if (is(2, 0, 0)) return LineFamily::hirth;
  if (is(2, 2, 2)) return LineFamily::frank;
  return LineFamily::other;
}

DislocationLines described(const LineNetwork& network, const LineNetwork& less_smooth, const Zone& zone,
                           const ZoneCrystal& crystal) {
  return Describer(network, less_smooth, zone, crystal).describe();
}

}  // namespace mdana::defects
