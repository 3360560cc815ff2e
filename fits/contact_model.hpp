// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fits/contact_fit.hpp"
#include "fits/fit_coordinates.hpp"

namespace mdana {

/// What a law says of collisions that were seen, as residuals that depend on the logarithms of the
/// free parameters.
class ContactModel {
  using Quantity = SeenQuantity;

 public:
  /// A free parameter, or that of one group.
  struct Target {
    std::size_t free;              ///< index among the settings' free parameters
    std::string parameter;
    std::optional<double> radius;  ///< of the group
    std::string name() const;      ///< "C" or "C(R=58.9)"
  };

  /// Throws InputError if an observation lacks a parameter, or a free one is not the law's. Nothing
  /// free: only predicts.
  ContactModel(const CollisionLaw& law, std::span<const ObservedCollision> seen,
               const ContactFitSettings& settings);

  const std::vector<Target>& targets() const { return targets_; }
  std::vector<Unknown> unknowns() const;
  const CollisionScales& scales() const { return scales_; }

  std::size_t residuals() const { return terms_.size(); }
  std::size_t seen_of(std::size_t residual) const { return terms_[residual].seen; }
  Quantity quantity_of(std::size_t residual) const { return terms_[residual].quantity; }
  std::size_t sample_of(std::size_t residual) const { return terms_[residual].sample; }
  bool known_errors() const { return known_errors_; }
  bool only_sticking() const;  ///< no number was seen, only that spheres stick

  void set_tolerance(double tolerance);  ///< wanted error of e in each collision
  /// Errors count as at least that part of what is seen, of e^2 of 1. The valleys of a cost whose errors
  /// are small, of sticking collisions above all, are narrow: a search begins with soft ones.
  void set_least_error(double least) { least_error_ = least; }

  /// What the law says of a residual's quantity; NaN if the collision is unresolved.
  double predicted(std::size_t k, const Eigen::VectorXd& ln) const;

  /// One residual, and its derivatives by the logarithms, if they are wanted. False if the collision
  /// is unresolved. Derivatives are computed with the value if that is cheap: they are mostly asked for
  /// next.
  bool residual(std::size_t k, const Eigen::VectorXd& ln, double& r, Eigen::VectorXd* by_ln) const;

  /// The residual alone; NaN if the collision is unresolved.
  double residual(std::size_t k, const Eigen::VectorXd& ln) const;

  /// d residual/d ln parameter of all; rows of unresolved collisions are 0.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& ln) const;

  long collisions() const { return collisions_; }        ///< solved so far
  const std::string& failure() const { return failure_; }  ///< why one was last unresolved

 private:
  struct Term {
    std::size_t seen;
    Quantity quantity;
    std::size_t sample;   ///< of the motion; 0 for other quantities
    double value;
    double error;          ///< what one unit of the residual is
    double unknown_error;  ///< the same if errors are not known
    bool stuck;
  };
  /// What was last predicted for an observation: e^2, delta_max and t_max, then delta, v and F of each
  /// sample of its motion.
  struct Prediction {
    Eigen::VectorXd ln, values;
    Eigen::MatrixXd by_ln;  ///< a row a value
    bool resolved = false, with_derivatives = false;
  };
  static Eigen::Index index_of(const Term& term);

  /// if_cheap: where the law has them itself.
  enum class Derivatives { none, if_cheap, all };

  double scale_of(const Term& term) const;
  void add_targets(const ContactFitSettings& settings);
  double usual_error() const;
  void add_term(std::size_t seen, Quantity quantity, const Measured& m, double unknown_error, std::size_t sample = 0);
  void add_e_squared(std::size_t seen, double usual_error);
  void add_motion(std::size_t seen);
  void add_terms();
  Impact scales_of(std::size_t seen) const;
  double power_unit() const;
  void add_scales();
  std::optional<std::size_t> target_of(std::size_t seen, std::size_t free) const;
  CollisionInput input(std::size_t seen, const Eigen::VectorXd& ln) const;
  const Prediction& predict(std::size_t seen, const Eigen::VectorXd& ln, Derivatives wanted) const;
  CollisionSettings settings_for(std::size_t seen) const;
  Eigen::VectorXd numbers(std::size_t seen, const Collision& collision, const CollisionInput& input) const;
  void difference(std::size_t seen, Prediction& prediction) const;
  void differentiate(const Collision& collision, const CollisionInput& input, std::size_t seen,
                     Prediction& prediction) const;

  const CollisionLaw& law_;
  std::span<const ObservedCollision> seen_;
  std::vector<FreeParameter> free_;
  CollisionSettings collision_settings_;
  std::vector<Target> targets_;
  std::vector<CollisionInput> inputs_;  ///< one an observation, with any value of what is free
  std::vector<Term> terms_;
  std::vector<std::vector<double>> times_;  ///< of the motion of each observation
  bool known_errors_ = true;
  double least_error_ = 0;
  CollisionScales scales_;
  mutable std::vector<Prediction> predictions_;
  mutable long collisions_ = 0;
  mutable std::string failure_;
};

}  // namespace mdana
