#pragma once
/// \file
/// The charts of the page, as SVG with captions.

#include "diagnose/report/view.hpp"

namespace plumbline::diagnose {

struct PageChart {
  std::string caption, svg;
  bool angle = false;  ///< of a joint angle
};

/// Measured, nominal and corrected over the command, one chart a run and channel.
std::vector<PageChart> curve_charts(const Explained& explained);

/// Residuals before and after, along the load path in declared sigmas, with the regimes shaded.
std::vector<PageChart> residual_charts(const Explained& explained);

/// For explanations with friction or relaxation: the readings minus the elastic part of the model, over the
/// command of each run that reverses, and the torque residual over the joint angle where angles are measured.
std::vector<PageChart> loop_charts(const Explained& explained);

/// The unexplained residual over its abscissa.
PageChart missing_chart(const Missing& missing);

/// Whether the explanation acts at joints, so that shares of joints are meaningful.
bool at_joints(const Explained& explained);

/// The chain in its shapes along each run, with the shares of joints where these are meaningful.
std::vector<PageChart> shape_charts(const Explained& explained);

}  // namespace plumbline::diagnose
