#include "diagnose/rig/regime.hpp"

#include <doctest/doctest.h>

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// A run whose end point is commanded along x, at a nominal stiffness of 1 N/m.
std::pair<Run, Trace> along_x(const std::vector<double>& x) {
  Run run{"run", Control::end_point, {0}, {}};
  Trace trace = Trace::Zero(static_cast<Eigen::Index>(x.size()), 5);
  for (std::size_t i = 0; i < x.size(); ++i) {
    run.readings.push_back({2.0 * static_cast<double>(i), {x[i], 0, 0, 0}});
    trace(static_cast<Eigen::Index>(i), column_x) = trace(static_cast<Eigen::Index>(i), column_Fx) = x[i];
  }
  return {run, trace};
}

}  // namespace

TEST_CASE("a cyclic test loads in both directions, and again in its second cycle") {
  const auto [run, trace] = along_x({0, 1, 2, 1, 0, -1, -2, -1, 0, 1, 2});
  const auto forth = Regime::pre_critical, back = Regime::unloading;
  CHECK(regimes(run, trace) ==
        std::vector<Regime>{forth, forth, forth, back, back, forth, forth, back, back, forth, forth});
}

TEST_CASE("a waiting rig stays in its regime") {
  const auto [run, trace] = along_x({0, 1, 2, 2, 1, 1, 0});
  const auto forth = Regime::pre_critical, back = Regime::unloading;
  CHECK(regimes(run, trace) == std::vector<Regime>{forth, forth, forth, forth, back, back, back});
}

TEST_CASE("a joint alone has nothing to lose its stability: it loads and unloads") {
  auto [run, trace] = along_x({0, 1, 2, 1, 0});
  run.device = Device::turning_joint;
  const auto forth = Regime::loading, back = Regime::unloading;
  CHECK(regimes(run, trace) == std::vector<Regime>{forth, forth, forth, back, back});
}
