#pragma once
/// \file
/// What motions can show before any of them is logged: which effects they do not show, which they cannot tell
/// apart, and the fewest that do as well as all.

#include <functional>
#include <string>
#include <vector>

#include "diagnose/motion/bench.hpp"

namespace plumbline::motion {

/// Effects that no motion of the list tells apart, and that share their further alternatives.
struct AlikeEffects {
  std::vector<std::string> effects;
  std::vector<std::string> others;  ///< further effects from which none of them is told
  bool exactly = false;             ///< several whose readings are the same
};

struct MotionPlan {
  std::string name;
  std::size_t motions = 0;
  std::vector<std::string> undetectable;  ///< below the noise at their typical size
  std::vector<AlikeEffects> indistinguishable;
  std::size_t separated = 0;        ///< pairs of effects that the motions tell apart
  std::vector<std::string> fewest;  ///< motions that do so, in the order of their contribution
  bool proved_minimal = false;      ///< no fewer do so
};

/// Effects are compared as in the plan of a static bench (diagnose/design/plan.hpp): the truth, at its
/// typical size, against the model or another effect, whose parameters are fitted beside the drive's unknown
/// numbers and the begins of segments, all linear about their typical sizes, by the noise of the readings
/// alone. So a diagnosis, which allows for what no model has, tells less apart than the plan promises.
/// \param bench     the positions of its logs are their commands, for nothing is read yet
/// \param progress  called with the share of the work that is done
MotionPlan plan_of(Bench bench, const std::function<void(double)>& progress = {});

}  // namespace plumbline::motion
