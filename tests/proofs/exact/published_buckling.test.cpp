// What others published of buckling, each value with its source, to the digits that the source has.

#include <doctest/doctest.h>

#include <plumbline/structure/beam.hpp>

#include "proofs/exact/critical_modes.hpp"
#include "proofs/exact/critical_torque.hpp"
#include "proofs/exact/follower.hpp"
#include "proofs/exact/straight_space.hpp"
#include "proofs/exact/straight_structure.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

const double pi = std::acos(-1.0);

double lowest(const Structure<Rational>& structure) {
  return std::stod(StraightStructure(structure).in_decimals(1, 15, false)[0].force);
}

/// Of a rod of unit stiffness and length under an end force.
double rod_in_bars(std::size_t n, RodEnd base, RodEnd end) {
  Structure<Rational> structure = rod<Rational>(1, 1, n, base, end);
  structure.add_compression();
  return lowest(structure);
}

/// The limit of values whose error falls as n^-2, from n and 2 n: what is left falls as n^-4.
double limit(double at_n, double at_twice) {
  return (4 * at_twice - at_n) / 3;
}

Structure<Rational> heavy_rod(std::size_t n) {
  Structure<Rational> structure = rod<Rational>(1, 1, n, RodEnd::clamped, RodEnd::free);
  for (std::size_t link = 1; link <= n; ++link)
    structure.add_weight(link, {Rational(-1, static_cast<long>(n)), 0});
  return structure;
}

double follower_loss(const Structure<Rational>& structure, int digits = 12) {
  return std::stod(stability_loss(straight_motion(structure), digits).factor);
}

Structure<Rational> beck(std::size_t n) {
  Structure<Rational> structure = rod<Rational>(1, 1, n, RodEnd::clamped, RodEnd::free);
  structure.loads.push_back({n, {-1, 0}, true, LoadKind::follower});
  return structure;
}

}  // namespace

TEST_CASE(
    "Euler's columns: 1/4, 1, 2.0457, 4 times pi^2 EI / L^2, approached as n^-2 with the known constant") {
  // Timoshenko and Gere, Theory of Elastic Stability, 1961, 2.1 to 2.3; fixed and pinned: tan u = u, 4.4934^2
  for (const std::size_t n : {4u, 7u, 20u}) {
    const double bars = static_cast<double>(n);
    const auto exactly = [&](double rod) {
      return doctest::Approx(4 * bars * bars * std::pow(std::sin(std::sqrt(rod) / (2 * bars)), 2))
          .epsilon(1e-12);
    };
    CHECK(rod_in_bars(n, RodEnd::clamped, RodEnd::free) == exactly(pi * pi / 4));
    CHECK(rod_in_bars(n, RodEnd::pinned, RodEnd::pinned) == exactly(pi * pi));
    CHECK(rod_in_bars(n, RodEnd::clamped, RodEnd::clamped) == exactly(4 * pi * pi));
  }
  const double pinned = rod_in_bars(20, RodEnd::pinned, RodEnd::pinned);
  CHECK(rod_force(pinned, 1.0, 1.0 / 20) == doctest::Approx(pi * pi).epsilon(1e-5));
  const double fixed_pinned = limit(rod_in_bars(40, RodEnd::clamped, RodEnd::pinned),
                                    rod_in_bars(80, RodEnd::clamped, RodEnd::pinned));
  CHECK(fixed_pinned == doctest::Approx(20.1907).epsilon(5e-6));  // left: (20.19 / 12 / 40^2)^2, 1e-6
}

TEST_CASE(
    "a column under its own weight: 7.837 EI / L^3 per unit length, Greenhill 1881; Timoshenko and Gere "
    "2.12") {
  const double at_limit = limit(lowest(heavy_rod(40)), lowest(heavy_rod(80)));
  CHECK(at_limit == doctest::Approx(7.837347).epsilon(1e-6));
}

TEST_CASE("Ziegler's double pendulum: flutter at (7/2 - sqrt 2) k / L = 2.086 k / L, masses 2 m and m") {
  // H. Ziegler, Die Stabilitaetskriterien der Elastomechanik, Ingenieur-Archiv 20 (1952) 49-56
  Structure<Rational> structure{Chain<Rational>({1, 1}, {1, 1})};
  structure.end_point = {};
  structure.mass = {0, 2, 1};
  structure.loads.push_back({2, {-1, 0}, true, LoadKind::follower});
  const auto loss = stability_loss(straight_motion(structure), 40);
  CHECK(loss.kind == Motion::flutter);
  CHECK(loss.first);
  // 2.0857864376269049511983112757903019214303…, the smaller root of (x - 7/2)^2 = 2
  const auto p = [](const Rational& x) { return Rational((x - Rational(7, 2)) * (x - Rational(7, 2)) - 2); };
  CHECK(p(loss.low) * p(loss.high) < 0);
  CHECK(loss.high < 3);
}

TEST_CASE("which masses move decides when it flutters") {
  Structure<Rational> structure{Chain<Rational>({1, 1}, {1, 1})};
  structure.end_point = {};
  structure.loads.push_back({2, {-1, 0}, true, LoadKind::follower});
  structure.mass = {0, 1, 1};
  const double equal = follower_loss(structure);
  structure.mass = {0, 2, 1};
  CHECK(equal != doctest::Approx(follower_loss(structure)).epsilon(0.01));
}

TEST_CASE("Beck's column: flutter at 20.05 EI / L^2 as n grows" * doctest::test_suite("long")) {
  // M. Beck, Die Knicklast des einseitig eingespannten, tangential gedrueckten Stabes, ZAMP 3 (1952) 225-228
  // of errors c n^-2 + d n^-4 neither is left, with n doubled twice; what is: (20 / 12 n^2)^3, 2e-5 at n = 8
  const double at_4 = follower_loss(beck(4)), at_8 = follower_loss(beck(8)),
               at_16 = follower_loss(beck(16), 8);
  CHECK((64 * at_16 - 20 * at_8 + at_4) / 45 == doctest::Approx(20.05).epsilon(2.5e-4));
}

TEST_CASE(
    "a force that follows the last link of a chain whose end point is guided has no flutter, but "
    "divergence") {
  Structure<Rational> structure{Chain<Rational>({1, 1, 1}, {0, 1, 1})};
  structure.loads.push_back({3, {-1, 0}, true, LoadKind::follower});
  const auto loss = stability_loss(straight_motion(structure), 20);
  // what follows acts across alone where the guide takes it up: the paper's U-shape, k / L
  CHECK(loss.kind == Motion::divergence);
  CHECK(loss.low < 1);
  CHECK(loss.high >= 1);
}

TEST_CASE(
    "a column on an elastic bed buckles in m half-waves: pi^2 (m^2 + b / (m^2 pi^4)), Timoshenko and Gere "
    "2.10") {
  const auto column = [](const Rational& bed, std::size_t n) {
    Structure<Rational> structure = rod<Rational>(1, 1, n, RodEnd::pinned, RodEnd::pinned);
    structure.add_compression();
    structure.add_foundation(bed);
    return structure;
  };
  for (const auto& [m, bed] :
       {std::pair(1, 100), std::pair(2, 1500), std::pair(3, 8000), std::pair(4, 20000)}) {
    // b between (m - 1)^2 m^2 pi^4 and m^2 (m + 1)^2 pi^4 makes m half-waves the fewest in force
    const double b = bed, square = m * m * pi * pi;
    const double expected = square + b / square;
    const double at_limit = limit(lowest(column(bed, 40)), lowest(column(bed, 80)));
    CHECK(at_limit == doctest::Approx(expected).epsilon(1e-4));
    const auto q = StraightStructure(column(bed, 40)).in_decimals(1, 15, true)[0].q;
    double slope = 0, deflection = 0;
    int waves = 1;
    std::vector<double> w;
    for (const double angle : q) {
      deflection += slope += angle;
      if (std::abs(deflection) > 1e-9) w.push_back(deflection);  // the middle of an even wave is a joint
    }
    for (std::size_t i = 1; i < w.size(); ++i) waves += (w[i] > 0) != (w[i - 1] > 0) ? 1 : 0;
    CHECK(waves == m);
  }
}

TEST_CASE("elastic end restraints: the chain of bars tends to the column of the transcendental equation") {
  // Wang, Zhang, Gao, Duan, Challamel, Hencky bar-chain model for buckling and vibration of beams with
  // elastic end restraints, Int. J. Struct. Stab. Dyn. 15 (2015) 1540007: an end spring C in series with half
  // a bar
  const auto bars = [](std::size_t n, const Rational& c) {
    Structure<Rational> structure = rod<Rational>(1, 1, n, RodEnd::clamped, RodEnd::pinned);
    auto stiffness = structure.chain.stiffness();
    stiffness[0] = 1 / (1 / stiffness[0] + 1 / c);
    structure.chain = Chain<Rational>(structure.chain.length(), stiffness);
    structure.end_point.turn = Restraint<Rational>::sprung(stiffness[0]);
    structure.add_compression();
    return lowest(structure);
  };
  // equal springs C at both ends, symmetric: w = cos u x - cos u / 2, w'' = -C w' at x = 1/2, u = sqrt P
  const double C = 4;
  double low = pi, high = 2 * pi;
  for (int i = 0; i < 60; ++i) {
    const double u = (low + high) / 2;
    (u * std::cos(u / 2) + C * std::sin(u / 2) > 0 ? low : high) = u;
  }
  CHECK(limit(bars(40, 4), bars(80, 4)) == doctest::Approx(low * low).epsilon(1e-6));
}

namespace {

/// A rod of n bars on universal joints that bend alike both ways, its ends in bearings.
SpaceStructure<Rational> universal_rod(std::size_t n, TorqueKind torque) {
  std::vector<SpaceJoint<Rational>> joints;
  for (std::size_t i = 0; i < n; ++i) {
    const Rational k = i == 0 ? 0 : static_cast<long>(n);
    joints.push_back({{{{0, 1, 0}, k, 0}, {{0, 0, 1}, k, 0}}});
  }
  SpaceStructure<Rational> structure(
      SpaceChain<Rational>(std::vector<Rational>(n, Rational(1, static_cast<long>(n))), joints));
  structure.base = SpaceBase::bearing;
  structure.torque = torque;
  return structure;
}

}  // namespace

TEST_CASE(
    "a shaft under an end torque, its ends pinned: 2 pi EI / L, Greenhill 1883; Timoshenko and Gere 2.21") {
  const auto torque = [&](std::size_t n, TorqueKind kind) {
    return std::stod(critical_torque(universal_rod(n, kind), 15).value.decimal);
  };
  for (const std::size_t n : {3u, 5u, 8u}) {
    const double bars = static_cast<double>(n);  // of n bars: 2 k sin(pi / n), k = n EI / L
    CHECK(torque(n, TorqueKind::axial) == doctest::Approx(2 * bars * std::sin(pi / bars)).epsilon(1e-13));
  }
  CHECK(limit(torque(6, TorqueKind::axial), torque(12, TorqueKind::axial)) ==
        doctest::Approx(2 * pi).epsilon(1e-3));
}

TEST_CASE(
    "which torques have an energy: the semitangential one, and each where the end's direction is held") {
  CHECK(!critical_torque(universal_rod(4, TorqueKind::axial), 10).conservative);
  CHECK(!critical_torque(universal_rod(4, TorqueKind::tangential), 10).conservative);
  CHECK(critical_torque(universal_rod(4, TorqueKind::semitangential), 10).conservative);
  const auto between_clamps = [](TorqueKind kind) {
    SpaceStructure<Rational> structure = universal_rod(5, kind);
    structure.base = SpaceBase::clamped;
    structure.end_point = clamped<Rational>();
    return critical_torque(structure, 20);
  };
  for (const TorqueKind kind : {TorqueKind::axial, TorqueKind::tangential, TorqueKind::semitangential}) {
    CHECK(between_clamps(kind).conservative);
    CHECK(between_clamps(kind).value.decimal == between_clamps(TorqueKind::axial).value.decimal);
  }
}

TEST_CASE("universal joints with unequal planes: the weaker one, and 2 (n - 1) forces") {
  std::vector<SpaceJoint<Rational>> joints(4, SpaceJoint<Rational>{{{{0, 0, 1}, 1, 0}, {{0, 1, 0}, 3, 0}}});
  SpaceStructure<Rational> structure(SpaceChain<Rational>(std::vector<Rational>(4, 1), joints));
  structure.add_compression();
  const StraightSpace space(structure);
  CHECK(space.modes() == 6);
  const auto planar = modes_in_decimals(Chain<Rational>({1, 1, 1, 1}, {1, 1, 1, 1}), 9, 30);
  CHECK(space.in_decimals(1, 30)[0].force == planar[0].force);
}
