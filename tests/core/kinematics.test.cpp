#include <plumbline/chain/kinematics.hpp>

#include <cmath>
#include <plumbline/chain/linearised.hpp>
#include <plumbline/chain/strain_energy.hpp>

#include "tests/close_to.hpp"
#include "tests/property.hpp"

using namespace plumbline;

namespace {

template <class Real>
std::vector<Real> random_values(std::size_t n, int low, int high) {
  std::vector<Real> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(Real(*rc::gen::inRange(low, high)) / Real(1000));
  return values;
}

}  // namespace

TEST_CASE("known end points") {
  const Chain<double> chain({1, 2, 3}, {1, 1, 1});
  CHECK(end_point(chain, {0, 0, 0}).x == 6);
  CHECK(end_point(chain, {0, 0, 0}).y == 0);
  const double right_angle = std::acos(-1.0) / 2;
  const auto p = end_point(chain, {right_angle, -right_angle, right_angle});  // up 1, along 2, up 3
  CHECK(p.x == close_to(2));
  CHECK(p.y == close_to(4));
}

TEST_CASE("the end point reaches the base unless one link is longer than all others together") {
  CHECK(reach<double>({1, 1, 1}).smallest == 0);
  CHECK(reach<double>({1, 1, 1}).largest == 3);
  CHECK(reach<double>({2, 7, 1}).smallest == 4);
  CHECK(reach<double>({2, 3.5, 1}).smallest == 0.5);
  CHECK(reach<double>({2, 7, 1}).largest == 10);
}

TEST_CASE("the Jacobian is the derivative of the end point") {
  check_property("central differences in 50 digits", [] {
    const auto n = *rc::gen::inRange<std::size_t>(1, 9);
    const Chain<Mpfr50> chain(random_values<Mpfr50>(n, 1, 5000), std::vector<Mpfr50>(n, Mpfr50(1)));
    const auto q = random_values<Mpfr50>(n, -3000, 3000);
    const Matrix<Mpfr50> J = jacobian(chain, q);
    const Mpfr50 h("1e-15");
    for (std::size_t i = 0; i < n; ++i) {
      auto forward = q;
      auto backward = q;
      forward[i] += h;
      backward[i] -= h;
      const auto a = end_point(chain, forward);
      const auto b = end_point(chain, backward);
      // third derivatives are at most the chain's length, below 45: an error of 45 h^2 / 6 < 1e-28
      const auto column = static_cast<Eigen::Index>(i);
      RC_ASSERT(abs((a.x - b.x) / (2 * h) - J(0, column)) < Mpfr50("1e-28"));
      RC_ASSERT(abs((a.y - b.y) / (2 * h) - J(1, column)) < Mpfr50("1e-28"));
    }
  });
}

TEST_CASE("the linearised model is the leading order of the full one") {
  check_property("intervals around small angles", [] {
    const auto n = *rc::gen::inRange<std::size_t>(1, 9);
    const Chain<Rational> exact(random_values<Rational>(n, 1, 5000), std::vector<Rational>(n, Rational(1)));
    std::vector<Rational> q = random_values<Rational>(n, -1000, 1000);
    for (Rational& angle : q) angle /= 1000000;  // |theta| < 1e-5
    const auto chain = from_rational<Interval>(exact);
    std::vector<Interval> angles;
    for (const Rational& angle : q) angles.emplace_back(angle);
    const auto small = small_deflection(chain, angles);
    const auto p = end_point(chain, angles);
    const Interval length = distance_to_end(chain)[0];
    // 1 - cos t and t^2/2 differ by less than t^4/24 < 1e-20/24, sin t and t by less than t^3/6 < 1e-15/6
    const Interval unit = hull(Interval(-1), Interval(1));
    RC_ASSERT((length - p.x - small.x).inside(length * unit / Interval(Rational("100000000000000000000"))));
    RC_ASSERT((p.y - small.y).inside(length * unit / Interval(Rational("1000000000000000"))));
  });
}

TEST_CASE("the springs' torque is the gradient of the strain energy, exactly") {
  check_property("a quadratic form", [] {
    const auto n = *rc::gen::inRange<std::size_t>(1, 9);
    const Chain<Rational> chain(random_values<Rational>(n, 1, 5000), random_values<Rational>(n, 0, 5000),
                                random_values<Rational>(n, -3000, 3000));
    const auto q = random_values<Rational>(n, -3000, 3000);
    const auto i = *rc::gen::inRange<std::size_t>(0, n);
    auto moved = q;
    moved[i] += 1;
    const Rational gain = strain_energy(chain, moved) - strain_energy(chain, q);
    RC_ASSERT(gain == spring_torque(chain, q)(static_cast<Eigen::Index>(i)) + chain.stiffness()[i] / 2);
  });
  CHECK(strain_energy(Chain<Rational>({1, 1}, {2, 3}, {1, 1}), {1, 1}) == 0);
}

TEST_CASE("joints are where the links before them end, and the end point is the last") {
  const Chain<double> chain({1, 2, 3}, {1, 1, 1});
  const double right_angle = std::acos(-1.0) / 2;
  const std::vector<double> q{right_angle, -right_angle, right_angle};
  const auto places = joint_places(chain, q);
  const std::vector<Point<double>> expected{{0, 0}, {0, 1}, {2, 1}, {2, 4}};
  REQUIRE(places.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    // cosines of a rounded right angle are below 1e-16
    CHECK(std::abs(places[i].x - expected[i].x) < 1e-15);
    CHECK(std::abs(places[i].y - expected[i].y) < 1e-15);
  }
  CHECK(places[3].x == end_point(chain, q).x);
  CHECK(places[3].y == end_point(chain, q).y);
}
