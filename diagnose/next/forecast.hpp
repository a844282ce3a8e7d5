#pragma once
/// \file
/// Linear forecasts: what each effect would explain of what a hypothesis leaves.

#include "diagnose/next/hypothesis.hpp"

namespace plumbline::diagnose::next {

/// All values of all blocks in one vector, in units of their noise; outliers have no weight.
class Stack {
 public:
  /// \param scale  of the noise of each block, over the declared one
  Stack(const Data& data, const NoiseShape& shape, const std::vector<double>& scale);
  [[nodiscard]] VectorXd operator()(const std::vector<VectorXd>& by_block) const;
  [[nodiscard]] MatrixXd operator()(const std::vector<MatrixXd>& by_block) const;

 private:
  std::vector<VectorXd> weight_;
  Eigen::Index size_ = 0;
};

/// An effect that might act beside those of a hypothesis.
struct Prospect {
  EffectAt effect;
  InitialGuesses starts;  ///< of both, the parameters of the hypothesis first
  double cost;            ///< forecast of the sum of squares, with what Gaussian priors charge
};

/// Forecasts every possible effect beside a hypothesis, the most promising first: score tests that share one
/// prediction. An effect whose derivative depends on where it acts is probed at several places; one of which
/// little acts otherwise than much, by a finite step.
std::vector<Prospect> forecast(const Study& study, const Data& data, const Stack& stack,
                               const std::vector<EffectAt>& possible, const Hypothesis& beside);

}  // namespace plumbline::diagnose::next
