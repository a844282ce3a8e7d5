#include <doctest/doctest.h>

#include <plumbline/straight/critical_force.hpp>
#include <random>

#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::detail;

namespace {

/// Lengths and stiffnesses spread log-uniformly over so many decades.
Chain<double> graded(std::size_t n, double decades, std::mt19937& random) {
  std::uniform_real_distribution<double> exponent(-decades / 2, decades / 2);
  std::vector<double> length(n), stiffness(n);
  for (double& L : length) L = std::pow(10, exponent(random));
  for (double& k : stiffness) k = std::pow(10, exponent(random));
  return Chain<double>(length, stiffness);
}

/// Three unit links: forces 1 and 3 on a passive base, and four of them on an elastic one.
const Chain<double> four({1, 1, 1, 1}, {1, 1, 1, 1});

}  // namespace

TEST_CASE(
    "between critical forces every run counts those below, from one end, from both, and of many at once") {
  std::mt19937 random(7);
  int counted = 0;
  for (const std::size_t n : {3U, 8U, 16U, 17U, 33U, 35U, 48U, 80U}) {
    for (const double decades : {0.5, 3.0, 8.0}) {
      const auto chain = graded(n, decades, random);
      const auto forces = critical_forces(chain, n);
      const BeadString<double> string(chain);
      REQUIRE(string.in_range());
      REQUIRE(string.pieces().size() == 1);
      const auto piece = string.pieces()[0];
      for (std::size_t below = 0; below < n; ++below) {
        const double low = below > 0 ? forces[below - 1] : forces[0] / 100,
                     high = below + 1 < n ? forces[below] : 100 * forces[n - 2];
        if (high < 1.001 * low) continue;  // so close a pair no rounded run need tell apart
        const double F = std::sqrt(low * high);
        CAPTURE(n);
        CAPTURE(F);
        CHECK(detail::count_below(piece, F) == below);
        CHECK(sweep<3>(piece, F).below == below);
        CHECK(sweep_from_both_ends<4>(piece, F).below == below);
        ++counted;
      }
    }
  }
  CHECK(counted > 500);
}

TEST_CASE("a critical force is not below itself, whatever the sign before it") {
  // three unit links on a passive base: 1 and 3
  const Chain<Rational> chain({1, 1, 1}, {0, 1, 1});
  const BeadString<Rational> string(chain);
  const auto piece = string.pieces()[0];
  const std::size_t below[] = {0, 0, 1, 1, 2};
  for (int F = 0; F < 5; ++F) CHECK(detail::count_below(piece, Rational(F)) == below[F]);
}

TEST_CASE("whether a long string keeps within the range of its type is asked of every bead") {
  for (const std::size_t at : {0U, 2U, 9U, 17U, 30U, 39U}) {
    std::vector<double> length(40, 1), stiffness(40, 1);
    CHECK(BeadString<double>(Chain<double>(length, stiffness)).in_range());
    CAPTURE(at);
    auto short_link = length, soft_joint = stiffness, stiff_joint = stiffness;
    short_link[at] = 1e-60;
    soft_joint[at] = 1e-60;
    stiff_joint[at] = 1e60;
    CHECK_FALSE(BeadString<double>(Chain<double>(short_link, stiffness)).in_range());
    CHECK_FALSE(BeadString<double>(Chain<double>(length, soft_joint)).in_range());
    CHECK_FALSE(BeadString<double>(Chain<double>(length, stiff_joint)).in_range());
    // an eighth of the exponents, 2^128, is as far as a bead may go
    soft_joint[at] = 1e-30;
    CHECK(BeadString<double>(Chain<double>(length, soft_joint)).in_range());
  }
}

TEST_CASE("a passive joint has no spacing that could leave the range of the type") {
  // with few links a joint is alone in its lane
  for (const std::size_t n : {2U, 9U, 10U, 16U, 17U, 40U}) {
    for (std::size_t at = 0; at < n; ++at) {
      CAPTURE(n);
      CAPTURE(at);
      std::vector<double> stiffness(n, 1);
      stiffness[at] = 0;
      CHECK(BeadString<double>(Chain<double>(std::vector<double>(n, 1), stiffness)).in_range());
    }
  }
}

TEST_CASE("both ends give the function that one end gives, but for a factor") {
  std::mt19937 random(8);
  for (const std::size_t n : {5U, 6U, 33U, 34U}) {
    const auto chain = graded(n, 2, random);
    const BeadString<double> string(chain);
    const auto piece = string.pieces()[0];
    const double F = 0.9 * critical_forces(chain, 1)[0];
    const auto one = sweep<4>(piece, F), both = sweep_from_both_ends<4>(piece, F);
    // Taylor coefficients in the relative change of F; 2 n roundings, some of them cancelling near a root
    for (std::size_t t = 1; t <= 4; ++t)
      CHECK(both.f[t] / both.f[0] == close_to(one.f[t] / one.f[0]).epsilon(1e-11));
  }
}

TEST_CASE("a run stays in the range of the type, however far above all forces it is") {
  for (const std::size_t n : {2U, 16U, 17U, 200U, 3000U}) {
    const Chain<double> chain(std::vector<double>(n, 1.0), std::vector<double>(n, 1.0));
    for (const double F : {1e3, 1e7, 1e30, 1e100}) {
      CAPTURE(n);
      CAPTURE(F);
      CHECK(plumbline::count_below(chain, F) == n - 1);
      const BeadString<double> string(chain);
      const auto run = sweep<3>(string.pieces()[0], F);
      CHECK(run.below == n - 1);
      for (const double f : run.f) CHECK(std::isfinite(f));
      CHECK(run.f[0] != 0);
    }
  }
}

TEST_CASE("the lowest root is found from beside it, and no other one from beside that") {
  std::mt19937 random(9);
  for (const std::size_t n : {6U, 20U}) {
    const auto chain = graded(n, 1, random);
    const auto forces = critical_forces(chain, n);
    const BeadString<double> string(chain);
    const auto piece = string.pieces()[0];
    const auto run = [&](double F) { return sweep<3>(piece, F); };
    const auto degree = static_cast<double>(piece.size());
    CHECK(lowest_root(run, 0.999 * forces[0], degree, 1e-16) == close_to(forces[0]).epsilon(1e-13));
    for (std::size_t m = 1; m < 4; ++m) {
      CAPTURE(m);
      for (const double beside : {1 - 1e-6, 1 + 1e-6}) {
        if (m == 1 && beside < 1) continue;  // one force is below: as it is just above the lowest
        const double found = lowest_root(run, beside * forces[m], degree, 1e-16);
        CHECK((std::isnan(found) || found == close_to(forces[0]).epsilon(1e-13)));
      }
    }
  }
}

TEST_CASE("where the quick way to the lowest force does not settle, the bracket finds the same") {
  std::mt19937 random(10);
  for (const std::size_t n : {2U, 3U, 12U, 33U, 90U}) {
    const auto chain = graded(n, 3, random);
    const BeadString<double> string(chain);
    const auto piece = string.pieces()[0];
    // nothing is exact enough for no error at all
    CHECK(lowest_force(piece, 0.0) == close_to(lowest_force(piece)).epsilon(1e-13));
  }
}

TEST_CASE("a bracket is split by a count that rounding has spoilt without gaining or losing a root") {
  const Bracket<double> bracket{1, 100, 2, 5, 10};
  for (const auto& [found, between] : {std::pair<std::size_t, std::size_t>{0, 2}, {3, 3}, {4, 4}, {9, 5}}) {
    const auto parts = split(bracket, Sweep<double, 3>{{1, 1, 1, 1}, found}, 6);
    CHECK(parts[0].below == 2);
    CHECK(parts[0].up_to == between);
    CHECK(parts[1].below == between);
    CHECK(parts[1].up_to == 5);
    CHECK(parts[0].low == 1);
    CHECK(parts[1].high == 100);
  }
}

TEST_CASE("a root is refined from near it; from near another one nothing comes of it") {
  const auto forces = critical_forces(four, 3);
  const auto exact = convert<Mpfr50>(four, [](double x) { return Mpfr50(x); });
  const BeadString<Mpfr50> string(exact);
  const auto piece = string.pieces()[0];
  const auto expected = critical_forces(exact, 3);
  for (std::size_t m = 0; m < 3; ++m) {
    const auto root = refined(piece, m, Mpfr50(forces[m]));
    REQUIRE(root);
    CHECK(abs(*root / expected[m] - 1) < Mpfr50("1e-48"));
  }
  for (const double beside : {1 - 1e-9, 1 + 1e-9}) {
    CHECK_FALSE(refined(piece, 0, Mpfr50(beside * forces[2])));
    CHECK_FALSE(refined(piece, 2, Mpfr50(beside * forces[0])));
  }
}

TEST_CASE("what a type with fewer digits cannot hold is not rounded to nothing or to infinity") {
  const auto narrow = [](const char* length, const char* stiffness) {
    return narrowed<double>(Chain<Mpfr50>({1, Mpfr50(length)}, {1, Mpfr50(stiffness)}));
  };
  CHECK(narrow("1", "0"));  // a passive joint stays one
  CHECK(narrow("0.1", "3")->length()[1] == 0.1);
  CHECK_FALSE(narrow("1e-400", "1"));
  CHECK_FALSE(narrow("1", "1e-400"));
  CHECK_FALSE(narrow("1e400", "1"));
  CHECK_FALSE(narrow("1", "1e400"));
  CHECK(force_in_double(2.5L) == 2.5);
  for (const long double outside : {1e-400L, 1e-310L, 1e400L, 0.0L})
    CHECK_THROWS_AS(force_in_double(outside), Error);
}

TEST_CASE(
    "a step of the inverse series leaves no more of a root than it says, and says so where it is near "
    "alone") {
  // Taylor coefficients of (1 + t / d_1) (1 + t / d_2) (1 + t / d_3) (1 - t / a), t the relative change of x
  const auto steps = [](const std::vector<double>& others, long double a) {
    std::array<long double, 5> f{1, 0, 0, 0, 0};
    const auto times = [&f](long double slope) {
      for (std::size_t k = 4; k > 0; --k) f[k] += slope * f[k - 1];
    };
    for (const double d : others) times(1 / static_cast<long double>(d));
    times(-1 / a);
    return std::pair{series_step(std::array<long double, 4>{f[0], f[1], f[2], f[3]}), series_step(f)};
  };
  for (const std::vector<double>& others : std::vector<std::vector<double>>{
           {0.5, 0.7, -2}, {-0.5, -0.7, -2}, {0.3, -0.4, 1}, {3, 5, 7}, {-0.2, 0.2, 9}, {0.1, 0.11, 0.12}}) {
    CAPTURE(others[0]);
    double m = 1, sum = 0, squares = 0;  // m^2 is the largest of (sum 1 / d)^2, sum 1 / d^2 and 1
    for (const double d : others) sum += 1 / d, squares += 1 / (d * d);
    m = std::sqrt(std::max({sum * sum, squares, 1.0}));
    for (const double distance : {1e-2, -1e-2, 1e-3, -1e-3}) {
      const double size = distance / m;
      const auto [three, four] = steps(others, size);
      CAPTURE(distance);
      // the bound of the step itself, and the next terms of the inverse series: 11 m^3 a^4 and 45 m^4 a^5
      const auto left = [&](const auto& step) { return std::abs(static_cast<double>(step.size / size - 1)); };
      CHECK(left(three) < 11 * std::abs(distance * distance * distance));
      CHECK(left(four) < 45 * std::pow(distance, 4));
      // what is said of them: not less, and not far more
      const auto told = [](const auto& step) {
        return std::sqrt(static_cast<double>(step.left * step.left * step.factor));
      };
      CHECK(told(three) * 4 > std::abs(size) * left(three));
      CHECK(told(four) * 4 > std::abs(size) * left(four));
      CHECK(told(three) == close_to(16 * std::abs(std::pow(distance, 4)) / m).epsilon(0.1));
      CHECK(told(four) == close_to(64 * std::abs(std::pow(distance, 5)) / m).epsilon(0.1));
      CHECK(static_cast<double>(three.nearness) == close_to(distance * distance).epsilon(0.1));
      CHECK(three.close_by());
      CHECK(three.settles(2 * told(three)));
      CHECK_FALSE(three.settles(told(three) / 2));
      CHECK(four.settles(2 * told(four)));
      CHECK_FALSE(four.settles(told(four) / 2));
    }
    CHECK_FALSE(steps(others, 0.2 / m).first.close_by());
  }
}

TEST_CASE("Laguerre's step reaches a root of one bead, and from between two roots neither is passed") {
  // f = (x - 1) (x - 3) with coefficients in t, x (1 + t): f_1 = x f', f_2 = x^2 f'' / 2
  const auto at = [](double x) {
    return std::array<double, 4>{(x - 1) * (x - 3), x * (2 * x - 4), x * x, 0};
  };
  // N = 2: the polynomial is a quadratic, and the step is exact to rounding
  CHECK(0.5 * (1 + laguerre_step(at(0.5), 2, true)) == close_to(1).epsilon(1e-15));
  CHECK(2.5 * (1 + laguerre_step(at(2.5), 2, true)) == close_to(3).epsilon(1e-15));
  CHECK(2.5 * (1 + laguerre_step(at(2.5), 2, false)) == close_to(1).epsilon(1e-15));
  CHECK(4.0 * (1 + laguerre_step(at(4), 2, false)) == close_to(3).epsilon(1e-15));
  for (const double x : {1.2, 2.0, 2.8}) {
    const double up = x * (1 + laguerre_step(at(x), 5, true)),
                 down = x * (1 + laguerre_step(at(x), 5, false));
    CHECK((x < up && up < 3));
    CHECK((1 < down && down < x));
  }
}

TEST_CASE(
    "a bracket of one root is one, whichever that is; it is halved in the measure of a graded spectrum") {
  Bracket<double> bracket{1, 100, 2, 3, 50};
  CHECK(bracket.single());
  bracket.up_to = 4;
  CHECK_FALSE(bracket.single());
  bracket.below = 4;
  CHECK_FALSE(bracket.single());
  bracket.last = 0.25;
  CHECK(bracket.halve());
  CHECK(bracket.next == 10);
  CHECK(bracket.last == 1);
  bracket.high = std::nextafter(1, 2);  // no number lies between
  CHECK_FALSE(bracket.halve());
}

TEST_CASE(
    "all roots of a string lie in the bracket that is begun with, and it is not far wider than they are") {
  std::mt19937 random(11);
  for (const std::size_t n : {2U, 3U, 10U, 40U}) {
    for (const std::size_t passive : {n, std::size_t{0}, n / 2, n - 1}) {
      auto chain = graded(n, 2, random);
      auto stiffness = chain.stiffness();
      if (passive < n) stiffness[passive] = 0;
      chain = Chain<double>(chain.length(), stiffness);
      const BeadString<double> string(chain);
      for (const auto& piece : string.pieces()) {
        const auto all = all_of(piece);
        CHECK(all.below == 0);
        CHECK(all.up_to == piece.size());
        CHECK(detail::count_below(piece, all.low) == 0);
        CHECK(detail::count_below(piece, all.high) == piece.size());
        // the bounds are taken twice, and each holds within as much as there are beads
        const auto forces = roots_by_brackets(piece, piece.size());
        CHECK(all.high <= 4.001 * static_cast<double>(piece.size()) * forces.back());
        CHECK(all.high >= 2 * forces.back());
        CHECK(1.999 * all.low <= forces.front());  // of one bead they are equal, to rounding
        CHECK(all.next == close_to(std::sqrt(all.low * all.high)).epsilon(1e-15));
      }
    }
  }
}

TEST_CASE("a string in long double is asked of its range as well, by the exponents of that") {
  const long double far = std::ldexp(1.0L, 2040), near = std::ldexp(1.0L, 1800);
  const std::vector<long double> ones(4, 1);
  CHECK(BeadString<long double>(Chain<long double>(ones, ones)).in_range());
  for (const std::size_t at : {0U, 1U, 3U}) {
    CAPTURE(at);
    for (const long double by : {near, 1 / near}) {
      auto stiffness = ones;
      stiffness[at] = by;
      CHECK(BeadString<long double>(Chain<long double>(ones, stiffness)).in_range());
    }
    for (const long double by : {far * 65536, 1 / (far * 65536)}) {
      auto stiffness = ones;
      stiffness[at] = by;
      CHECK_FALSE(BeadString<long double>(Chain<long double>(ones, stiffness)).in_range());
    }
  }
  auto length = ones;
  length[1] = 1 / (far * 65536);
  CHECK_FALSE(BeadString<long double>(Chain<long double>(length, ones)).in_range());
  auto passive = ones;
  passive[0] = 0;
  CHECK(BeadString<long double>(Chain<long double>(ones, passive)).in_range());
}

TEST_CASE("what masses and spacings are both made from is asked of its range, in the lanes too") {
  // links 2^-126 with springs k: a spacing z^2 / k and a mass may be in range where z_i z_{i+1} k is not
  for (const std::size_t at : {2U, 17U, 38U}) {
    CAPTURE(at);
    std::vector<double> length(40, 0x1p-126), stiffness(40, 0x1p-200);
    CHECK(BeadString<double>(Chain<double>(length, stiffness)).in_range());
    stiffness[at] = 0x1p-362;  // z z k is below 2^-500 then, and z^2 / k at most 40^2 2^110
    CHECK_FALSE(BeadString<double>(Chain<double>(length, stiffness)).in_range());
  }
}
