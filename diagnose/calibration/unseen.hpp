#pragma once
/// \file
/// What corrections of an arm leave of poses that they have not seen, by linear fits.

#include "diagnose/calibration/columns.hpp"

namespace plumbline::diagnose {

/// Every fifth reading is held out, five times over, or every fifth run where there are five or more; frames
/// are fitted to the others each time.
struct UnseenTest {
  const Measurements& measurements;
  const MatrixXd& frames;
  const EffectColumns& effects;
  const VectorXd& values;  ///< what the arm leaves without the effects

  /// Of the nominal arm.
  [[nodiscard]] LeftOfPoses nominal() const;
  /// Of all zeros, shifts, tilts, gears and compliances, tied so weakly that ten times the typical size is
  /// free.
  [[nodiscard]] LeftOfPoses least_squares() const;
  /// Of the posterior mean, its groups chosen and its sizes learned anew each time.
  [[nodiscard]] LeftOfPoses corrected() const;
};

}  // namespace plumbline::diagnose
