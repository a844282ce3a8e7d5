#pragma once
/// \file
/// The charts of a diagnosis's page, as SVG with a caption.

#include "diagnose/report/view.hpp"

namespace plumbline::diagnose {

struct PageChart {
  std::string caption, svg;
  bool angle = false;  ///< of a joint angle
};

/// Measured, nominal and corrected over the command, one chart a run and channel.
std::vector<PageChart> curve_charts(const Explained& explained);

/// Residuals before and after along the load path in declared sigmas, the regimes shaded.
std::vector<PageChart> residual_charts(const Explained& explained);

/// For an explanation with friction or relaxation: what the elastic part of the model leaves over the
/// command, in each run that turns back, and where angles are measured the missing torque over the angle.
std::vector<PageChart> loop_charts(const Explained& explained);

/// What is missing, over what it depends on.
PageChart missing_chart(const Missing& missing);

/// Whether what explains the gap is about joints: else their shares would show where nothing is wrong.
bool at_joints(const Explained& explained);

/// The chain in its shapes along each run; where that is so, the joints drawn by their share.
std::vector<PageChart> shape_charts(const Explained& explained);

}  // namespace plumbline::diagnose
