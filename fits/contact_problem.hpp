// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fits/contact_fit.hpp"
#include "fits/contact_model.hpp"
#include "fits/fit_coordinates.hpp"

namespace mdana {

/// How well a contact fit is solved.
struct ContactPrecision {
  double collision = 1e-9;  ///< wanted error of e in each collision
  double solver = 1e-16;    ///< relative change of the cost that ends the search; of the parameters its root, 1e-3 at most
  int iterations = 200;
  double least_error = 0;   ///< see ContactModel
};

constexpr ContactPrecision exact{1e-9, 1e-16, 60, 0};
/// To find the valley.
constexpr ContactPrecision soft{1e-7, 1e-4, 15, 0.1};
/// For what a search is only a part: a profile, a draw. Looser collisions are hardly cheaper, and in
/// stiff ones dearer.
constexpr ContactPrecision rough{1e-8, 1e-4, 20, 0};

/// Where a search ended.
struct ContactOptimum {
  Fit fit;
  Eigen::VectorXd ln;  ///< of all parameters
  double cost = 0;     ///< sum of squared residuals, damped by the loss
  int starts = 1;      ///< that led there
};

/// The part of a problem that is solved: all of it, or less.
struct ContactPart {
  std::optional<std::size_t> fixed = {};  ///< the parameter that keeps its value
  std::vector<std::size_t> points = {};   ///< residuals of the data, with repetitions; none: all
};

/// The least-squares problem of a contact fit.
class ContactProblem {
 public:
  /// Throws InputError as ContactModel does.
  ContactProblem(const CollisionLaw& law, std::span<const ObservedCollision> seen,
                 const ContactFitSettings& settings);

  const ContactModel& model() const { return model_; }
  const FitCoordinates& coordinates() const { return coordinates_; }
  bool has_priors() const { return !priors_.empty(); }
  std::size_t parameters() const { return model_.targets().size(); }

  /// What the model is computed with from now on.
  void set(const ContactPrecision& precision);

  /// From coordinates q.
  ContactOptimum solve(std::vector<double> q, const ContactPrecision& precision,
                       const ContactPart& part = {});

  /// From logarithms of the parameters; the fixed one keeps its own.
  ContactOptimum solve_fixed(const Eigen::VectorXd& ln, std::size_t fixed,
                             const ContactPrecision& precision);

  /// Sum of squared residuals at the parameters, damped by the loss; infinite if one is unresolved.
  double cost(const Eigen::VectorXd& ln, const ContactPrecision& precision,
              std::span<const std::size_t> points = {});

 private:
  ContactModel model_;
  FitCoordinates coordinates_;
  std::vector<std::pair<std::size_t, Measured>> priors_;  ///< of which parameter
  Loss loss_;
};

}  // namespace mdana
