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

TEST_CASE("energy factor and lateral force of any shape are the quotients that they are defined as") {
  // energy (4 + 3 * 9) / 2 over a shortening (3 * 2^2 + 1 * 5^2) / 2 of links 3 and 1 at angles 2 and 5
  const Chain<Rational> chain({3, 1}, {1, 3});
  const std::vector<Rational> q{2, 3};
  CHECK(energy_factor(chain, q) == Rational(31, 37));
  // first row of (29): k_1 q_1 - F (z_1 q_1 + z_2 q_2) + z_1 Fy = 0 with z = (4, 1): 2 - 5 * 11 + 4 Fy = 0
  CHECK(lateral_force(chain, Rational(5), q) == Rational(53, 4));
}
