#pragma once
/// \file
/// A comparison of many diagnoses: the common cause, the spread of its parameters between sessions, their
/// drift.

#include "diagnose/campaign/outcome.hpp"

namespace plumbline::campaign {

/// An estimate with its 95 % bounds.
struct Estimate {
  double value, low, high;
};

/// One parameter of one cause, in the experiments that identified it.
struct Parameter {
  std::string effect, name, unit;     ///< "joint_friction", "tau_c", "N m"; "ratio" for one
  std::vector<std::size_t> outcomes;  ///< by number, in the order listed
  std::vector<Estimate> estimates;    ///< of each of them
  Estimate mean;                      ///< over sessions with a standard deviation `spread`
  double spread = 0;                  ///< standard deviation between sessions beyond the bounds
  double p_no_spread = 1;             ///< p-value of no such spread
  std::optional<Estimate> drift;      ///< by day, or by experiment; of three or more
};

/// One explanation and the experiments that name it.
struct Cause {
  std::vector<std::string> effects;               ///< sorted; {"none"} or {"unknown"} without a cause
  std::vector<std::size_t> named_by, allowed_by;  ///< allowed: in the class of an ambiguous verdict
};

struct Comparison {
  std::vector<Cause> causes;  ///< most often named first
  std::vector<Parameter> parameters;
  bool by_date = false;  ///< all experiments have a date, and drifts are by day
  std::size_t failed = 0;
};

Comparison compare(const std::vector<Outcome>& outcomes);

/// Random effects after Paule and Mandel (1982), with the bounds of Hartung and Knapp (2001).
struct Pooled {
  Estimate mean;
  double spread, p_no_spread;
};
/// \pre at least two estimates
Pooled pooled(const std::vector<Estimate>& estimates);
/// Slope of a line through the estimates, with the remaining variance between sessions.
/// \pre at least three of them, at two places at least
Estimate drift(const std::vector<Estimate>& estimates, const std::vector<double>& places);

}  // namespace plumbline::campaign
