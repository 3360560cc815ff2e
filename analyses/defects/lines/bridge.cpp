// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analyses/defects/lines/network.hpp"
#include "readers/disjoint_sets.hpp"

namespace mdana::defects {
namespace {

/// An end in good crystal.
struct LooseEnd {
  std::uint32_t node;
  Ideal arriving;
};

std::vector<LooseEnd> loose_ends(const LineNetwork& network) {
  std::vector<LooseEnd> ends;
  for (const LineSegment& s : network.segments) {
    if (network.nodes[s.from].kind == NodeKind::inside) ends.push_back({s.from, -s.burgers});
    if (network.nodes[s.to].kind == NodeKind::inside) ends.push_back({s.to, s.burgers});
  }
  return ends;
}

/// Joins the ends that are within a distance of each other, if what arrives adds up to nothing.
void bridge(LineNetwork& network, double distance) {
  const std::vector<LooseEnd> ends = loose_ends(network);
  DisjointSets sets(ends.size());
  for (std::uint32_t i = 0; i < ends.size(); ++i)
    for (std::uint32_t k = 0; k < i; ++k)
      if ((network.nodes[ends[i].node].at - network.nodes[ends[k].node].at).norm() < distance) sets.join(i, k);
  std::vector<Ideal> sum(ends.size(), Ideal::Zero());
  std::vector<Eigen::Vector3d> place(ends.size(), Eigen::Vector3d::Zero());
  std::vector<int> count(ends.size());
  for (std::uint32_t i = 0; i < ends.size(); ++i) {
    sum[sets.root(i)] += ends[i].arriving;
    place[sets.root(i)] += network.nodes[ends[i].node].at;
    ++count[sets.root(i)];
  }
  std::vector<std::uint32_t> node_of(network.nodes.size());
  for (std::uint32_t n = 0; n < node_of.size(); ++n) node_of[n] = n;
  for (std::uint32_t i = 0; i < ends.size(); ++i) {
    const std::uint32_t root = sets.root(i);
    if (count[root] < 2 || !sum[root].isZero()) continue;
    node_of[ends[i].node] = ends[root].node;
    network.nodes[ends[root].node] = {NodeKind::junction, place[root] / count[root]};
  }
  for (LineSegment& s : network.segments) {
    s.from = node_of[s.from];
    s.to = node_of[s.to];
  }
}

}  // namespace

void bridge_gaps(LineNetwork& network, double widest) {
  for (const double part : {0.4, 0.7, 1.0}) bridge(network, part * widest);
}

}  // namespace mdana::defects
