#include "diagnose/answers/candidate_runs.hpp"

#include <doctest/doctest.h>

#include "diagnose/model/history.hpp"

using namespace plumbline::diagnose;

TEST_CASE("a run may ask for twice the force and half as much deflection again as those before, by hand") {
  const Extent so_far{0.1, 2.5, 0.4, 2};
  const std::vector<double> rest{0.3, -0.5};
  // Fx, Fy and the joints' turns at the second reading; the first is unloaded
  const auto trace = [&](double Fx, double Fy, double turn1, double turn2) {
    Trace result = Trace::Zero(2, column_q + 2);
    result.row(1)[column_Fx] = Fx;
    result.row(1)[column_Fy] = Fy;
    for (const Eigen::Index row : {0, 1}) {
      result.row(row)[column_q] = rest[0] + static_cast<double>(row) * turn1;
      result.row(row)[column_q + 1] = rest[1] + static_cast<double>(row) * turn2;
    }
    return result;
  };
  CHECK(so_far.allows(trace(-3, 3.9, 0.59, -0.59), rest));  // 4.92 N of 5, 0.59 rad of 0.6
  CHECK_FALSE(so_far.allows(trace(-3, 4.1, 0.1, 0), rest));
  CHECK_FALSE(so_far.allows(trace(5.1, 0, 0.1, 0), rest));
  CHECK_FALSE(so_far.allows(trace(1, 0, 0.61, 0), rest));
  CHECK_FALSE(so_far.allows(trace(1, 0, 0.1, -0.61), rest));
  // where nothing was asked so far anything may be
  CHECK(Extent{}.allows(trace(100, 0, 3, 3), rest));
}
