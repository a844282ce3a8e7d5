#pragma once
/// \file
/// What many diagnoses say together: whether the cause is the same, how far its parameter scatters from
/// session to session, whether it drifts.

#include "diagnose/campaign/outcome.hpp"

namespace plumbline::campaign {

/// An estimate with its 95 % bounds.
struct Estimate {
  double value, low, high;
};

/// One parameter of one cause, in the experiments that identified it.
struct Parameter {
  std::string effect, name, unit;     ///< "joint_friction", "tau_c", "N m"; "ratio" for one
  std::vector<std::size_t> outcomes;  ///< which, in the order listed
  std::vector<Estimate> estimates;    ///< of each of them
  Estimate mean;                      ///< over sessions, which scatter by `spread`
  double spread = 0;                  ///< standard deviation from session to session, beyond what bounds say
  double alike = 1;                   ///< p-value of there being no such spread
  std::optional<Estimate> drift;      ///< by day, or from one experiment to the next; of three or more
};

/// One explanation and who named it.
struct Cause {
  std::vector<std::string> effects;               ///< sorted; {"none"} or {"unknown"} where nothing is named
  std::vector<std::size_t> named_by, allowed_by;  ///< allowed: listed as one of several that explain alike
};

struct Comparison {
  std::vector<Cause> causes;  ///< most often named first
  std::vector<Parameter> parameters;
  bool by_date = false;  ///< all have a date: drifts are by day
  std::size_t failed = 0;
};

Comparison compare(const std::vector<Outcome>& outcomes);

/// Random effects after Paule and Mandel (1982), with the bounds of Hartung and Knapp (2001).
struct Pooled {
  Estimate mean;
  double spread, alike;
};
/// \pre at least two estimates
Pooled pooled(const std::vector<Estimate>& estimates);
/// Slope of a line through the estimates, which scatter about it by what is left between sessions.
/// \pre at least three of them, at two places at least
Estimate drift(const std::vector<Estimate>& estimates, const std::vector<double>& places);

}  // namespace plumbline::campaign
