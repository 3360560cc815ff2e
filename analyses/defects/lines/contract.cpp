// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <queue>
#include <tuple>

#include "analyses/defects/lines/network.hpp"

namespace mdana::defects {
namespace {

bool is_end(const LineNode& node) { return node.kind != NodeKind::junction; }

bool ends_at_lattice(const LineNetwork& network, const LineSegment& s) {
  return network.nodes[s.from].kind == NodeKind::lattice || network.nodes[s.to].kind == NodeKind::lattice;
}

/// The segment the other way round.
void turn_round(LineSegment& segment) {
  std::swap(segment.from, segment.to);
  segment.burgers = -segment.burgers;
  std::ranges::reverse(segment.points);
}

using Points = std::vector<Eigen::Vector3d>;

/// Points of two lines with common ends, as many as the longer one has, in pairs by their part of the length.
Points midway(const Points& a, const Points& b) {
  const std::size_t count = std::max(a.size(), b.size());
  const auto at = [count](const Points& points, std::size_t k) {
    const double place = count > 1 ? static_cast<double>(k * (points.size() - 1)) / static_cast<double>(count - 1) : 0;
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, points.size() - 1);
    const double part = place - static_cast<double>(low);
    return Eigen::Vector3d((1 - part) * points[low] + part * points[high]);
  };
  Points middle;
  for (std::size_t k = 0; k < count; ++k) middle.push_back((at(a, k) + at(b, k)) / 2);
  return middle;
}

class Contraction {
 public:
  Contraction(LineNetwork& network, const Closeness& close) : network_(network), close_(close), closest_(close.nodes), at_(network.nodes.size()) {
    for (std::uint32_t k = 0; k < network.segments.size(); ++k) attach(k);
  }

  /// What is done to some segments does not depend on those elsewhere: all that follows from a contraction is done before
  /// the next.
  void run() {
    do {
      while (simplify()) {
      }
    } while (contract_shortest());
    remove_gone();
  }

 private:
  LineSegment& segment(std::uint32_t k) { return network_.segments[k]; }
  double length_of(std::uint32_t k) { return length(network_, segment(k)); }

  void attach(std::uint32_t k) {
    at_[segment(k).from].push_back(k);
    if (segment(k).to != segment(k).from) at_[segment(k).to].push_back(k);
  }
  void detach(std::uint32_t k) {
    std::erase(at_[segment(k).from], k);
    std::erase(at_[segment(k).to], k);
  }
  void remove(std::uint32_t k) {
    detach(k);
    segment(k).burgers.setZero();
  }
  bool gone(std::uint32_t k) { return segment(k).burgers.isZero(); }

  bool simplify() {
    bool any = remove_small_loops();
    any |= merge_parallel();
    any |= join_at_passed_nodes();
    return any;
  }

  /// Closed segments at a junction carry nothing away.
  bool remove_small_loops() {
    bool any = false;
    for (std::uint32_t k = 0; k < network_.segments.size(); ++k) {
      if (gone(k) || segment(k).from != segment(k).to) continue;
      if (length_of(k) >= least_loop * closest_) continue;
      remove(k);
      any = true;
    }
    return any;
  }

  /// Below this length a segment is none.
  double too_short(const LineSegment& s) const {
    const LineNode &a = network_.nodes[s.from], &b = network_.nodes[s.to];
    if (is_end(a) && is_end(b)) return (a.kind == NodeKind::lattice ? 2 : 1) * close_.boundary;
    return ends_at_lattice(network_, s) ? close_.boundary : close_.nodes;
  }

  /// The shortest of the segments that are too short; its nodes become one.
  bool contract_shortest() {
    std::uint32_t shortest = 0;
    double least = HUGE_VAL;
    for (std::uint32_t k = 0; k < network_.segments.size(); ++k) {
      if (gone(k) || segment(k).from == segment(k).to) continue;
      const double l = length_of(k);
      if (!(l < least) || !(l < too_short(segment(k)))) continue;
      least = l;
      shortest = k;
    }
    if (!(least < HUGE_VAL)) return false;
    const auto [a, b] = std::pair{segment(shortest).from, segment(shortest).to};
    if (ends_at_lattice(network_, segment(shortest)) || (is_end(network_.nodes[a]) && is_end(network_.nodes[b]))) {
      network_.absorbed += least;
      network_.absorbed_straight += (network_.nodes[a].at - network_.nodes[b].at).norm();
    }
    remove(shortest);
    if (is_end(network_.nodes[a]) && is_end(network_.nodes[b])) return true;
    unite(a, b);
    return true;
  }

  void unite(std::uint32_t a, std::uint32_t b) {
    if (is_end(network_.nodes[b])) std::swap(a, b);
    LineNode& kept = network_.nodes[a];
    if (!is_end(kept)) kept.at = (kept.at + network_.nodes[b].at) / 2;
    for (const std::uint32_t k : std::vector<std::uint32_t>(at_[b])) {
      detach(k);
      if (segment(k).from == b) segment(k).from = a;
      if (segment(k).to == b) segment(k).to = a;
      attach(k);
    }
  }

  /// Two segments from the same node to the same node that stay close.
  bool merge_parallel() {
    for (std::uint32_t node = 0; node < at_.size(); ++node)
      for (std::size_t i = 0; i < at_[node].size(); ++i)
        for (std::size_t j = i + 1; j < at_[node].size(); ++j) {
          const std::uint32_t a = at_[node][i], b = at_[node][j];
          if (segment(a).from == segment(a).to || segment(b).from == segment(b).to) continue;
          if (std::minmax(segment(a).from, segment(a).to) != std::minmax(segment(b).from, segment(b).to)) continue;
          if (!close(segment(a), segment(b))) continue;
          merge(a, b);
          return true;
        }
    return false;
  }

  /// The second into the first, which then runs midway.
  void merge(std::uint32_t a, std::uint32_t b) {
    if (segment(a).from != segment(b).from) turn_round(segment(b));
    LineSegment &kept = segment(a), &other = segment(b);
    const Ideal sum = kept.burgers + other.burgers;
    kept.points = midway(kept.points, other.points);
    kept.atoms.insert(kept.atoms.end(), other.atoms.begin(), other.atoms.end());
    remove(b);
    if (sum.isZero()) remove(a);
    kept.burgers = sum;
  }

  /// The mean distance of the points of one to the nearest of the other, either way.
  bool close(const LineSegment& a, const LineSegment& b) const {
    const auto mean = [](const LineSegment& from, const LineSegment& to) {
      double sum = 0;
      for (const auto& p : from.points) {
        double least = HUGE_VAL;
        for (const auto& q : to.points) least = std::min(least, (p - q).squaredNorm());
        sum += std::sqrt(least);
      }
      return sum / static_cast<double>(from.points.size());
    };
    return mean(a, b) < close_.parallel && mean(b, a) < close_.parallel;
  }

  /// Two segments at a junction are one.
  bool join_at_passed_nodes() {
    bool any = false;
    for (std::uint32_t node = 0; node < at_.size(); ++node) {
      if (at_[node].size() != 2 || is_end(network_.nodes[node])) continue;
      const std::uint32_t a = at_[node][0], b = at_[node][1];
      if (segment(a).from == segment(a).to || segment(b).from == segment(b).to) continue;
      detach(a);
      detach(b);
      if (segment(a).to != node) turn_round(segment(a));
      if (segment(b).from != node) turn_round(segment(b));
      LineSegment& whole = segment(a);
      whole.points.push_back(network_.nodes[node].at);
      whole.points.insert(whole.points.end(), segment(b).points.begin(), segment(b).points.end());
      whole.atoms.insert(whole.atoms.end(), segment(b).atoms.begin(), segment(b).atoms.end());
      whole.to = segment(b).to;
      segment(b).burgers.setZero();
      attach(a);
      any = true;
    }
    return any;
  }

  void remove_gone() {
    std::erase_if(network_.segments, [](const LineSegment& s) { return s.burgers.isZero(); });
    std::vector<std::uint32_t> number(network_.nodes.size(), ~0u);
    std::vector<LineNode> nodes;
    for (LineSegment& s : network_.segments)
      for (std::uint32_t* node : {&s.from, &s.to}) {
        if (number[*node] == ~0u) {
          number[*node] = static_cast<std::uint32_t>(nodes.size());
          nodes.push_back(network_.nodes[*node]);
        }
        *node = number[*node];
      }
    network_.nodes = std::move(nodes);
    std::vector<std::size_t> ends(network_.nodes.size());
    for (const LineSegment& s : network_.segments)
      for (const std::uint32_t node : {s.from, s.to}) ++ends[node];
    for (const LineSegment& s : network_.segments)
      network_.nodes[s.from].passed = s.from == s.to && ends[s.from] == 2;
  }

  static constexpr double least_loop = 3;  ///< closest distances: about a circle of that diameter

  LineNetwork& network_;
  Closeness close_;
  double closest_;
  std::vector<std::vector<std::uint32_t>> at_;  ///< segments of each node
};

}  // namespace

void contract(LineNetwork& network, const Closeness& close) { Contraction(network, close).run(); }

}  // namespace mdana::defects
