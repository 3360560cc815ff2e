// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <random>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "analyses/defects.hpp"

namespace mdana::test {

using Points = std::vector<Eigen::Vector3d>;

/// Atoms of a cubic lattice of edge `a` nearer to the centre than the radius; `basis` in edges.
inline Points lattice_ball(double a, double radius, const Points& basis) {
  Points points;
  const int n = static_cast<int>(radius / a) + 2;
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j)
      for (int k = -n; k <= n; ++k)
        for (const Eigen::Vector3d& b : basis) {
          const Eigen::Vector3d p = a * (Eigen::Vector3d(i, j, k) + b);
          if (p.norm() < radius) points.push_back(p);
        }
  return points;
}

inline const Points fcc_basis{{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
inline const Points bcc_basis{{0, 0, 0}, {0.5, 0.5, 0.5}};

/// fcc, nearest neighbours 1 apart.
inline Points fcc_ball(double radius) { return lattice_ball(std::sqrt(2.0), radius, fcc_basis); }

/// Close-packed layers A, B, C of nearest neighbours 1 apart within a ball; the middle of the layers is
/// that of the ball.
inline Points stacked_ball(std::string_view stacking, double radius) {
  const double height = std::sqrt(2.0 / 3), row = std::sqrt(3.0) / 2;
  const double middle = 0.5 * static_cast<double>(stacking.size() - 1);
  const int n = static_cast<int>(1.3 * radius) + 3;
  Points points;
  for (std::size_t layer = 0; layer < stacking.size(); ++layer)
    for (int i = -n; i <= n; ++i)
      for (int k = -n; k <= n; ++k) {
        const int shift = stacking[layer] - 'A';
        const Eigen::Vector3d p(i + 0.5 * k + 0.5 * shift, row * k + row / 3 * shift,
                                height * (static_cast<double>(layer) - middle));
        if (p.norm() < radius) points.push_back(p);
      }
  return points;
}

inline void add_noise(Points& points, double sigma, std::uint64_t seed = 1) {
  if (sigma == 0) return;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, sigma);
  for (auto& p : points) p += Eigen::Vector3d(normal(random), normal(random), normal(random));
}

inline void turn(Points& points, const Eigen::Quaterniond& by) {
  for (auto& p : points) p = by * p;
}

inline void scale(Points& points, double factor) {
  for (auto& p : points) p *= factor;
}

inline std::shared_ptr<FrameAtoms> atoms_of(const Points& points, BodyIndex body = 1) {
  const auto atoms = std::make_shared<FrameAtoms>();
  for (const auto& p : points) {
    atoms->x.push_back(p.x());
    atoms->y.push_back(p.y());
    atoms->z.push_back(p.z());
    atoms->body.push_back(body);
    atoms->id.push_back(static_cast<std::int64_t>(atoms->id.size() + 1));
  }
  return atoms;
}

/// A row and everything else that is known of a frame.
struct Looked {
  Table table;
  FrameDefects found;
  AtomLabels labels;

  double operator[](std::string_view column) const { return table.column(column)[0]; }
};

template <class T>
void append(const std::vector<T>& values, std::vector<T>& to) {
  to.insert(to.end(), values.begin(), values.end());
}

inline AtomLabels labels_of(const LabelledAtoms& atoms) {
  AtomLabels all;
  atoms.for_blocks([&](const FrameAtoms&, const AtomLabels& some) {
    append(some.structure, all.structure);
    append(some.site, all.site);
    append(some.margin, all.margin);
    append(some.cluster, all.cluster);
    append(some.centro_symmetry, all.centro_symmetry);
    append(some.coordination, all.coordination);
  });
  return all;
}

inline Looked look(const FrameStore& frame, DefectSettings settings = {}, std::size_t threads = 1,
                   const FrameHeader& header = {}) {
  Looked looked;
  settings.labels = true;
  settings.product = [&](const FrameHeader&, const FrameDefects& found) {
    looked.found = found;
    looked.labels = labels_of(*found.atoms);
  };
  const auto analysis = make_defects(settings);
  std::vector<double> row(analysis->columns().size());
  dynamic_cast<const FrameAnalysis&>(*analysis).look(header, frame, threads, row)->give();
  looked.table = Table(analysis->columns());
  looked.table.add_row(row);
  return looked;
}

inline Looked look(std::shared_ptr<const FrameAtoms> atoms, DefectSettings settings = {},
                   std::size_t threads = 1, const FrameHeader& header = {}) {
  return look(FrameStore(std::move(atoms)), std::move(settings), threads, header);
}

inline Looked look(const Points& points, DefectSettings settings = {}) {
  return look(atoms_of(points), std::move(settings));
}

/// Input that has to be refused: atoms, what the message says, and the frame.
struct Impossible {
  Points points;
  std::string says;
  FrameHeader header = {};
};

inline std::vector<Impossible> impossible_input() {
  const Points ball = fcc_ball(4);
  std::vector<Impossible> all{{{{1, 2, 3}}, "fewer than two atoms"},
                              {{{1, 2, 3}, {1, 2, 3}}, "fewer than two atoms"},
                              {Points(9000, Eigen::Vector3d(1, 1, 1)), "fewer than two atoms"},
                              {ball, "atom id 6 is not finite"},
                              {ball, "ids 8 and 10"},
                              {ball, "--select"},
                              {ball, "on top of each other"},
                              {ball, "fills the periodic box along y"}};
  all[3].points[5].y() = std::nan("");
  all[4].points[9] = all[4].points[7];
  all[5].points.push_back({1e9, 0, 0});
  all[6].points.insert(all[6].points.end(), 9000, Eigen::Vector3d(0.3, 0.3, 0.3));
  all[7].header.box.edges = Eigen::Matrix3d::Identity() * 7.9;
  all[7].header.box.periodic = {false, true, false};
  return all;
}

}  // namespace mdana::test
