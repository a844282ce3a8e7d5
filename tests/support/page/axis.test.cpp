#include "support/page/axis.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/close_to.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::page;

TEST_CASE("an axis maps its ends to its ends") {
  const Axis axis(-2, 6, 100, 20);
  CHECK(axis.pixel(-2) == close_to(100));
  CHECK(axis.pixel(6) == close_to(20));
  CHECK(axis.pixel(2) == close_to(60));
}

TEST_CASE("ticks are few, round and in between") {
  check_property("any range", [] {
    const double low = *rc::gen::inRange(-1000000, 1000000) * 1e-3;
    const double extent = std::pow(10.0, *rc::gen::inRange(-3, 5));
    const Axis axis(low, low + extent, 0, 100);
    const auto ticks = axis.ticks();
    RC_ASSERT(ticks.size() >= 2);
    RC_ASSERT(ticks.size() <= 9);
    for (const auto& tick : ticks) RC_ASSERT(tick.pixel >= -1e-6 && tick.pixel <= 100 + 1e-6);
  });
}

TEST_CASE("zero is written without a sign, and a range of nothing is widened") {
  for (const auto& tick : Axis(-1, 1, 0, 100).ticks()) CHECK(tick.text != "−0");
  CHECK(std::isfinite(Axis(3, 3, 0, 100).pixel(3)));
  CHECK(std::isfinite(Axis(0, 0, 0, 100).pixel(0)));
}

TEST_CASE("a signed logarithmic axis is odd, monotone, and wide near zero") {
  const Axis axis(-100, 100, 0, 200, true);
  CHECK(axis.pixel(0) == close_to(100));
  CHECK(axis.pixel(30) - 100 == close_to(100 - axis.pixel(-30)));
  CHECK(axis.pixel(3) - axis.pixel(0) > axis.pixel(100) - axis.pixel(97));
  CHECK(axis.pixel(100) > axis.pixel(30));
}
