// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/block_means.hpp"

namespace mdana {

std::array<Eigen::Vector3d, 2> block_means(const VectorColumn& column, const LabelledBlock& block,
                                           const std::array<double, 2>& mass) {
  std::array<Eigen::Vector3d, 3> mean, sum;
  mean.fill(Eigen::Vector3d::Zero());
  for (int pass = 0; pass < 2; ++pass) {
    sum.fill(Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < block.body.size(); ++i) {
      const BodyIndex b = block.body[i];
      if (b <= 2) sum[b] += block.mass[i] * (column[i] - mean[b]);
    }
    for (std::size_t b = 1; b <= 2; ++b)
      if (mass[b - 1] > 0) mean[b] += sum[b] / mass[b - 1];
  }
  return {mean[1], mean[2]};
}

}  // namespace mdana
