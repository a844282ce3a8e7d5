#pragma once
/// \file
/// The charts of the page, as SVG with captions.

#include "diagnose/report/view.hpp"

namespace plumbline::diagnose {

struct PageChart {
  std::string caption, svg;
  bool angle = false;  ///< of a joint angle
};

/// What a model predicts, and the class of the style sheet that draws it.
struct DrawnModel {
  const char* ink;  ///< "nominal", "corrected"
  const Prediction* prediction;
};

/// The unit in which charts show a channel: degrees for angles, millimetres for places, else that of the SI.
struct ShownUnit {
  double per_si;
  std::string name;
};
ShownUnit shown_unit(const Channel& channel);

/// Measured and modelled over the command, one chart a run and channel: a joint's channel over its own
/// command. Poses that were taken one by one, without a clock, are points; readings in time are lines.
/// \param heldout  or empty
std::vector<PageChart> curve_charts(const Study& study, const std::vector<DrawnModel>& models,
                                    const HeldOut& heldout = {});

/// Residual vectors of the tracked points of an arm, from above and from the side, one chart a run, point and
/// view: from the measured place to the modelled one, enlarged.
std::vector<PageChart> tip_charts(const Study& study, const std::vector<DrawnModel>& models);

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
