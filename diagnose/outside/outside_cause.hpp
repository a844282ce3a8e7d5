#pragma once
/// \file
/// Causes outside of the catalogue, a row each: what readings are like beside one. Posterior and noise weigh
/// them by the same list.

#include <memory>
#include <vector>

#include "diagnose/inference/likelihood.hpp"

namespace plumbline::diagnose {

/// What a model leaves of the readings.
struct Leftover {
  const Likelihood& likelihood;
  const VectorXd& residual;  ///< flat, declared sigmas
  const Look& look;          ///< what the likelihood says of that residual
};

/// A cause outside of the catalogue beside a model, its size and place summed out.
struct OutsideFit {
  double log_likelihood;
  double size = 0;         ///< posterior mean, over the root mean square of the nominal residual
  double discrepancy = 0;  ///< variance of a smooth discrepancy over that of the noise, one at most (Look)
};

class OutsideCause {
 public:
  virtual ~OutsideCause() = default;
  [[nodiscard]] virtual OutsideFit fit(const Leftover& left) const = 0;
  /// Whether a device may do a little of this beside whatever else is its cause.
  [[nodiscard]] virtual bool stands_beside() const { return false; }
};

// Each in a file of its own, outside/causes.
std::unique_ptr<OutsideCause> smooth_departure();
std::unique_ptr<OutsideCause> one_channel();
std::unique_ptr<OutsideCause> local_departure();
std::unique_ptr<OutsideCause> departure_at_the_ends();
std::unique_ptr<OutsideCause> step_departure();
std::unique_ptr<OutsideCause> scatter();
std::unique_ptr<OutsideCause> scatter_of_a_part();

/// A row: how a cause is made, and its share of all causes outside of the catalogue.
struct OutsideRow {
  std::unique_ptr<OutsideCause> (*make)();
  double share;
};
inline constexpr OutsideRow outside_rows[] = {
    {smooth_departure, 0.3}, {local_departure, 0.2}, {departure_at_the_ends, 0.1}, {step_departure, 0.1},
    {one_channel, 0.1},      {scatter, 0.1},         {scatter_of_a_part, 0.1},
};

/// Log likelihood beside a cause outside of the catalogue, whichever.
double log_outside(const Leftover& left);

}  // namespace plumbline::diagnose
