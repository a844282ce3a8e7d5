#include "proofs/rod/critical_rod.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/interval.hpp>
#include <plumbline/structure/beam.hpp>

#include "proofs/exact/straight_structure.hpp"
#include "tests/close_to.hpp"
#include "tests/proofs/rod/some_rods.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// Whether the enclosure and an interval around the known value meet: both contain it.
bool encloses(const RodLoss& loss, const Interval& known) {
  return !certainly_less(known, Interval(loss.factor.low)) &&
         !certainly_less(Interval(loss.factor.high), known);
}

double value(const Rod& rod, int digits = 12) {
  return from_rational<double>(critical_rod(rod, digits).factor.low);
}

double lowest(const Structure<Rational>& chain) {
  return std::stod(StraightStructure(chain).in_decimals(1, 15, false)[0].force);
}

}  // namespace

TEST_CASE(
    "Euler's four rods, to twenty digits: 1/4, 1, 4 times pi^2, and the square of the root of tan u = u") {
  // Timoshenko and Gere, Theory of Elastic Stability, 1961, 2.1 and 2.2
  const Interval square = sqr(Interval::pi());
  CHECK(encloses(critical_rod(compressed_rod(clamped_base(), {}), 20), square / Interval(4)));
  CHECK(encloses(critical_rod(compressed_rod(pinned<Rational>(), guided<Rational>()), 20), square));
  CHECK(
      encloses(critical_rod(compressed_rod(clamped_base(), clamped<Rational>()), 20), Interval(4) * square));
  CHECK(encloses(critical_rod(compressed_rod(clamped_base(), {{}, {}, Restraint<Rational>::held()}), 20),
                 square));
  const RodLoss loss = critical_rod(compressed_rod(clamped_base(), guided<Rational>()), 20);
  CHECK(loss.factor.decimal == "20.190728556426629975");
  const auto sine_less_cosine = [](const Rational& P) {
    const Interval u = sqrt(Interval(P));
    return sin(u) - u * cos(u);
  };
  CHECK(certainly_negative(sine_less_cosine(loss.factor.low)) !=
        certainly_negative(sine_less_cosine(loss.factor.high)));
}

TEST_CASE("Greenhill's column under its own weight: zeros of Bessel functions of order -1/3") {
  // A. G. Greenhill, Proc. Cambridge Phil. Soc. 4 (1881) 65: 9/4 of the square of the first
  // zero 1.866350858873895
  const double zero = 1.866350858873895;
  CHECK(value(heavy_rod(clamped_base(), {}), 15) == close_to(9 * zero * zero / 4).epsilon(1e-14));
}

TEST_CASE("Beck's column flutters at 20.0509 E I / L^2, whatever bed it stands on") {
  // M. Beck, ZAMP 3 (1952) 225; a bed adds to all squares of frequencies alike: T. E. Smith, G. Herrmann,
  // J. Appl. Mech. 39 (1972) 628
  const RodLoss loss = critical_rod(beck_rod(), 12);
  CHECK(loss.kind == Motion::flutter);
  CHECK(loss.factor.decimal == "20.0509536190");
  Rod on_bed = beck_rod();
  on_bed.bed = 50;
  const RodLoss same = critical_rod(on_bed, 12);
  CHECK(same.kind == Motion::flutter);
  CHECK(same.factor.decimal == loss.factor.decimal);
}

TEST_CASE("a stiff support across makes Beck's column diverge" * doctest::test_suite("long")) {
  Rod rod = beck_rod();
  rod.end_point.across = Restraint<Rational>::sprung(50);
  CHECK(critical_rod(rod, 8).kind == Motion::divergence);
  rod.end_point.across = Restraint<Rational>::sprung(10);
  CHECK(critical_rod(rod, 8).kind == Motion::flutter);
}

TEST_CASE("a rod on a bed buckles in the number of half-waves that costs least") {
  // pi^2 (m^2 + b / (m^2 pi^4)), Timoshenko and Gere 2.10
  const Interval square = sqr(Interval::pi());
  for (const auto& [m, bed] :
       {std::pair(1, 100), std::pair(2, 1500), std::pair(3, 8000), std::pair(4, 20000)}) {
    Rod rod = compressed_rod(pinned<Rational>(), guided<Rational>());
    rod.bed = bed;
    const Interval waves = Interval(m * m) * square;
    CHECK(encloses(critical_rod(rod, 20), waves + Interval(bed) / waves));
  }
}

TEST_CASE("springs and beds between nothing and all") {
  const double pinned_rod = 9.869604401089358, clamped_pinned = 20.190728556426630;
  Rod turned = compressed_rod(pinned<Rational>(), guided<Rational>());
  turned.base.turn = Restraint<Rational>::sprung(Rational(1, 1000000000));
  // a small spring c adds c w'^2 / ∫ w'^2 = 2 c to first order
  CHECK(value(turned) == close_to(pinned_rod + 2e-9).epsilon(1e-11));
  turned.base.turn = Restraint<Rational>::sprung(1000000000);
  CHECK(value(turned) < clamped_pinned);
  // a stiff one lacks M^2 / c of energy, relative to ∫ w'^2: P (1 - 2 P / (P - 1 ...) / c) has order 1 / c
  CHECK(value(turned) == close_to(clamped_pinned).epsilon(1e-8));
  Rod supported = compressed_rod(pinned<Rational>(), guided<Rational>());
  supported.supports = {{Rational(1, 2), Restraint<Rational>::sprung(0)}};
  CHECK(value(supported, 18) == close_to(pinned_rod));
  // beyond 16 pi^2 = 157.91 a support in the middle is as good as one that holds: Timoshenko and Gere 2.6
  const Interval held = Interval(4) * sqr(Interval::pi());
  supported.supports[0].across = Restraint<Rational>::sprung(158);
  CHECK(encloses(critical_rod(supported, 15), held));
  supported.supports[0].across = Restraint<Rational>::sprung(157);
  CHECK(Interval(critical_rod(supported, 15).factor.high).upper() < held.lower());
  supported.supports[0].across = Restraint<Rational>::held();
  CHECK(encloses(critical_rod(supported, 15), held));
}

TEST_CASE("a stiffer support never lowers the critical factor, a mirror never changes it") {
  check_property("monotone", [] {
    const int at = *rc::gen::inRange(1, 10), soft = *rc::gen::inRange(0, 300),
              more = *rc::gen::inRange(1, 300);
    const auto supported = [&](int stiffness) {
      Rod rod = compressed_rod(pinned<Rational>(), guided<Rational>());
      rod.bed = 20;
      rod.supports = {{Rational(at, 10), Restraint<Rational>::sprung(stiffness)}};
      return critical_rod(rod, 4).factor;
    };
    RC_ASSERT(supported(soft).low <= supported(soft + more).high);
  });
  Rod rod = heavy_rod(clamped_base(), guided<Rational>());
  rod.supports = {{Rational(1, 3), Restraint<Rational>::sprung(30)}};
  Rod mirrored = bare_rod({{}, Restraint<Rational>::held(), {}}, clamped_base());
  mirrored.supports = {{Rational(2, 3), Restraint<Rational>::sprung(30)}};
  mirrored.weights = {{0, 1, -1}};
  CHECK(critical_rod(rod, 12).factor.decimal == critical_rod(mirrored, 12).factor.decimal);
}

TEST_CASE("a rod of other size: the force is as E I / length^2") {
  Rod rod = compressed_rod(clamped_base(), guided<Rational>());
  rod.EI = Rational(5, 2);
  rod.length = Rational(4, 5);
  rod.loads[0].at = rod.length;
  CHECK(value(rod) == close_to(20.190728556426630 * 2.5 / 0.64).epsilon(1e-11));
}

TEST_CASE("chains of n bars converge to the rod as n^-2") {
  // the error is c n^-2 + d n^-4: that of 24 bars over that of 48 is 4 but for 3 (d / c) / 24^2; d / c is
  // below the squared wave number, 40 for the shortest wave here
  constexpr std::size_t n = 24;
  const double tolerance = 3 * 40.0 / (n * n);
  const auto ratio = [&](const auto& chain, const Rod& rod) {
    const double limit = value(rod, 15);
    return (lowest(chain(n)) - limit) / (lowest(chain(2 * n)) - limit);
  };
  const auto force = [](RodEnd base, RodEnd end, const Rational& bed) {
    return [=](std::size_t bars) {
      Structure<Rational> chain = plumbline::rod<Rational>(1, 1, bars, base, end);
      chain.add_compression();
      if (bed != 0) chain.add_foundation(bed);
      return chain;
    };
  };
  CHECK(std::abs(ratio(force(RodEnd::clamped, RodEnd::pinned, 0),
                       compressed_rod(clamped_base(), guided<Rational>())) -
                 4) < tolerance);
  Rod bed = compressed_rod(pinned<Rational>(), guided<Rational>());
  bed.bed = 320;
  CHECK(std::abs(ratio(force(RodEnd::pinned, RodEnd::pinned, 320), bed) - 4) < tolerance);
  const auto heavy = [](std::size_t bars) {
    Structure<Rational> chain = plumbline::rod<Rational>(1, 1, bars, RodEnd::clamped, RodEnd::free);
    for (std::size_t link = 1; link <= bars; ++link)
      chain.add_weight(link, {Rational(-1, static_cast<long>(bars)), 0});
    return chain;
  };
  CHECK(std::abs(ratio(heavy, heavy_rod(clamped_base(), {})) - 4) < tolerance);
}

TEST_CASE("a rod that nothing makes give way is refused in words") {
  Rod pulled = compressed_rod(clamped_base(), {});
  pulled.loads[0].force = -1;
  CHECK_THROWS_WITH_AS(critical_rod(pulled, 10), doctest::Contains("compresses it"), Error);
  Rod heavy = compressed_rod(clamped_base(), {});
  heavy.weights = {{0, 1, 8, false}};
  CHECK_THROWS_WITH_AS(critical_rod(heavy, 10), doctest::Contains("gives way"), Error);
  Rod both = compressed_rod(clamped_base(), {Restraint<Rational>::held(), {}, {}});
  CHECK_THROWS_WITH_AS(critical_rod(both, 10), doctest::Contains("both held along"), Error);
}
