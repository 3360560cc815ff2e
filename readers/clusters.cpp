// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/clusters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <Eigen/LU>
#include <fmt/format.h>

#include "readers/cell_list.hpp"
#include "readers/disjoint_sets.hpp"
#include "readers/input_error.hpp"

namespace mdana {
namespace {

double extent(const Eigen::Matrix3Xd& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
}

/// Median over a thousand sampled points of the distance to the nearest other point, searched in
/// cells that grow until most samples have a neighbour.
double nearest_neighbour_distance(const Eigen::Matrix3Xd& points) {
  const Eigen::Index n = points.cols();
  const Eigen::Index stride = std::max<Eigen::Index>(1, n / 1000);
  double edge = extent(points) / std::cbrt(static_cast<double>(n));
  for (int doubling = 0; doubling < 60; ++doubling, edge *= 2) {
    const CellList cells(points, edge);
    std::vector<double> nearest;
    for (Eigen::Index i = 0; i < n; i += stride) {
      double best = std::numeric_limits<double>::infinity();
      cells.for_neighbours(i, [&](Eigen::Index, double d2) {
        if (d2 > 0) best = std::min(best, d2);
      });
      nearest.push_back(std::sqrt(best));
    }
    const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
    std::nth_element(nearest.begin(), middle, nearest.end());
    if (*middle <= edge) return *middle;  // within reach of the 27 cells, so truly the nearest
  }
  throw InputError("no distance between neighbouring atoms can be found");
}

/// Points, and behind them the images, beyond the upper periodic faces, of those near the lower ones.
struct WithImages {
  std::vector<double> coordinates;
  std::vector<std::size_t> point;  ///< that each stands for

  WithImages(const Eigen::Matrix3Xd& points, const Box& box, double reach)
      : coordinates(points.data(), points.data() + points.size()),
        point(static_cast<std::size_t>(points.cols())) {
    std::iota(point.begin(), point.end(), std::size_t{0});
    for (int k = 0; k < 3; ++k)
      if (box.periodic[static_cast<std::size_t>(k)]) add_images(box, k, reach);
  }

  Eigen::Map<const Eigen::Matrix3Xd> positions() const {
    return {coordinates.data(), 3, static_cast<Eigen::Index>(point.size())};
  }

 private:
  void add_images(const Box& box, int k, double reach) {
    const Eigen::Vector3d across = box.edges.inverse().row(k);  // scaled coordinate a length
    const std::size_t count = point.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector3d p(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]);
      if (across.dot(p - box.origin) > reach * across.norm()) continue;
      const Eigen::Vector3d image = p + box.edges.col(k);
      coordinates.insert(coordinates.end(), image.begin(), image.end());
      point.push_back(point[i]);
    }
  }
};

}  // namespace

Clusters find_clusters(const Eigen::Matrix3Xd& points, const Box& box) {
  if (!points.allFinite()) throw InputError("clusters: a position is not finite");
  if (points.cols() < 2 || extent(points) == 0)
    throw InputError("clusters: fewer than two atoms at different places");
  Clusters clusters;
  clusters.link_distance = 1.5 * nearest_neighbour_distance(points);
  const double limit = clusters.link_distance * clusters.link_distance;
  const WithImages all(points, box, clusters.link_distance);
  const Eigen::Matrix3Xd positions = all.positions();
  const CellList cells(positions, clusters.link_distance);
  const auto n = static_cast<std::size_t>(points.cols());
  DisjointSets sets(n);
  for (std::size_t i = 0; i < all.point.size(); ++i)
    cells.for_neighbours(static_cast<Eigen::Index>(i), [&](Eigen::Index j, double d2) {
      if (d2 <= limit)
        sets.join(static_cast<std::uint32_t>(all.point[i]),
                  static_cast<std::uint32_t>(all.point[static_cast<std::size_t>(j)]));
    });

  std::map<std::uint32_t, std::uint32_t> number_of_root;
  for (std::size_t i = 0; i < n; ++i) {
    const auto next = static_cast<std::uint32_t>(clusters.sizes.size());
    const auto [it, fresh] = number_of_root.emplace(sets.root(static_cast<std::uint32_t>(i)), next);
    if (fresh) clusters.sizes.push_back(0);
    ++clusters.sizes[it->second];
    clusters.of_point.push_back(it->second);
  }
  return clusters;
}

std::vector<Bodies::Run> cluster_runs(const Clusters& clusters, std::span<const std::int64_t> ids,
                                      std::size_t smallest) {
  std::vector<std::pair<std::int64_t, std::uint32_t>> by_id;
  for (std::size_t i = 0; i < ids.size(); ++i) by_id.emplace_back(ids[i], clusters.of_point[i]);
  std::sort(by_id.begin(), by_id.end());

  std::map<std::uint32_t, BodyIndex> body_of_cluster;
  std::vector<Bodies::Run> runs;
  for (std::size_t i = 0; i < by_id.size(); ++i) {
    const auto [id, cluster] = by_id[i];
    if (i > 0 && by_id[i - 1].first == id)
      throw InputError(fmt::format("clusters: two atoms have the id {}", id));
    if (clusters.sizes[cluster] < smallest) continue;
    const auto next = static_cast<BodyIndex>(body_of_cluster.size() + 1);
    const BodyIndex body = body_of_cluster.emplace(cluster, next).first->second;
    if (!runs.empty() && runs.back().body == body && runs.back().last + 1 == id)
      runs.back().last = id;
    else
      runs.push_back({id, id, body});
  }
  return runs;
}

}  // namespace mdana
