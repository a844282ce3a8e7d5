/// What the enclosure of an equilibrium refuses: boxes and loads for which there is not exactly one regular
/// root.
#include "proofs/census/equilibrium_enclosure.hpp"

#include <doctest/doctest.h>

#include "proofs/exact/decimal.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// One link, k = L = 1, under a force: theta - rest + f_x sin theta - f_y cos theta = 0.
struct Link {
  Rational rest, fx, fy;
  [[nodiscard]] std::optional<CertifiedEquilibrium> between(double low, double high) const {
    Box box{};
    box[0] = Span(low, high);
    const Chain<Interval> chain({Interval(1)}, {Interval(1)}, {Interval(rest)});
    return enclose(chain, Control::force, {Interval(fx), Interval(fy)}, box);
  }
};

/// f_x = -1, f_y = off - rest: nearly -theta^2 / 4 = off, a fold at theta = 0; two roots near by where off <
/// 0, none where off > 0.
Link beside_fold(const Rational& off) {
  return {Rational(1, 2), -1, Rational(-1, 2) + off};
}

}  // namespace

TEST_CASE("a root is enclosed in the box that holds it and in no other") {
  const Link unloaded{Rational(1, 2), 0, 0};
  const auto found = unloaded.between(0.3, 0.6);
  REQUIRE(found);
  CHECK(found->q[0].lower() <= 0.5);
  CHECK(found->q[0].upper() >= 0.5);
  CHECK(found->q[0].upper() - found->q[0].lower() < Interval::End("1e-40"));
  for (const auto& [low, high] : {std::pair{0.51, 0.7}, {0.2, 0.49}, {-1.0, 0.0}, {0.6, 2.0}})
    CHECK_FALSE(unloaded.between(low, high));
}

TEST_CASE("at a fold nothing is enclosed") {
  for (const auto& [low, high] :
       {std::pair{-0.1, 0.1}, {-0.1, 0.2}, {-0.05, 0.12}, {-0.2, 0.01}, {-0.3, 0.01}}) {
    CAPTURE(low);
    CHECK_FALSE(beside_fold(0).between(low, high));
  }
}

TEST_CASE("where there is no root none is enclosed, wherever Newton's method has ended") {
  for (const std::string off :
       {"1e-4", "1e-9", "1e-15", "1e-18", "1e-20", "1e-22", "1e-25", "1e-30", "1e-40"}) {
    CAPTURE(off);
    const Link link = beside_fold(*parse_decimal(off));
    for (double low = -0.2; low < -0.01; low += 0.013) CHECK_FALSE(link.between(low, 0.2));
  }
  CHECK(beside_fold(Rational(-1, 10000)).between(0.01, 0.03));  // theta = 0.02, about
}
