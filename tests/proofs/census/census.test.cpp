#include "proofs/census/census.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cstdlib>
#include <optional>
#include <plumbline/base/error.hpp>
#include <plumbline/loaded/nominal_model.hpp>
#include <random>

#include "proofs/census/equilibrium_box.hpp"
#include "proofs/exact/as_double.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

Interval decimal(long long digits, long long unit) {
  return Interval(Rational(digits, unit));
}

Chain<Interval> unit_chain(const std::vector<Interval>& rest, const std::vector<Interval>& stiffness = {}) {
  const std::vector<Interval> ones(rest.size(), Interval(1));
  return Chain<Interval>(ones, stiffness.empty() ? ones : stiffness, rest);
}

/// Sum of (-1)^negative directions.
int morse_count(const Census& census) {
  int sum = 0;
  for (const auto& one : census.equilibria) sum += one.negative_directions.value() % 2 == 0 ? 1 : -1;
  return sum;
}

std::vector<Rational> random_decimals(std::mt19937& random, std::size_t count, int low, int high) {
  std::uniform_int_distribution<int> thousandths(low, high);
  std::vector<Rational> values;
  for (std::size_t i = 0; i < count; ++i) values.emplace_back(thousandths(random), 1000);
  return values;
}

std::vector<Interval> enclosed(const std::vector<Rational>& values) {
  return {values.begin(), values.end()};
}

Chain<double> rounded(const Chain<Interval>& chain) {
  return convert<double>(chain, as_double);
}

/// Whether an equilibrium that floating point found is among the certified ones, up to full turns.
bool listed(const Census& census, const Equilibrium<double>& found) {
  return std::any_of(
      census.equilibria.begin(), census.equilibria.end(), [&](const CertifiedEquilibrium& one) {
        double theta = 0;
        for (std::size_t j = 0; j < one.q.size(); ++j) {
          theta += as_double(one.q[j]);
          if (std::abs(std::remainder(theta - found.theta(static_cast<Eigen::Index>(j)), 2 * M_PI)) > 1e-6)
            return false;
        }
        return true;
      });
}

/// Every joint deflects by at most half a turn: the energy of a shape is then the least over all turns.
Window around_rest(const Chain<Interval>& chain) {
  Window window;
  for (const Interval& rest : chain.rest())
    window.push_back(hull(rest - Interval::pi(), rest + Interval::pi()));
  return window;
}

bool has(std::size_t set, std::size_t i) {
  return ((set >> i) & 1U) != 0;
}

/// The chain with some joints locked half a turn from rest, as a shorter chain, and the end point that
/// remains.
std::pair<Chain<Interval>, Point<Interval>> locked(const Chain<Interval>& chain, Point<Interval> place,
                                                   std::size_t set) {
  const Interval pi(Interval::End("3.14159265358979323846264338327950288419716939937510582097494459"),
                    Interval::End("3.14159265358979323846264338327950288419716939937510582097494460"));
  std::vector<Interval> length, stiffness, rest;
  Interval carried(0);  // direction of the last link against that of the merged link it belongs to
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Interval& L = chain.length()[i];
    if (!has(set, i)) {
      length.push_back(L);
      stiffness.push_back(chain.stiffness()[i]);
      rest.push_back(chain.rest()[i] + carried);
      carried = Interval(0);
      continue;
    }
    carried = carried + chain.rest()[i] + pi;
    if (length.empty()) {  // fixed to the base: the chain starts at its end
      place.x = place.x - L * cos(carried);
      place.y = place.y - L * sin(carried);
      continue;
    }
    const Interval x = length.back() + L * cos(carried), y = L * sin(carried);
    const Mpfr50 turn = atan2(Mpfr50(y.middle()), Mpfr50(x.middle())), slack("1e-47");
    const Interval off{Interval::End(turn - slack), Interval::End(turn + slack)};
    length.back() = sqrt(sqr(x) + sqr(y));
    rest.back() = rest.back() + off;
    carried = carried - off;
  }
  return {Chain<Interval>(length, stiffness, rest), place};
}

/// Whether the moments at the locked joints lie within ± k pi: the equilibrium of the shorter chain is
/// critical for the energy of the whole one.
bool critical_for_the_whole(const Chain<Interval>& chain, std::size_t set, const Chain<Interval>& shorter,
                            const Point<Interval>& place, const CertifiedEquilibrium& one) {
  double theta = 0, x = as_double(place.x), y = as_double(place.y);
  bool within = true;
  for (std::size_t i = 0, free = 0; i < chain.size(); ++i) {
    theta += as_double(chain.rest()[i]);
    if (has(set, i)) {
      theta += M_PI;
      const double moment = x * as_double(one.fy) - y * as_double(one.fx);
      within = within && std::abs(moment) < as_double(chain.stiffness()[i]) * M_PI;
    } else {
      theta += as_double(one.q[free]) - as_double(shorter.rest()[free]);
      ++free;
    }
    x -= as_double(chain.length()[i]) * std::cos(theta);
    y -= as_double(chain.length()[i]) * std::sin(theta);
  }
  CHECK(std::abs(x) + std::abs(y) < 1e-9);  // the whole chain closes
  return within;
}

/// The sum over all faces of (-1)^(index on the face + number of locked joints).
int sum_over_faces(const Chain<Interval>& chain, const Point<Interval>& place) {
  int sum = 0;
  for (std::size_t set = 0; set < (std::size_t{1} << chain.size()); ++set) {
    const auto locks = static_cast<std::size_t>(std::popcount(set));
    if (chain.size() < locks + 2) continue;  // fewer than two free joints close no chain, but by accident
    const auto [shorter, end] = locked(chain, place, set);
    Census census;
    try {
      census = census_at_end_point(shorter, end, around_rest(shorter));
    } catch (const Error& error) {
      const std::string why = error.what();
      CAPTURE(why);
      REQUIRE(why.find("reach from the base") != std::string::npos);
      continue;  // out of reach: the face is empty
    }
    REQUIRE(census.complete());
    for (const auto& one : census.equilibria) {
      if (critical_for_the_whole(chain, set, shorter, place, one))
        sum += (one.negative_directions.value() + locks) % 2 == 0 ? 1 : -1;
    }
  }
  return sum;
}

/// Random shapes from which Newton's method is started; how many distinct equilibria it finds, each of which
/// the census has to list.
std::size_t newton_finds(const Census& census, const Chain<Interval>& chain, Control control,
                         const Point<Interval>& load, std::size_t starts, std::mt19937& random) {
  const NominalModel<double> model(rounded(chain));
  EquilibriumSolver<NominalModel<double>> solver(model);
  const Point<double> at{as_double(load.x), as_double(load.y)};
  std::uniform_real_distribution<double> turn(-M_PI, M_PI);
  std::vector<Equilibrium<double>> found;
  for (std::size_t start = 0; start < starts; ++start) {
    std::vector<double> q = model.chain().rest();
    for (double& angle : q) angle += turn(random);
    try {
      const auto theta = absolute_angles(q);
      auto one = control == Control::force ? solver.under_force(at, theta) : solver.at_end_point(at, theta);
      const auto angles = joint_angles(one.theta);
      bool counted = true;
      for (std::size_t i = 0; i < q.size() && control == Control::end_point; ++i)
        counted = counted && std::abs(angles[i] - model.chain().rest()[i]) < M_PI;
      const bool known = std::any_of(found.begin(), found.end(), [&](const Equilibrium<double>& other) {
        return (other.theta - one.theta).cwiseAbs().maxCoeff() < 1e-6;
      });
      if (counted && !known) found.push_back(std::move(one));
    } catch (const Error&) {  // this start leads to no equilibrium
    }
  }
  for (const auto& one : found) CHECK(listed(census, one));
  return found.size();
}

}  // namespace

TEST_CASE(
    "random chains: the census lists whatever Newton's method finds, and its count with signs is right") {
  // PLUMBLINE_CENSUS_CHAINS=100 asks for so many chains of two to six links and 10^4 starts each
  const char* const asked = std::getenv("PLUMBLINE_CENSUS_CHAINS");
  const std::size_t chains = asked != nullptr ? std::stoul(asked) : 6,
                    starts = asked != nullptr ? 10000 : 500, longest = asked != nullptr ? 6 : 4;
  std::size_t listed_in_all = 0, found_in_all = 0, faces = 0, given_up = 0;
  for (std::size_t i = 0; i < chains; ++i) {
    std::mt19937 random(static_cast<unsigned>(29 + i));
    const std::size_t n = 2 + i % (longest - 1);
    const auto length = random_decimals(random, n, 600, 1500);
    const Chain<Interval> chain(enclosed(length), enclosed(random_decimals(random, n, 500, 2000)),
                                enclosed(random_decimals(random, n, -900, 900)));
    Rational sum = 0;
    for (const Rational& L : length) sum += L;
    const Rational share = random_decimals(random, 1, 400, 900)[0];
    const Point<Interval> place{Interval(Rational(sum * share)), Interval(Rational(sum * share / 7))};
    const Point<Interval> force{Interval(Rational(-700, 1000)),
                                Interval(random_decimals(random, 1, 50, 400)[0])};
    CAPTURE(i);
    CAPTURE(n);
    // Where the end point is close to that of a folded chain the force is hardly bounded, and the census says
    // that it has come to its limit.
    std::optional<Census> at_place;
    try {
      at_place = census_at_end_point(chain, place, around_rest(chain));
    } catch (const Error& error) {
      MESSAGE("chain ", i, " of ", n, " links: ", std::string(error.what()));
      ++given_up;
      continue;
    }
    const Census& held = *at_place;
    const Census loaded = census_under_force(chain, force);
    REQUIRE(held.complete());
    REQUIRE(loaded.complete());
    CHECK(morse_count(loaded) == 1);
    if (n <= 4) {
      std::vector<double> sides{std::hypot(as_double(place.x), as_double(place.y))};
      for (const auto& L : chain.length()) sides.push_back(as_double(L));
      CHECK(sum_over_faces(chain, place) == euler_characteristic_of_polygons(sides));
      ++faces;
    }
    listed_in_all += held.equilibria.size() + loaded.equilibria.size();
    found_in_all += newton_finds(held, chain, Control::end_point, place, starts, random) +
                    newton_finds(loaded, chain, Control::force, force, starts, random);
  }
  CHECK(found_in_all <= listed_in_all);
  CHECK(given_up * 50 <= chains);
  MESSAGE(chains, " chains, ", starts, " starts each and load: the censuses list ", listed_in_all,
          " equilibria, Newton's method finds ", found_in_all, "; polygon spaces compared: ", faces);
}

TEST_CASE("exactly at a bifurcation the census says undecided, where it is, and nothing false") {
  // two unit links, k = (3/2, 1): the straight chain under a dead force has the stiffness matrix ((5/2, -1),
  // (-1, 1)) less F, so its critical forces are exactly 1/2 and 3
  const auto chain = unit_chain({Interval(0), Interval(0)}, {Interval(Rational(3, 2)), Interval(1)});
  const auto under = [&](const Rational& F) {
    return census_under_force(chain, {Interval(-F), Interval(0)});
  };
  const Census at = under(Rational(1, 2)), below = under(Rational(49, 100)), above = under(Rational(51, 100));
  REQUIRE(below.complete());
  REQUIRE(above.complete());
  CHECK(below.equilibria.size() == 1);
  CHECK(above.equilibria.size() == 3);
  REQUIRE(at.undecided.size() == 1);
  for (const Interval& q : at.undecided[0]) {
    CHECK(q.contains_zero());
    CHECK(q.width() < Interval::End("0.1"));
  }
  CHECK(at.equilibria.empty());
}

TEST_CASE("a place left undecided is told by its joint angles, turned with all of the chain") {
  // the same at k = (3, 2), where the critical forces are 1 and 6, with the base and the force turned by 1/2:
  // straight from the base on, the chain is at its first bifurcation
  const Interval turn(Rational(1, 2));
  const auto chain = unit_chain({turn, Interval(0)}, {Interval(3), Interval(2)});
  const Census at = census_under_force(chain, {-cos(turn), -sin(turn)});
  CHECK(at.equilibria.empty());
  REQUIRE(at.undecided.size() == 1);
  const auto& q = at.undecided[0];
  REQUIRE(q.size() == 2);
  CHECK(q[0].contains(Rational(1, 2)));
  CHECK(q[1].contains_zero());
  for (const Interval& angle : q) CHECK(angle.width() < Interval::End("0.1"));
  CHECK_FALSE(at.balanced);  // what is left open counts for nothing
}

TEST_CASE("at two folds at once both places are left undecided, each by itself") {
  // One link pulled by F has q + F sin q = 0; besides q = 0 two equilibria meet at each of ±q where tan q = q
  // and F = -1 / cos q. Both numbers to thirty digits: what is left of either equation is far below the
  // square of the smallest box, 1e-12, so that neither fold can be told from none.
  const Rational q = Rational("449340945790906417530788092728") / mp::pow(Integer(10), 29);
  const Interval force = -Interval(1) / cos(Interval(q));
  const Census at = census_under_force(unit_chain({Interval(0)}), {force, Interval(0)});
  REQUIRE(at.equilibria.size() == 1);
  CHECK(at.equilibria[0].q[0].contains_zero());
  REQUIRE(at.undecided.size() == 2);
  for (const auto& place : at.undecided) {
    REQUIRE(place.size() == 1);
    CHECK((place[0].contains(q) || place[0].contains(-q)));
    CHECK(place[0].width() < Interval::End("0.1"));
  }
  CHECK(!intersection(at.undecided[0][0], at.undecided[1][0]));
}

TEST_CASE(
    "the census of the paper's Z-chain at 0.4 L has the equilibria that floating point finds, and no other") {
  const auto chain =
      unit_chain({decimal(-2417, 10000), decimal(6821, 10000), decimal(-7958, 10000), decimal(517, 1000)});
  const Census census = census_at_end_point(chain, {decimal(34, 10), Interval(0)}, around_rest(chain));
  REQUIRE(census.complete());
  CHECK(morse_count(census) ==
        euler_characteristic_of_polygons({1, 1, 1, 1, 3.4}));  // no joint near half a turn: a sphere, 2
  CHECK(euler_characteristic_of_polygons({1, 1, 1, 1, 3.4}) == 2);
  const NominalModel<double> model(rounded(chain));
  EquilibriumSolver<NominalModel<double>> solver(model);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-3, 3);
  int found = 0;
  for (int start = 0; start < 2000; ++start) {
    Eigen::VectorXd theta(4);
    for (auto& t : theta) t = angle(random);
    try {
      const auto at = solver.at_end_point({3.4, 0}, theta);
      const auto q = joint_angles(at.theta);
      bool counted = true;
      for (std::size_t i = 0; i < 4; ++i) counted &= std::abs(q[i] - model.chain().rest()[i]) < M_PI;
      if (!counted) continue;
      ++found;
      CHECK(listed(census, at));
    } catch (const Error&) {
    }
  }
  CHECK(found > 200);
  for (const auto& one : census.equilibria) {
    CHECK(one.energy.width() < Interval::End("1e-40"));
    CHECK(one.q[0].width() < Interval::End("1e-40"));
  }
  // the lowest is the one that the slowly loaded chain reaches
  CHECK(census.equilibria[0].negative_directions == 0);
}

TEST_CASE("under an imposed force the count of equilibria with signs is 1, with a passive base 0") {
  // the total potential grows beyond bounds in every direction of R^n, whose Euler characteristic is 1; a
  // passive base makes the space a circle times R^(n-1), whose characteristic is 0
  std::mt19937 random(11);
  for (std::size_t n = 1; n <= 5; ++n) {
    for (int trial = 0; trial < 3; ++trial) {
      auto stiffness = random_decimals(random, n, 300, 3000);
      const auto rest = random_decimals(random, n, -900, 900);
      const Point<Interval> force{Interval(Rational(-900, 1000)), Interval(Rational(310 + trial, 1000))};
      const auto census = census_under_force(unit_chain(enclosed(rest), enclosed(stiffness)), force);
      REQUIRE(census.complete());
      CHECK(morse_count(census) == 1);
      stiffness[0] = 0;
      const auto loose = census_under_force(unit_chain(enclosed(rest), enclosed(stiffness)), force);
      REQUIRE(loose.complete());
      CHECK(morse_count(loose) == 0);
    }
  }
}

TEST_CASE("with the end point held the count with signs is the Euler characteristic of the polygon space") {
  // On the space of shapes, joint angles taken up to full turns, the energy is the least of its values over
  // all turns. It is smooth but for concave ridges where some joints stand half a turn from rest. For such a
  // function the characteristic is the sum over the critical points of every face of ridges (those joints
  // locked, their moments within ± k pi) of (-1)^(index on the face + number of locked joints).
  std::mt19937 random(5);
  for (const std::size_t n : {3U, 4U}) {
    for (int trial = 0; trial < 4; ++trial) {
      const auto length = random_decimals(random, n, 600, 1500);
      const auto stiffness = random_decimals(random, n, 500, 2000);
      const auto rest = random_decimals(random, n, -900, 900);
      const Chain<Interval> chain(enclosed(length), enclosed(stiffness), enclosed(rest));
      const Point<Interval> place{Interval(Rational(1013 + 97 * trial, 1000)), Interval(Rational(307, 1000))};
      std::vector<double> sides{std::hypot(as_double(place.x), as_double(place.y))};
      for (const auto& L : chain.length()) sides.push_back(as_double(L));
      CAPTURE(n);
      CAPTURE(trial);
      CHECK(sum_over_faces(chain, place) == euler_characteristic_of_polygons(sides));
    }
  }
}

TEST_CASE("at a bifurcation the census says undecided, and is decided on both sides") {
  // the symmetric zigzag of three links with a passive base: rest (0, a, -a), a = 1; it buckles on the x axis
  const auto chain =
      unit_chain({Interval(0), Interval(1), Interval(-1)}, {Interval(0), Interval(1), Interval(1)});
  const NominalModel<double> model(rounded(chain));
  const auto count = [&](const Rational& x) {
    return census_at_end_point(chain, {Interval(x), Interval(0)});
  };
  const auto high = count(Rational(26, 10)), low = count(Rational(14, 10));
  REQUIRE(high.complete());
  REQUIRE(low.complete());
  // a one-dimensional space of shapes, circles: as many minima as maxima, ridges among the maxima
  CHECK(high.equilibria.size() != low.equilibria.size());
}

TEST_CASE("what cannot be counted is refused") {
  const auto chain = unit_chain({Interval(0), decimal(1, 10), decimal(2, 10)});
  CHECK_THROWS_AS(census_at_end_point(chain, {Interval(3), Interval(0)}), Error);   // stretched
  CHECK_THROWS_AS(census_at_end_point(chain, {Interval(4), Interval(0)}), Error);   // out of reach
  CHECK_THROWS_AS(census_at_end_point(chain, {Interval(0), Interval(-1)}), Error);  // folded into one line
  const Interval perhaps = hull(Interval(0), Interval(1));
  CHECK_THROWS_WITH_AS(
      EquilibriumBox(unit_chain({Interval(0), Interval(0)}, {Interval(1), perhaps}), Control::force, {0, 0},
                     {}),
      "census: found a stiffness that may or may not be zero, expected a passive or an elastic joint", Error);
  CensusLimits few;
  few.boxes = 10;
  CHECK_THROWS_WITH_AS(census_under_force(chain, {Interval(-3), Interval(1)}, few),
                       "census: found 10 boxes without an end, expected a search that fits the limit", Error);
}

TEST_CASE("fast spans enclose what fifty digits say") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-20, 20), small(0, 4);
  for (int trial = 0; trial < 2000; ++trial) {
    const double low = any(random), high = low + small(random), t = low + (high - low) * 0.37;
    const Circle c = circle(Span(low, high));
    const Mpfr50 cosine = cos(Mpfr50(t)), sine = sin(Mpfr50(t));
    CHECK(Mpfr50(c.cosine.low) <= cosine);
    CHECK(cosine <= Mpfr50(c.cosine.high));
    CHECK(Mpfr50(c.sine.low) <= sine);
    CHECK(sine <= Mpfr50(c.sine.high));
    const Span a(low), b(high), product = a * b, sum = a + b, quotient = a / b;
    CHECK(Mpfr50(product.low) < Mpfr50(low) * Mpfr50(high));
    CHECK(Mpfr50(product.high) > Mpfr50(low) * Mpfr50(high));
    CHECK(Mpfr50(sum.low) < Mpfr50(low) + Mpfr50(high));
    CHECK(Mpfr50(quotient.low) < Mpfr50(low) / Mpfr50(high));
    CHECK(Mpfr50(quotient.high) > Mpfr50(low) / Mpfr50(high));
  }
}
