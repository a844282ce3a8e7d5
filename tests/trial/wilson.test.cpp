#include "trial/wilson.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/close_to.hpp"

using plumbline::trial::Proportion;

TEST_CASE("Wilson's interval, as R. G. Newcombe tabulates it (Statistics in Medicine 17, 1998, table I)") {
  const auto check = [](Proportion p, double low, double high) {
    CHECK(std::abs(p.low() - low) < 5e-5);
    CHECK(std::abs(p.high() - high) < 5e-5);
  };
  check({81, 263}, 0.2553, 0.3662);
  check({15, 148}, 0.0624, 0.1605);
  check({0, 20}, 0, 0.1611);
  check({1, 29}, 0.0061, 0.1718);
}

TEST_CASE("all, none, and none of zero") {
  CHECK(Proportion{20, 20}.high() == 1);
  CHECK(Proportion{20, 20}.low() == close_to(1 - Proportion{0, 20}.high()));
  CHECK(Proportion{}.low() == 0);
  CHECK(Proportion{}.high() == 1);
}
