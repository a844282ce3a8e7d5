#pragma once
/// \file
/// Pictures of an experiment before its diagnosis.

#include <vector>

#include "diagnose/inference/study.hpp"
#include "diagnose/report/charts.hpp"

namespace plumbline::app {

/// The readings beside the nominal model: what is read over what is imposed, and of an arm how far its tip is
/// from the model's. Those of the first runs, where there are many.
std::vector<diagnose::PageChart> first_charts(const diagnose::Study& study);

}  // namespace plumbline::app
