// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
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

/// Intervals that do not take the model for linear.
struct IntervalSettings {
  bool profile = false;    ///< where the cost, least over the other parameters, has risen by the quantile
  std::size_t draws = 0;   ///< fits to observations drawn anew from those seen; 0: no bootstrap
  std::uint64_t seed = 1;  ///< of the draws
  double level = 0.682689492137086;  ///< probability; by default that of one standard error
};

struct ContactFitSettings {
  std::vector<FreeParameter> free;
  std::vector<NamedNumber> constants;  ///< parameters that neither the data give nor the fit finds
  Loss loss = Loss::none;              ///< scale: one standard error
  int starts = 8;                      ///< the first is the given or the middle one
  IntervalSettings intervals;
  bool cross_validation = false;       ///< residuals of radii and velocities that are left out
};

/// Ends of an interval; NaN where there is none.
struct Interval {
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();

  bool known() const { return low == low || high == high; }
};

/// A parameter that was found.
struct Estimate {
  std::string name;
  std::optional<double> radius;  ///< of the group that it holds for, if there is one for each R
  double value = 0;
  double error = 0;              ///< standard error
  Interval profile = {}, bootstrap = {};  ///< if wanted

  std::string full_name() const;  ///< "C" or "C(R=58.9)"
};

/// The last three are of the samples of a motion.
enum class SeenQuantity { e_squared, delta_max, t_max, delta, velocity, force };

/// What the fitted law says of one number that was seen.
struct FittedPoint {
  std::size_t seen = 0;        ///< index of the observation
  SeenQuantity quantity = SeenQuantity::e_squared;
  std::size_t sample = 0;      ///< of its motion
  double predicted = 0;
  double residual = 0;
};

/// Where some of the starts ended.
struct ContactMinimum {
  std::vector<double> values;  ///< of the parameters, in the order of the estimates
  double cost = 0;             ///< sum of squared residuals, damped by the loss
  int starts = 0;
};

/// A law's parameters from collisions that were seen. Residuals are (e^2 - e_seen^2)/(2 max(e, s) s),
/// s the standard error of e (of sticking collisions without one: the median), continued below e = 0
/// where the law predicts sticking and 0 there if sticking was seen; (x - seen)/s for the others. Without
/// standard errors those of e^2 count as 1, of delta_max and t_max as the numbers themselves, of delta, v
/// and F as their greatest sizes in the collision.
struct ContactFit {
  std::vector<Estimate> parameters;
  Eigen::MatrixXd correlation;          ///< of their logarithms
  std::vector<double> singular_values;  ///< of d residual/d ln parameter, largest first
  std::string weak_direction;           ///< what the data determine least, in words
  std::vector<ContactMinimum> minima;   ///< distinct ones, best first
  std::vector<FittedPoint> points;      ///< one a residual, in the order of the data
  bool known_errors = false;            ///< every observation has a standard error
  double chi2 = 0;                      ///< sum of squares of the residuals
  double residual_memory = 1;           ///< see fits/residual_memory.hpp
  double aic = 0, bic = 0;              ///< Akaike's and Schwarz's; of the residuals' variance if errors are unknown
  /// Root mean square residual of a velocity or radius that is left out; NaN if it is not known.
  double left_out_velocity = std::numeric_limits<double>::quiet_NaN();
  double left_out_radius = std::numeric_limits<double>::quiet_NaN();
  double digits = 0;                    ///< correct digits of the optimum
  long collisions = 0;                  ///< that were solved
  double seconds = 0;
  std::size_t draws = 0;                ///< of the bootstrap that led to an optimum
  std::vector<std::string> notes;       ///< what intervals could not tell
  bool usable = false;
  std::string reason;                   ///< why it is not usable, or empty
};

/// Not usable is also a fit of E* and Y of Andrews' law if the elastic limit describes the collisions as well
/// (within two standard deviations); if the rigid plastic limit does, a note says so.
/// Throws InputError if an observation lacks a parameter. Nothing free: what the law says as it stands.
ContactFit fit_contact(const CollisionLaw& law, std::span<const ObservedCollision> seen,
                       const ContactFitSettings& settings);

}  // namespace mdana
