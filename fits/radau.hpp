// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/LU>

#include "fits/dual.hpp"
#include "fits/radau_tableau.hpp"

namespace mdana {

/// Single steps of Radau IIA on a small stiff autonomous system
///
///     dy/ds = rates(y; p),   y = (states, quadratures),
///
/// where the rates do not depend on the quadratures. System has
///
///     static constexpr int states, quadratures, parameters;
///     std::array<double, parameters> p;
///     template <class T, class P> void rates(const T* y, const P* p, T* dy) const;
///
/// and T and P can be Dual. All states are of order one (at most of their scale).
template <class System, int S = 5>
class Radau {
 public:
  static constexpr int n = System::states, q = System::quadratures, np = System::parameters;
  static constexpr int stages = S;
  using States = Eigen::Matrix<double, n, 1>;
  using Full = Eigen::Matrix<double, n + q, 1>;
  using Derivatives = Eigen::Matrix<double, n + q, np>;  ///< of y by p

  Radau(const Full& y, const States& scale, double newton_tolerance)
      : tableau_(RadauTableau<S>::get()),
        y_(y),
        scale_(scale),
        newton_tolerance_(newton_tolerance) {}

  /// Tries a step of length h from y; false if the stages cannot be solved for.
  bool attempt(const System& system, double h);
  /// Error of the last attempt by the embedded formula of order S, in units of the scale.
  double error() const { return error_; }
  /// Replaces y by the end of the last attempt, with derivatives by the parameters if they are
  /// kept.
  void accept(const System& system);
  /// Another system goes on from y, changed by the caller.
  void restart(const Full& y) { y_ = y, fresh_ = true, jacobian_known_ = false; }

  const Full& y() const { return y_; }
  const Full& end() const { return end_; }
  /// The states of the last attempt at theta of it, 0 to 1, by the polynomial of collocation.
  States at(double theta) const { return y_.template head<n>() + polynomial(theta); }
  /// States and quadratures at the stages of the last attempt.
  Full stage(int i) const;
  /// The same at theta of it, 0 to 1, by the polynomial through start and stages.
  Full between(double theta) const;
  long evaluations() const { return evaluations_; }

  void keep_derivatives(const Derivatives& start) { derivatives_ = start, keeps_ = true; }
  const Derivatives& derivatives() const { return derivatives_; }
  /// After a step that ends where an event of that gradient is zero: the end moves with p.
  void end_at_event(const System& system, const States& by_y,
                    const Eigen::Matrix<double, np, 1>& by_p);
  bool keeps_derivatives() const { return keeps_; }

  Full rates(const System& system, const States& y) {
    Full dy;
    system.rates(y.data(), system.p.data(), dy.data());
    ++evaluations_;
    return dy;
  }

 private:
  using Square = Eigen::Matrix<double, n, n>;
  using ComplexSquare = Eigen::Matrix<std::complex<double>, n, n>;
  using ComplexStates = Eigen::Matrix<std::complex<double>, n, 1>;
  using Stages = Eigen::Matrix<double, n, S>;

  /// By cofactors, which for so few states is fastest, unless their products overflow.
  template <class Matrix>
  static Matrix inverse(const Matrix& m) {
    const double size = m.cwiseAbs().maxCoeff();
    const Matrix quick = (m / size).inverse() / size;
    return quick.allFinite() ? quick : Matrix(m.partialPivLu().inverse());
  }
  double norm(const States& v) const { return v.cwiseQuotient(scale_).cwiseAbs().maxCoeff(); }
  States polynomial(double theta) const;
  void linearize(const System& system);
  void factor(double h);
  void guess(double h);
  bool solve_stages(const System& system, double h);
  Stages newton_change(const Stages& residual) const;
  void estimate(const System& system, double h);
  void advance_derivatives(const System& system);

  const RadauTableau<S>& tableau_;
  Full y_, end_ = Full::Zero(), start_rates_ = Full::Zero();
  States scale_;
  double newton_tolerance_, h_ = 0, last_h_ = 0, error_ = 0;
  Stages z_ = Stages::Zero(), last_z_ = Stages::Zero();
  Eigen::Matrix<double, n + q, S> f_ = Eigen::Matrix<double, n + q, S>::Zero();
  Square jacobian_ = Square::Zero();
  Square real_inverse_ = Square::Zero();
  std::array<ComplexSquare, S / 2> complex_inverses_;
  bool fresh_ = true, jacobian_known_ = false, keeps_ = false;
  long evaluations_ = 0;
  Derivatives derivatives_ = Derivatives::Zero();
};

template <class System, int S>
void Radau<System, S>::linearize(const System& system) {
  std::array<Dual<n>, n> y;
  std::array<Dual<n>, n + q> dy;
  for (int k = 0; k < n; ++k) y[k] = Dual<n>::variable(y_[k], k);
  system.rates(y.data(), system.p.data(), dy.data());
  ++evaluations_;
  for (int k = 0; k < n + q; ++k) start_rates_[k] = dy[k].value;
  for (int k = 0; k < n; ++k) jacobian_.row(k) = dy[k].gradient.transpose();
  jacobian_known_ = true;
}

template <class System, int S>
void Radau<System, S>::factor(double h) {
  const Square real = Square::Identity() * (tableau_.real_eigenvalue / h) - jacobian_;
  real_inverse_ = inverse(real);
  for (int k = 0; k < S / 2; ++k) {
    ComplexSquare matrix = -jacobian_.template cast<std::complex<double>>();
    matrix.diagonal().array() += tableau_.eigenvalues[k] / h;
    complex_inverses_[k] = inverse(matrix);
  }
}

/// Lagrange's formula through (0, 0) and (c_i, Z_i).
template <class System, int S>
typename Radau<System, S>::States Radau<System, S>::polynomial(double theta) const {
  States sum = States::Zero();
  for (int i = 0; i < S; ++i) {
    double factor = tableau_.weights[i + 1] * theta;
    for (int j = 0; j < S; ++j)
      if (j != i) factor *= theta - tableau_.c[j];
    sum += factor * z_.col(i);
  }
  return sum;
}

/// The polynomial of the step before, continued; a step of another segment says nothing.
template <class System, int S>
void Radau<System, S>::guess(double h) {
  if (fresh_) {
    z_.setZero();
    return;
  }
  z_ = last_z_;
  Stages next;
  for (int i = 0; i < S; ++i)
    next.col(i) = polynomial(1 + h / last_h_ * tableau_.c[i]) - last_z_.col(S - 1);
  z_ = next;
}

template <class System, int S>
typename Radau<System, S>::Stages Radau<System, S>::newton_change(const Stages& residual) const {
  Stages change = (real_inverse_ * (residual * tableau_.real_row.transpose())).eval() *
                  tableau_.real_vector.transpose();
  for (int k = 0; k < S / 2; ++k) {
    const ComplexStates w =
        complex_inverses_[k] * (residual * tableau_.rows.row(k).transpose()).eval();
    for (int i = 0; i < S; ++i) change.col(i) += 2 * (w * tableau_.vectors(i, k)).real();
  }
  return change;
}

/// Simplified Newton on Z = h A F(y + Z).
template <class System, int S>
bool Radau<System, S>::solve_stages(const System& system, double h) {
  constexpr int most = 10;
  double before = 0;
  for (int iteration = 0; iteration < most; ++iteration) {
    for (int i = 0; i < S; ++i) f_.col(i) = rates(system, y_.template head<n>() + z_.col(i));
    const Stages change =
        newton_change(f_.template topRows<n>() - z_ * (tableau_.inverse.transpose() / h));
    if (!change.allFinite()) return false;
    z_ += change;
    double size = 0;
    for (int i = 0; i < S; ++i) size = std::max(size, norm(change.col(i)));
    if (size <= 1e-15) return true;
    if (iteration > 0) {
      const double rate = size / before;
      if (rate / (1 - std::min(rate, 0.999)) * size <= newton_tolerance_) return true;
      if (rate > 0.99 && size <= 100 * newton_tolerance_) return true;  // rounding
      const double left = std::pow(rate, most - 1 - iteration) / (1 - std::min(rate, 0.999)) * size;
      if (rate > 0.9 || left > 10 * newton_tolerance_) return false;
    }
    before = size;
  }
  return false;
}

template <class System, int S>
void Radau<System, S>::estimate(const System& system, double h) {
  const States increments = z_ * tableau_.error_increments;
  const double filter = tableau_.real_eigenvalue / h;
  const auto filtered = [&](const States& f) {
    return (filter * (real_inverse_ * (tableau_.error_start * h * f + increments))).eval();
  };
  const States first = filtered(start_rates_.template head<n>());
  error_ = norm(first);
  if (fresh_ && std::isfinite(error_) && error_ < 1) {
    const States second = filtered(rates(system, y_.template head<n>() + first).template head<n>());
    if (second.allFinite()) error_ = std::min(error_, norm(second));
  }
}

template <class System, int S>
bool Radau<System, S>::attempt(const System& system, double h) {
  if (!jacobian_known_) linearize(system);
  if (!jacobian_.allFinite()) return false;
  factor(h);
  guess(h);
  h_ = h;
  if (!solve_stages(system, h)) return false;
  end_ = y_;
  end_.template head<n>() += z_.col(S - 1);
  end_.template tail<q>() += h * (f_.template bottomRows<q>() * tableau_.a.row(S - 1).transpose());
  estimate(system, h);
  return end_.allFinite() && std::isfinite(error_);
}

template <class System, int S>
void Radau<System, S>::accept(const System& system) {
  if (keeps_) advance_derivatives(system);
  y_ = end_;
  last_z_ = z_;
  last_h_ = h_;
  fresh_ = false;
  jacobian_known_ = false;
}

template <class System, int S>
typename Radau<System, S>::Full Radau<System, S>::stage(int i) const {
  Full y = y_;
  y.template head<n>() += z_.col(i);
  y.template tail<q>() += h_ * (f_.template bottomRows<q>() * tableau_.a.row(i).transpose());
  return y;
}

template <class System, int S>
typename Radau<System, S>::Full Radau<System, S>::between(double theta) const {
  Full sum = Full::Zero();
  for (int i = 0; i < S; ++i) {
    double factor = tableau_.weights[i + 1] * theta;
    for (int j = 0; j < S; ++j)
      if (j != i) factor *= theta - tableau_.c[j];
    sum += factor * (stage(i) - y_);
  }
  return y_ + sum;
}

/// The derivative of the discrete step itself: S_i = S_0 + h sum_j a_ij (J_j S_j + dF_j/dp).
template <class System, int S>
void Radau<System, S>::advance_derivatives(const System& system) {
  using T = Dual<n + np>;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n * S, n * S), right(n * S, np);
  std::array<std::array<T, n + q>, S> dy;
  std::array<T, np> p;
  for (int k = 0; k < np; ++k) p[k] = T::variable(system.p[k], n + k);
  for (int j = 0; j < S; ++j) {
    std::array<T, n> y;
    for (int k = 0; k < n; ++k) y[k] = T::variable(y_[k] + z_(k, j), k);
    system.rates(y.data(), p.data(), dy[j].data());
  }
  for (int i = 0; i < S; ++i) {
    right.middleRows(n * i, n) = derivatives_.template topRows<n>();
    for (int j = 0; j < S; ++j)
      for (int k = 0; k < n; ++k) {
        const double factor = h_ * tableau_.a(i, j);
        matrix.block(n * i + k, n * j, 1, n) -=
            factor * dy[j][k].gradient.template head<n>().transpose();
        right.row(n * i + k) += factor * dy[j][k].gradient.template tail<np>().transpose();
      }
  }
  const Eigen::MatrixXd s = matrix.partialPivLu().solve(right);
  for (int j = 0; j < S; ++j)
    for (int k = 0; k < q; ++k) {
      const auto& g = dy[j][n + k].gradient;
      derivatives_.row(n + k) += h_ * tableau_.a(S - 1, j) *
                                 (g.template head<n>().transpose() * s.middleRows(n * j, n) +
                                  g.template tail<np>().transpose());
    }
  derivatives_.template topRows<n>() = s.bottomRows(n);
}

template <class System, int S>
void Radau<System, S>::end_at_event(const System& system, const States& by_y,
                                    const Eigen::Matrix<double, np, 1>& by_p) {
  if (!keeps_) return;
  const Full f = rates(system, y_.template head<n>());
  const Eigen::Matrix<double, 1, np> moved =
      by_y.transpose() * derivatives_.template topRows<n>() + by_p.transpose();
  derivatives_ -= f * (moved / by_y.dot(f.template head<n>()));
}

}  // namespace mdana
