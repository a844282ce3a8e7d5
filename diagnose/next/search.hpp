#pragma once
/// \file
/// The search for hypotheses: which effects, fitted and weighed.

#include <functional>
#include <memory>

#include "diagnose/next/hypothesis.hpp"
#include "diagnose/next/noise_shape.hpp"

namespace plumbline::diagnose::next {

/// What was found of an experiment.
struct Findings {
  std::shared_ptr<const Data> data;
  std::shared_ptr<const States> states;
  std::shared_ptr<const std::vector<Effect>> outside;  ///< rows of unknown torques
  std::shared_ptr<const Likelihood> likelihood;
  std::vector<VectorXd> nominal_residual;
  Look nominal;                        ///< what the likelihood says of the nominal model
  std::vector<Hypothesis> hypotheses;  ///< most evidence first
};

/// \param progress  called with the share of the work that is done
Findings search(const Study& study, const std::function<void(double)>& progress = {});

}  // namespace plumbline::diagnose::next
