#pragma once
/// \file
/// The search: which rows may act, fitted and weighed.

#include <functional>
#include <memory>

#include "diagnose/motion/hypothesis.hpp"

namespace plumbline::motion {

struct Findings {
  std::shared_ptr<const Likelihood> likelihood;
  Hypothesis nominal;                  ///< the model as it is stated, its unknown numbers fitted
  std::vector<Hypothesis> hypotheses;  ///< most evidence first
};

/// Fits every row alone, and then beside those that explain most, up to three.
/// \param progress  called with the share of the work that is done
/// \throws Error where no start of the unknown numbers follows the logs
Findings search(const Study& study, const std::function<void(double)>& progress = {});

}  // namespace plumbline::motion
