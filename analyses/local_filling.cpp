// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/local_filling.hpp"

#include "readers/cell_list.hpp"

namespace mdana {

double mean_radius(std::span<const Grain> grains) {
  double mean = 0, count = 0;
  for (const Grain& grain : grains) mean += (grain.radius - mean) / ++count;
  return mean;
}

std::vector<double> local_filling(std::span<const Grain> grains) {
  std::vector<double> filling;
  if (grains.empty()) return filling;
  filling.reserve(grains.size());
  const double reach = filling_reach * mean_radius(grains);
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(grains.size()));
  for (std::size_t i = 0; i < grains.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = grains[i].position;
  const auto share = [&](Eigen::Index i) {
    const double r = grains[static_cast<std::size_t>(i)].radius / reach;
    return r * r * r;
  };
  for (Eigen::Index i = 0; i < points.cols(); ++i) filling.push_back(share(i));
  CellList(points, reach).for_pairs([&](Eigen::Index i, Eigen::Index j, double squared) {
    if (!(squared < reach * reach)) return;
    filling[static_cast<std::size_t>(i)] += share(j);
    filling[static_cast<std::size_t>(j)] += share(i);
  });
  return filling;
}

}  // namespace mdana
