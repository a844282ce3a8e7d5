#include <plumbline/chain/mode.hpp>

#include <doctest/doctest.h>

using namespace plumbline;

TEST_CASE("shape names of the paper's Table 3 and of the three-link chain, and their continuation") {
  CHECK(shape_name("+---") == "U");
  CHECK(shape_name("+--+") == "ZU");
  CHECK(shape_name("+-+-") == "Z");
  CHECK(shape_name("-+++") == "U");
  CHECK(shape_name("+--") == "U");
  CHECK(shape_name("+-+") == "Z");
  CHECK(shape_name("+-") == "U");
  CHECK(shape_name("+--++") == "UZU");
  CHECK(shape_name("+-++-") == "ZUZ");
  CHECK(shape_name("+-0-+") == "ZU");  // a joint that does not bend is passed over
}

TEST_CASE("signs, zeros among them") {
  CHECK(sign_pattern<Rational>({Rational(1, 3), -2, 0}) == "+-0");
}

TEST_CASE("energy factor and lateral force of exact modes") {
  // three links, passive base: F = k/L at (1, -1, -1), 3k/L at (1, -3, 3), no lateral force
  const Chain<Rational> passive({1, 1, 1}, {0, 1, 1});
  CHECK(energy_factor(passive, {1, -1, -1}) == 1);
  CHECK(energy_factor(passive, {1, -3, 3}) == 3);
  CHECK(lateral_force(passive, Rational(1), {1, -1, -1}) == 0);
  // two links, elastic base: all rows of (29) hold with the force from the first
  const Chain<Rational> elastic({1, 1}, {1, 1});
  const std::vector<Rational> q{1, -2};
  const Rational F = energy_factor(elastic, q);
  CHECK(F == Rational(5, 2));
  const Rational Fy = lateral_force(elastic, F, q);
  const Matrix<Rational> M = matrix_A(elastic) * F + matrix_B(elastic);
  Vector<Rational> v(3);
  v << q[0], q[1], Fy;
  CHECK(Vector<Rational>(M * v) == Vector<Rational>(Vector<Rational>::Zero(3)));
}
