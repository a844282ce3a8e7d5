#pragma once
/// \file
/// Effects of a hypothesis that the readings do not notice.

#include "diagnose/inference/hypothesis.hpp"

namespace plumbline::diagnose {

/// Whether without one of the effects, or with a thousandth of it, the readings are as likely, to one nat. Of
/// friction the least amount changes what a joint with play does, and tells nothing of friction.
bool has_idle_effect(const Study& study, const Likelihood& likelihood, const Hypothesis& hypothesis);

}  // namespace plumbline::diagnose
