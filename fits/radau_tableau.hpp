// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

#include <Eigen/Core>

namespace mdana {

/// Radau IIA collocation with S stages (odd), order 2S - 1, stiffly accurate and L-stable (Hairer &
/// Wanner, Solving Ordinary Differential Equations II, IV.5 and IV.8).
template <int S>
struct RadauTableau {
  static constexpr int pairs = S / 2;
  using Vector = Eigen::Matrix<double, S, 1>;
  using Matrix = Eigen::Matrix<double, S, S>;

  Vector c;        ///< nodes in (0, 1]; c_S = 1
  Matrix a;        ///< integral of the j-th Lagrange polynomial from 0 to c_i
  Matrix inverse;  ///< of a
  /// Eigenvalues and eigenvectors of the inverse: one real, and one of each complex pair.
  double real_eigenvalue;
  Vector real_vector;
  Eigen::Matrix<double, 1, S> real_row;  ///< of the inverse of the matrix of eigenvectors
  Eigen::Matrix<std::complex<double>, pairs, 1> eigenvalues;
  Eigen::Matrix<std::complex<double>, S, pairs> vectors;
  Eigen::Matrix<std::complex<double>, pairs, S> rows;
  /// Embedded formula of order S: error = start h f(y_0) + sum increments_i Z_i, before it is
  /// filtered.
  double error_start;
  Vector error_increments;
  Eigen::Matrix<double, S + 1, 1> weights;  ///< barycentric, of the nodes 0, c_1 ... c_S

  static const RadauTableau& get();

 private:
  RadauTableau();
};

extern template struct RadauTableau<3>;
extern template struct RadauTableau<5>;

}  // namespace mdana
