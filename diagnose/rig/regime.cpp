#include "diagnose/rig/regime.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// Steps of end point and force between two readings; commanded or predicted, never measured.
struct Step {
  Vector2 motion, force;
};

Step step(const Trace& nominal, Eigen::Index from, Eigen::Index to) {
  const auto difference = [&](Eigen::Index column) { return nominal(to, column) - nominal(from, column); };
  return {Vector2(difference(column_x), difference(column_y)),
          Vector2(difference(column_Fx), difference(column_Fy))};
}

/// The direction in which the command moves: that of the end point, of the force, or of loads along the
/// chain.
Vector2 pushed(const Run& run, const Trace& nominal, Eigen::Index reading) {
  if (!run.loads.empty()) return run.command(run.readings[static_cast<std::size_t>(reading)]);
  if (run.holds_end_point()) return {nominal(reading, column_x), nominal(reading, column_y)};
  return {nominal(reading, column_Fx), nominal(reading, column_Fy)};
}

}  // namespace

std::string regime_word(Regime regime) {
  switch (regime) {
    case Regime::pre_critical:
      return "pre-critical";
    case Regime::near_critical:
      return "near-critical";
    case Regime::post_critical:
      return "post-critical";
    case Regime::loading:
      return "loading";
    case Regime::unloading:
      break;
  }
  return "unloading";
}

std::vector<Regime> regimes(const Run& run, const Trace& nominal) {
  const Eigen::Index count = nominal.rows();
  std::vector<Regime> result(static_cast<std::size_t>(count), Regime::pre_critical);
  const Vector2 start = pushed(run, nominal, 0);
  double first = 0, last = 0;
  Regime now = Regime::pre_critical;
  for (Eigen::Index i = 1; i < count; ++i) {
    const Step change = step(nominal, i - 1, i);
    const double distance = (pushed(run, nominal, i) - start).norm();
    const double square = change.motion.squaredNorm();
    if (square > 0 && change.motion.allFinite() && change.force.allFinite()) {
      // The tangent stiffness along the motion: change of force over change of position.
      const double stiffness = change.force.dot(change.motion) / square;
      if (first == 0) first = stiffness;
      const double left = first != 0 ? stiffness / first : 1;
      if (distance < last * (1 - 1e-9)) {
        now = Regime::unloading;
      } else {
        now = left >= 0.5   ? Regime::pre_critical
              : left >= 0.1 ? Regime::near_critical
                            : Regime::post_critical;
      }
    }
    last = distance;
    result[static_cast<std::size_t>(i)] = now;
  }
  if (count > 1) result[0] = result[1] == Regime::unloading ? Regime::pre_critical : result[1];
  if (!run.end().has_links)
    for (Regime& one : result)
      if (one != Regime::unloading) one = Regime::loading;
  return result;
}

}  // namespace plumbline::diagnose
