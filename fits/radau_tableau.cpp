// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/radau_tableau.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace mdana {
namespace {

using Real = long double;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

/// P_n - P_(n-1), Legendre polynomials on [-1, 1]: zero at the nodes of Radau and at 1.
Real node_function(int n, Real x) {
  Real before = 1, here = x;
  for (int k = 2; k <= n; ++k) {
    const Real next = ((2 * k - 1) * x * here - (k - 1) * before) / k;
    before = here;
    here = next;
  }
  return here - before;
}

Real bisect(int n, Real low, Real high) {
  const bool rising = node_function(n, low) < 0;
  for (int i = 0; i < 100; ++i) {
    const Real middle = (low + high) / 2;
    (((node_function(n, middle) < 0) == rising) ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// The nodes in (0, 1], ascending, by a scan finer than their least distance.
RealVector nodes(int stages) {
  RealVector c(stages);
  constexpr int cells = 1000;
  int found = 0;
  for (int k = 0; k < cells && found < stages - 1; ++k) {
    const Real low = -1 + Real(2 * k) / cells, high = -1 + Real(2 * (k + 1)) / cells;
    if ((node_function(stages, low) < 0) != (node_function(stages, high) < 0))
      c[found++] = (1 + bisect(stages, low, high)) / 2;
  }
  c[stages - 1] = 1;
  return c;
}

/// V with V(k, j) = c_j^k.
RealMatrix powers(const RealVector& c) {
  RealMatrix v(c.size(), c.size());
  for (Eigen::Index j = 0; j < c.size(); ++j)
    for (Eigen::Index k = 0; k < c.size(); ++k) v(k, j) = std::pow(c[j], static_cast<int>(k));
  return v;
}

/// A with sum_j A(i, j) c_j^k = c_i^(k+1)/(k+1).
RealMatrix integrals(const RealVector& c) {
  RealMatrix right(c.size(), c.size());
  for (Eigen::Index i = 0; i < c.size(); ++i)
    for (Eigen::Index k = 0; k < c.size(); ++k)
      right(k, i) = std::pow(c[i], static_cast<int>(k + 1)) / static_cast<Real>(k + 1);
  return powers(c).partialPivLu().solve(right).transpose();
}

/// Weights of Lagrange's formula for the nodes 0, c_1, ...
RealVector barycentric(const RealVector& c) {
  RealVector x(c.size() + 1), w(c.size() + 1);
  x << 0, c;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    w[i] = 1;
    for (Eigen::Index j = 0; j < x.size(); ++j)
      if (j != i) w[i] /= x[i] - x[j];
  }
  return w;
}

template <class Target, class Source>
void assign(Target& target, const Source& source) {
  target = source.template cast<typename Target::Scalar>();
}

}  // namespace

template <int S>
RadauTableau<S>::RadauTableau() {
  const RealVector exact_c = nodes(S);
  const RealMatrix exact_a = integrals(exact_c), exact_inverse = exact_a.partialPivLu().inverse();
  assign(c, exact_c);
  assign(a, exact_a);
  assign(inverse, exact_inverse);
  assign(weights, barycentric(exact_c));
  // Eigenvectors only speed up Newton's method: their rounding does no harm.
  const Eigen::MatrixXd matrix = inverse;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix);
  const Eigen::MatrixXcd t = solver.eigenvectors(), t_inverse = t.partialPivLu().inverse();
  for (int k = 0, pair = 0; k < S; ++k) {
    const std::complex<double> lambda = solver.eigenvalues()[k];
    if (lambda.imag() == 0) {
      real_eigenvalue = lambda.real();
      real_vector = t.col(k).real();
      real_row = t_inverse.row(k).real();
    } else if (lambda.imag() > 0) {
      eigenvalues[pair] = lambda;
      vectors.col(pair) = t.col(k);
      rows.row(pair++) = t_inverse.row(k);
    }
  }
  // Differences d of the weights: sum_j d_j c_j^k = -error_start for k = 0, else 0.
  error_start = 1 / real_eigenvalue;
  RealVector right = RealVector::Zero(S);
  right[0] = -static_cast<Real>(error_start);
  const RealVector d = powers(exact_c).partialPivLu().solve(right);
  const RealVector by_increments = exact_inverse.transpose() * d;
  assign(error_increments, by_increments);
}

template <int S>
const RadauTableau<S>& RadauTableau<S>::get() {
  static const RadauTableau tableau;
  return tableau;
}

template struct RadauTableau<3>;
template struct RadauTableau<5>;

}  // namespace mdana
