#include "proofs/paths/path_load.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("a path's load is a ray from the unloaded state as long as it was told, within reach") {
  const Chain<Rational> chain({1, 1}, {1, 1});
  const PathTask moved = path_task(chain, {Control::end_point, {-0.3, 0.4}}, 0.1, -1);
  CHECK(moved.loading.control == Control::end_point);
  CHECK(moved.loading.start.x == 2);
  CHECK(moved.loading.start.y == 0);
  CHECK(std::abs(moved.loading.direction.x + 0.6) < 1e-15);  // a quotient of rounded decimals
  CHECK(std::abs(moved.loading.direction.y - 0.8) < 1e-15);
  CHECK(std::abs(moved.last - 0.5) < 1e-15);
  CHECK(moved.step == 0.1);
  CHECK(moved.side == -1);
  const PathTask pushed = path_task(chain, {Control::force, {-30, 40}}, 0.1, 1);
  CHECK(pushed.loading.start.x == 0);
  CHECK(pushed.last == 50);  // a force may be of any size

  const char* const none = "load: found nothing to do, expected a finite load that is not zero";
  for (const Control control : {Control::end_point, Control::force}) {
    CHECK_THROWS_WITH_AS(path_task(chain, {control, {0, 0}}, 0.1, 1), none, Error);
    const double infinite = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS(path_task(chain, {control, {infinite, 0}}, 0.1, 1), none, Error);
  }
  // from (2, 0) on, where the chain is stretched, to beyond its reach on either side
  CHECK_THROWS_AS(path_task(chain, {Control::end_point, {0.5, 0}}, 0.1, 1), Error);
  CHECK_THROWS_AS(path_task(chain, {Control::end_point, {-4.5, 0}}, 0.1, 1), Error);
  CHECK_NOTHROW(path_task(chain, {Control::end_point, {-3.5, 0}}, 0.1, 1));
}
