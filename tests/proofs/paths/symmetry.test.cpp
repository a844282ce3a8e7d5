#include "proofs/paths/symmetry.hpp"

#include <doctest/doctest.h>

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// "reversed", "mirrored" and "both", as far as a chain is so.
std::string symmetries_of(const std::vector<Rational>& length, const std::vector<Rational>& stiffness,
                          const std::vector<Rational>& rest, Control control = Control::end_point,
                          const Point<Rational>& direction = {-1, 0}) {
  std::string words;
  for (const Symmetry& one : symmetries(Chain<Rational>(length, stiffness, rest), control, direction))
    words += one.reversed ? one.mirrored ? "both " : "reversed " : one.mirrored ? "mirrored " : "none ";
  return words;
}

}  // namespace

TEST_CASE(
    "a chain is symmetric where reading it from its end point, or in a mirror, is the same to the last "
    "digit") {
  const Rational a(1, 3), little(1, mp::pow(Integer(10), 40));
  // the base has no spring, joint i takes the place of joint n + 2 - i, and turns the other way
  CHECK(symmetries_of({1, 2, 1}, {0, 3, 3}, {5, a, -a}) == "reversed ");
  CHECK(symmetries_of({1, 2, 2, 1}, {0, 3, 4, 3}, {0, a, 0, -a}) == "reversed ");
  // but for one thing each
  CHECK(symmetries_of({1, 2, 1 + little}, {0, 3, 3}, {0, a, -a}).empty());
  CHECK(symmetries_of({1, 2, 1}, {0, 3, 3 + little}, {0, a, -a}).empty());
  CHECK(symmetries_of({1, 2, 1}, {0, 3, 3}, {0, a, -a - little}).empty());
  CHECK(symmetries_of({1, 2, 1}, {little, 3, 3}, {0, a, -a}).empty());
  CHECK(symmetries_of({1, 2, 2, 1}, {0, 3, 4, 3}, {0, a, a, -a}).empty());
  CHECK(symmetries_of({1, 2, 1}, {0, 3, 3}, {0, a, -a}, Control::force).empty());
  // of two links each is the other's place, and the joint between them its own
  CHECK(symmetries_of({2, 2}, {0, 3}, {5, 0}) == "reversed ");
  CHECK(symmetries_of({2, 2 + little}, {0, 3}, {5, 0}).empty());
  CHECK(symmetries_of({2, 2}, {0, 3}, {5, little}).empty());
  // in a mirror: straight, under a load along it
  CHECK(symmetries_of({1, 2, 3}, {4, 5, 6}, {0, 0, 0}) == "mirrored ");
  CHECK(symmetries_of({1, 2, 3}, {4, 5, 6}, {0, 0, 0}, Control::force) == "mirrored ");
  CHECK(symmetries_of({1, 2, 3}, {4, 5, 6}, {0, little, 0}).empty());
  CHECK(symmetries_of({1, 2, 3}, {4, 5, 6}, {0, 0, 0}, Control::end_point, {-1, little}).empty());
  CHECK(symmetries_of({1, 2, 1}, {0, 3, 3}, {0, 0, 0}) == "mirrored reversed both ");
  CHECK(symmetries_of({1, 2, 1}, {0, 3, 3}, {0, 0, 0}, Control::end_point, {-1, 1}) == "reversed ");
}
