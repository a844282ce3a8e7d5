#pragma once
/// \file
/// The balance of torque: inertias and frictions of an arm from its motion and the torques of its drives.

#include <functional>

#include "diagnose/motion/balance/balance_causes.hpp"
#include "diagnose/motion/balance/balance_terms.hpp"
#include "diagnose/motion/balance/torque_log.hpp"

namespace plumbline::motion {

/// A number that the logs determine: one term, with what no log tells from it (Gautier's base parameters,
/// 1991).
struct BalanceNumber {
  std::string name;  ///< "Izz(1) + 0.09 m(2)"
  std::string unit;
  double value, low, high;  ///< with the 95 % interval
  double stated;            ///< by the model
};

/// Torque that is left at a joint, root mean square, N m.
struct TorqueLeft {
  std::string log;
  bool held_out;
  std::vector<double> whole, stated,
      found;  ///< by joint: the torque itself, less the model's, less the found one
};

struct Balance {
  std::string name;
  std::size_t logs = 0, readings = 0;
  double lead = 0;  ///< of the torque ahead of the motion, s
  std::vector<BalanceNumber> numbers;
  std::vector<TorqueLeft> left;
  std::vector<BalanceCause> causes;         ///< single changes of the model, most probable first
  std::vector<std::string> contradictions;  ///< of the model's own numbers
};

/// Angles are differentiated by polynomials of the fourth degree over neighbouring readings; both sides of
/// the balance pass the same mean over a tenth of a second. Least squares, weighted by joint; intervals by
/// what the blocks of half a second scatter, so that neighbours need not be independent.
/// \throws Error where no number is determined
Balance balance_of(const TorqueBench& bench);

}  // namespace plumbline::motion
