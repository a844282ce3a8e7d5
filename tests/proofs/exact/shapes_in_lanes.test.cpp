#include "proofs/exact/shapes_in_lanes.hpp"

#include <numeric>
#include <plumbline/straight/buckling_mode.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exactly.hpp"
#include "proofs/exact/working_precision.hpp"
#include "tests/proofs/random_chain.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

Mpfr largest_angle(const Mode<Mpfr>& mode) {
  Mpfr largest = 0;
  for (const Mpfr& angle : mode.q) largest = std::max(largest, Mpfr(abs(angle)));
  return largest;
}

/// The angles of a mode in a hundred digits as ShapeInLanes has them: the largest 1, the first one positive.
std::vector<double> in_doubles(const Mode<Mpfr>& mode) {
  const Mpfr largest = largest_angle(mode);
  std::vector<double> q;
  for (const Mpfr& angle : mode.q) q.push_back(static_cast<double>(Mpfr(angle / largest)));
  return q;
}

/// What balances the moment at the base of a straight chain, at the angles of ShapeInLanes.
Rational lateral_force(const Chain<Rational>& chain, const Mode<Mpfr>& mode) {
  const Rational length = std::accumulate(chain.length().begin(), chain.length().end(), Rational(0));
  return -chain.stiffness()[0] / length * Rational(Mpfr(mode.q[0] / largest_angle(mode)));
}

/// How many shapes lanes leave open; the others are the nearest doubles.
std::size_t left_open(const Chain<Rational>& chain) {
  const auto forces = forces_in_lanes(chain, chain.size());
  const auto shapes = shapes_in_lanes(chain, forces);
  const WorkingPrecision precision(100);
  const auto modes = critical_modes(from_rational<Mpfr>(chain), chain.size());
  std::size_t open = 0;
  for (std::size_t m = 0; m < shapes.size(); ++m) {
    open += shapes[m] ? 0 : 1;
    if (!shapes[m]) continue;
    CHECK(shapes[m]->q == in_doubles(modes[m]));
    CHECK(shapes[m]->signs == sign_pattern(modes[m].q));
    CHECK(to_decimal(shapes[m]->fy, 15) == to_decimal(lateral_force(chain, modes[m]), 15));
  }
  return open;
}

}  // namespace

TEST_CASE("shapes in two doubles are the nearest doubles, for any grading and any passive joint") {
  check_property("twenty to thirty links over eight decades",
                 [] { RC_ASSERT(left_open(random_chain(Passive::any_one, 20, 30)) < 20); });
}

TEST_CASE(
    "shapes of an ordinary long chain are not left open, nor where they decay beyond the range of double") {
  std::vector<Rational> length, stiffness;
  for (int i = 0; i < 200; ++i) {
    length.emplace_back(100 + i * 7919 % 300, 100);
    stiffness.emplace_back(100 + i * 104729 % 307, 100);
  }
  CHECK(left_open(Chain<Rational>(length, stiffness)) == 0);
  stiffness[3] =
      100000;  // a stiff joint among soft ones: its mode falls by about its ratio from link to link
  CHECK(left_open(Chain<Rational>(length, stiffness)) == 0);
}

TEST_CASE("a joint that does not turn is left to more digits") {
  // ten equal links on a passive base, mirrored: joint 6 stays straight in every other mode
  std::vector<Rational> ones(10, 1), stiffness = ones;
  stiffness[0] = 0;
  CHECK(left_open(Chain<Rational>(ones, stiffness)) >= 4);
}

TEST_CASE("a lateral force half-way between two decimals is left to more digits, and one beside it is not") {
  const Chain<Rational> chain({1, 2, 1, 3, 1, 2}, {2, 1, 3, 1, 2, 1});
  const WorkingPrecision precision(100);
  const Rational own = lateral_force(chain, critical_modes(from_rational<Mpfr>(chain), 1)[0]);
  const Rational half_way = *parse_decimal("0.1234567890123455");
  // forces grow with the stiffness; in two doubles they err by 1e-26 or so
  const auto shape_at = [&](const Rational& fy) {
    std::vector<Rational> stiffness = chain.stiffness();
    for (Rational& k : stiffness) k *= abs(fy / own);
    const Chain<Rational> scaled(chain.length(), stiffness);
    return shapes_in_lanes(scaled, forces_in_lanes(scaled, 1)).at(0);
  };
  for (const char* off : {"1", "-1"}) {
    CHECK_FALSE(shape_at(half_way * (1 + *parse_decimal(off) * *parse_decimal("1e-60"))));
    CHECK_FALSE(shape_at(half_way * (1 + *parse_decimal(off) * *parse_decimal("1e-30"))));
    const auto beside = shape_at(half_way * (1 + *parse_decimal(off) * *parse_decimal("1e-20")));
    REQUIRE(beside);
    CHECK(to_decimal(abs(beside->fy), 15) == (*off == '-' ? "0.123456789012345" : "0.123456789012346"));
  }
}

TEST_CASE("in a chain of two parts the links of the other one stay in line, and forces may be a little off") {
  std::vector<Rational> length, stiffness;
  for (int i = 0; i < 20; ++i) {
    length.emplace_back(100 + i * 7919 % 300, 100);
    stiffness.emplace_back(100 + i * 104729 % 307, 100);
  }
  stiffness[8] = 0;
  const Chain<Rational> chain(length, stiffness);
  CHECK(left_open(chain) == 0);
  const auto forces = forces_in_lanes(chain, 19);
  const auto shapes = shapes_in_lanes(chain, forces);
  auto off = forces;
  for (ForceInLanes& force : off) force.value *= 1 + Wide(1) / 1000000000000;
  const auto again = shapes_in_lanes(chain, off);
  REQUIRE(shapes.size() == 19);
  REQUIRE(again.size() == 19);
  for (std::size_t m = 0; m < 19; ++m) {
    REQUIRE(shapes[m]);
    REQUIRE(again[m]);
    CHECK(shapes[m]->q == again[m]->q);
    CHECK(to_decimal(shapes[m]->fy, 15) == to_decimal(again[m]->fy, 15));
    const bool behind = forces[m].part == 1;
    if (behind) CHECK(shapes[m]->fy == 0);
    // the passive joint turns in the modes of either part
    for (std::size_t i = 0; i < 20; ++i) CHECK((shapes[m]->q[i] == 0) == (behind ? i < 8 : i > 8));
  }
}
