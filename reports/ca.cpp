// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/ca.hpp"

#include <array>
#include <vector>

#include <fmt/format.h>

#include "reports/atomic_file.hpp"

namespace mdana {
namespace {

/// As the format tells a family: name, a vector of it, colour.
struct FamilyText {
  const char *name, *burgers, *colour;
};
constexpr std::array<FamilyText, line_families> families{{{"1/2<110> (Perfect)", "0.5 0.5 0", "0.2 0.2 1"},
                                                          {"1/6<112> (Shockley)", "0.166666667 0.166666667 0.333333333", "0 1 0"},
                                                          {"1/6<110> (Stair-rod)", "0.166666667 0.166666667 0", "1 0 1"},
                                                          {"1/3<100> (Hirth)", "0.333333333 0 0", "1 1 0"},
                                                          {"1/3<111> (Frank)", "0.333333333 0.333333333 0.333333333", "0 1 1"},
                                                          {"Other", "0 0 0", "0.9 0.2 0.2"}}};

/// Segments in one crystal orientation.
struct Cluster {
  BodyIndex body;
  Eigen::Matrix3d turn;
  Eigen::Matrix3d crystal;
  std::size_t segments;
};

/// The cluster of each segment, from 0.
std::vector<std::size_t> clusters_of(const DislocationLines& lines, std::vector<Cluster>& clusters) {
  std::vector<std::size_t> of;
  for (const DislocationSegment& s : lines.segments) {
    std::size_t k = 0;
    while (k < clusters.size() &&
           (clusters[k].body != s.body || (clusters[k].turn - s.turn).cwiseAbs().maxCoeff() > 1e-3))
      ++k;
    if (k == clusters.size()) clusters.push_back({s.body, s.turn, Eigen::Matrix3d::Zero(), 0});
    clusters[k].crystal += s.crystal;
    ++clusters[k].segments;
    of.push_back(k);
  }
  for (Cluster& c : clusters) c.crystal /= static_cast<double>(c.segments);
  return of;
}

std::string rows(const Eigen::Matrix3d& m) {
  std::string text;
  for (int k = 0; k < 3; ++k) text += fmt::format("{:.10g} {:.10g} {:.10g}\n", m(k, 0), m(k, 1), m(k, 2));
  return text;
}

std::string structure() {
  std::string text = fmt::format("STRUCTURE_TYPES 1\nSTRUCTURE_TYPE 1\nNAME fcc\nFULL_NAME FCC\nCOLOR 0.4 1 0.4\nTYPE LATTICE\n"
                                 "BURGERS_VECTOR_FAMILIES {}\n", families.size());
  const auto add = [&](std::size_t id, const FamilyText& f) {
    text += fmt::format("BURGERS_VECTOR_FAMILY ID {}\n{}\n{}\n{}\n", id, f.name, f.burgers, f.colour);
  };
  add(0, families.back());  // the format begins with those that are none
  for (std::size_t f = 0; f + 1 < families.size(); ++f) add(f + 1, families[f]);
  return text + "END_STRUCTURE_TYPE\n";
}

/// At each end of each segment, the last point first: an end of the next segment at the same node (1: its last
/// point), in a ring; at an end of its own, itself.
std::string junctions(const DislocationLines& lines) {
  std::vector<std::vector<std::pair<std::size_t, int>>> at(lines.nodes.size());
  for (std::size_t k = 0; k < lines.segments.size(); ++k)
    for (const int end : {0, 1}) at[lines.segments[k].nodes[static_cast<std::size_t>(end)]].emplace_back(k, end);
  std::string text = "DISLOCATION_JUNCTIONS\n";
  for (std::size_t k = 0; k < lines.segments.size(); ++k)
    for (const int end : {1, 0}) {
      const auto& ring = at[lines.segments[k].nodes[static_cast<std::size_t>(end)]];
      std::size_t here = 0;
      while (ring[here] != std::pair{k, end}) ++here;
      const auto& [segment, last] = ring[(here + 1) % ring.size()];
      text += fmt::format("{} {}\n", last, segment);
    }
  return text;
}

std::string content(const DislocationLines& lines, const Box& box) {
  std::vector<Cluster> clusters;
  const std::vector<std::size_t> cluster = clusters_of(lines, clusters);
  std::string text = "CA_FILE_VERSION 6\nCA_LIB_VERSION 0.0.0\n" + structure();
  text += fmt::format("SIMULATION_CELL_ORIGIN {:.10g} {:.10g} {:.10g}\nSIMULATION_CELL_MATRIX\n{}PBC_FLAGS {:d} {:d} {:d}\n",
                      box.origin.x(), box.origin.y(), box.origin.z(), rows(box.edges), box.periodic[0], box.periodic[1],
                      box.periodic[2]);
  text += fmt::format("CLUSTERS {}\n", clusters.size());
  for (std::size_t k = 0; k < clusters.size(); ++k)
    text += fmt::format("CLUSTER {}\nCLUSTER_STRUCTURE 1\nCLUSTER_ORIENTATION\n{}CLUSTER_COLOR 1 1 1\nCLUSTER_SIZE {}\nEND_CLUSTER\n",
                        k + 1, rows(clusters[k].crystal), clusters[k].segments);
  text += fmt::format("CLUSTER_TRANSITIONS 0\nDISLOCATIONS {}\n", lines.segments.size());
  for (std::size_t k = 0; k < lines.segments.size(); ++k) {
    const DislocationSegment& s = lines.segments[k];
    text += fmt::format("{}\n{:.10g} {:.10g} {:.10g}\n{}\n{}\n", k, s.burgers_here.x(), s.burgers_here.y(),
                        s.burgers_here.z(), cluster[k] + 1, s.points.size());
    for (const auto& p : s.points) text += fmt::format("{:.10g} {:.10g} {:.10g}\n", p.x(), p.y(), p.z());
  }
  return text + junctions(lines);
}

}  // namespace

void write_ca(const std::filesystem::path& path, const DislocationLines& lines, const Box& box) {
  write_file(path, content(lines, box));
}

}  // namespace mdana
