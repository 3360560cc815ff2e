// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "analyses/defects/lines/network.hpp"
#include "readers/disjoint_sets.hpp"

namespace mdana::defects {
namespace {

constexpr std::uint32_t none = ~0u;

/// A facet with a Burgers vector.
struct Pierced {
  Corners corners;  ///< ascending
  std::uint32_t cell;
  Ideal burgers;  ///< of the line that leaves the cell there
};

/// A pierced facet as a step between two cells.
struct Passage {
  std::array<std::uint32_t, 2> node;  ///< cells, or what ends the line
  Ideal burgers;                      ///< from the first to the second
  Eigen::Vector3d at;
  Corners atoms;
};

class Tracer {
 public:
  Tracer(const Zone& zone, std::span<const Tetrahedron> cells, const Edges& edges, std::span<const OwnFrame> own,
         std::span<const Corners> walls)
      : zone_(zone), cells_(cells), edges_(edges), own_(own), walls_(walls), regions_(zone.size()) {
    for (const Corners& f : walls)
      for (const std::size_t k : {1, 2}) regions_.join(f[0], f[k]);
  }

  LineNetwork trace() {
    find_pierced();
    find_passages();
    follow();
    return std::move(network_);
  }

 private:
  void find_pierced() {
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
      const Tetrahedron& t = cells_[c];
      for (std::uint32_t side = 0; side < 4; ++side) {
        const Corners f = side_of(t, side);
        const Ideal b = -circulation(edges_, f);
        if (!b.isZero()) pierced_.push_back({ascending(f), c, b});
      }
    }
    std::ranges::sort(pierced_, {}, [](const Pierced& p) { return std::pair(p.corners, p.cell); });
  }

  /// A node for each cell with pierced facets.
  std::uint32_t node_of(std::uint32_t cell) {
    const auto [at, added] = node_of_cell_.try_emplace(cell, static_cast<std::uint32_t>(network_.nodes.size()));
    if (added) {
      Eigen::Vector3d centre = Eigen::Vector3d::Zero();
      for (const std::uint32_t i : cells_[cell]) centre += zone_.at[i] / 4;
      network_.nodes.push_back({NodeKind::junction, centre});
    }
    return at->second;
  }

  NodeKind end_at(const Corners& f) const {
    if (std::ranges::binary_search(walls_, f)) return NodeKind::lattice;
    NodeKind kind = NodeKind::inside;
    for (const std::uint32_t i : f) {
      if (own_[i].site == Site::contact) return NodeKind::contact;
      if (own_[i].site == Site::surface) kind = NodeKind::surface;
    }
    return kind;
  }

  void find_passages() {
    for (std::size_t i = 0; i < pierced_.size(); ++i) {
      const Pierced& p = pierced_[i];
      Eigen::Vector3d at = Eigen::Vector3d::Zero();
      for (const std::uint32_t a : p.corners) at += zone_.at[a] / 3;
      const std::uint32_t from = node_of(p.cell);
      std::uint32_t to = none;
      if (i + 1 < pierced_.size() && pierced_[i + 1].corners == p.corners) {
        to = node_of(pierced_[++i].cell);
      } else {
        to = static_cast<std::uint32_t>(network_.nodes.size());
        network_.nodes.push_back({end_at(p.corners), at, false, p.corners, regions_.root(p.corners[0])});
      }
      passages_.push_back({{from, to}, p.burgers, at, p.corners});
    }
    at_node_.resize(network_.nodes.size());
    for (std::uint32_t k = 0; k < passages_.size(); ++k)
      for (const std::uint32_t node : passages_[k].node) at_node_[node].push_back(k);
  }

  void follow() {
    done_.resize(passages_.size());
    for (std::uint32_t node = 0; node < at_node_.size(); ++node)
      if (at_node_[node].size() != 2)
        for (const std::uint32_t k : at_node_[node])
          if (!done_[k]) follow_from(node, k);
    for (std::uint32_t k = 0; k < passages_.size(); ++k)
      if (!done_[k]) follow_from(passages_[k].node[0], k);
  }

  void follow_from(std::uint32_t start, std::uint32_t k) {
    LineSegment segment;
    segment.from = start;
    segment.burgers = passages_[k].node[0] == start ? passages_[k].burgers : Ideal(-passages_[k].burgers);
    std::uint32_t node = start;
    for (;;) {
      const Passage& passage = passages_[k];
      done_[k] = true;
      segment.points.push_back(passage.at);
      segment.atoms.insert(segment.atoms.end(), passage.atoms.begin(), passage.atoms.end());
      node = passage.node[0] == node ? passage.node[1] : passage.node[0];
      if (node == start || at_node_[node].size() != 2) break;
      k = at_node_[node][0] == k ? at_node_[node][1] : at_node_[node][0];
    }
    segment.to = node;
    network_.segments.push_back(std::move(segment));
  }

  const Zone& zone_;
  std::span<const Tetrahedron> cells_;
  const Edges& edges_;
  std::span<const OwnFrame> own_;
  std::span<const Corners> walls_;
  DisjointSets regions_;  ///< atoms of the facets of what was taken out
  std::vector<Pierced> pierced_;
  std::map<std::uint32_t, std::uint32_t> node_of_cell_;
  std::vector<Passage> passages_;
  std::vector<std::vector<std::uint32_t>> at_node_;
  std::vector<char> done_;
  LineNetwork network_;
};

}  // namespace

double length(const LineNetwork& network, const LineSegment& segment) {
  double sum = 0;
  Eigen::Vector3d last = network.nodes[segment.from].at;
  for (const Eigen::Vector3d& p : segment.points) {
    sum += (p - last).norm();
    last = p;
  }
  return sum + (network.nodes[segment.to].at - last).norm();
}

LineNetwork trace_lines(const Zone& zone, std::span<const Tetrahedron> cells, const Edges& edges,
                        std::span<const OwnFrame> own, std::span<const Corners> walls) {
  return Tracer(zone, cells, edges, own, walls).trace();
}

}  // namespace mdana::defects
