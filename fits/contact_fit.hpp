// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fits/fit.hpp"
#include "fits/observed_collision.hpp"

namespace mdana {

/// A parameter of a collision law that is to be found, > 0.
struct FreeParameter {
  std::string name;
  std::optional<double> start = {};
  std::optional<double> least = {}, greatest = {};  ///< bounds; by default from the scales of the data
  std::optional<Measured> prior = {};      ///< what is known of it from elsewhere
  bool per_radius = false;                ///< one for each R of the data
};

/// The parameters that are usually fitted: T_vis; C, B, zeta; D, alpha, beta; gamma; E, Y.
std::vector<FreeParameter> usual_free_parameters(const CollisionLaw& law);

struct ContactFitSettings {
  std::vector<FreeParameter> free;
  std::vector<NamedNumber> constants;  ///< parameters that neither the data give nor the fit finds
  Loss loss = Loss::none;              ///< scale: one standard error
  int starts = 8;                      ///< the first is the given or the middle one
  double tolerance = 1e-9;             ///< of e in each collision
};

/// A parameter that was found.
struct Estimate {
  std::string name;
  std::optional<double> radius;  ///< of the group that it holds for, if there is one for each R
  double value = 0;
  double error = 0;              ///< standard error
};

/// Where some of the starts ended.
struct ContactMinimum {
  std::vector<double> values;  ///< of the parameters, in the order of the estimates
  double cost = 0;             ///< sum of squared residuals, damped by the loss
  int starts = 0;
};

/// A law's parameters from collisions that were seen. Residuals are (e^2 - e_seen^2)/(2 max(e, s) s),
/// s the standard error of e, continued below e = 0 where the law predicts sticking and 0 there if
/// sticking was seen; (delta_max - seen)/s and (t_max - seen)/s. Without standard errors those of e^2
/// count as 1, the others as the numbers themselves.
struct ContactFit {
  std::vector<Estimate> parameters;
  Eigen::MatrixXd correlation;          ///< of their logarithms
  std::vector<double> singular_values;  ///< of d residual/d ln parameter, largest first
  std::string weak_direction;           ///< what the data determine least, in words
  std::vector<ContactMinimum> minima;   ///< distinct ones, best first
  std::vector<double> residuals;        ///< of the data, in their order
  std::vector<std::size_t> seen;        ///< which observation each residual is of
  bool known_errors = false;            ///< every observation has a standard error
  double chi2 = 0;                      ///< sum of squares of the residuals
  double aic = 0, bic = 0;              ///< Akaike's and Schwarz's; of the residuals' variance if errors are unknown
  double digits = 0;                    ///< correct digits of the optimum
  long collisions = 0;                  ///< that were solved
  double seconds = 0;
  bool usable = false;
  std::string reason;                   ///< why it is not usable, or empty
};

/// Throws InputError if an observation lacks a parameter, or nothing is free.
ContactFit fit_contact(const CollisionLaw& law, std::span<const ObservedCollision> seen,
                       const ContactFitSettings& settings);

}  // namespace mdana
