#pragma once
/// \file
/// Single changes of an arm's model, or of the constants of its drives, that may explain its torques.

#include <string>
#include <vector>

#include "diagnose/motion/balance/stretches.hpp"

namespace plumbline::motion {

/// A number of a change, with its 95 % interval.
struct CauseNumber {
  std::string name, unit;
  double value, low, high;
};

struct BalanceCause {
  std::string id;     ///< "payload", "torque_constant(2)"; "as_stated" for the model without a change
  std::string words;  ///< a noun phrase
  std::vector<CauseNumber> numbers;
  std::vector<double> left;  ///< torque, root mean square by joint, N m
  double probability;        ///< among the changes that are tried
};

/// The model as it is stated; with a load at its tip; with another torque constant of one drive, or one
/// factor of all of them. Armature, viscous and dry friction and an offset of each joint are fitted beside
/// each. Probabilities are those of the marginal likelihoods of linear models whose noise is not known
/// (Schwarz 1978), by as many readings as there are blocks of stretches; most probable first.
/// \param logs    stretches of the logs that are fitted
/// \param stated  terms of the model
/// \param weight  of a square, by joint
std::vector<BalanceCause> balance_causes(const diagnose::NominalArm& arm, const std::vector<Stretches>& logs,
                                         std::size_t lead, const Eigen::VectorXd& stated,
                                         const Eigen::VectorXd& weight);

}  // namespace plumbline::motion
