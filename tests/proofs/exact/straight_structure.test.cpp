#include "proofs/exact/straight_structure.hpp"

#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/decimal.hpp"
#include "tests/proofs/exact/dense_factors.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

Structure<Rational> cantilever(std::size_t n) {
  Structure<Rational> structure{Chain<Rational>(std::vector<Rational>(n, 1), std::vector<Rational>(n, 1))};
  structure.end_point = {};
  structure.add_compression();
  return structure;
}

std::vector<Rational> random_decimals(std::size_t n, int low) {
  std::vector<Rational> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(Rational(*rc::gen::inRange(low, 400), 100));
  return values;
}

Restraint<Rational> random_restraint(bool may_be_held) {
  const int kind = *rc::gen::inRange(0, may_be_held ? 4 : 3);
  if (kind == 3) return Restraint<Rational>::held();
  return kind == 2 ? Restraint<Rational>::sprung(Rational(*rc::gen::inRange(1, 300), 100))
                   : Restraint<Rational>();
}

/// Any ends, supports and dead loads along a chain of up to seven links.
Structure<Rational> random_structure() {
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(1, 8));
  Structure<Rational> structure{Chain<Rational>(random_decimals(n, 10), random_decimals(n, 10))};
  if (n > 1 && *rc::gen::inRange(0, 4) == 0) {
    auto stiffness = structure.chain.stiffness();
    stiffness[0] = 0;
    structure.chain = Chain<Rational>(structure.chain.length(), stiffness);
    if (*rc::gen::inRange(0, 2) == 0) structure.base.turn = Restraint<Rational>::held();
  }
  if (*rc::gen::inRange(0, 4) == 0) structure.base.across = random_restraint(false);
  structure.end_point.across = random_restraint(true);
  structure.end_point.turn = random_restraint(true);
  for (std::size_t i = 1; i < n; ++i)
    structure.across.push_back(*rc::gen::inRange(0, 3) == 0 ? random_restraint(true) : Restraint<Rational>());
  const int loads = *rc::gen::inRange(1, 4);
  for (int l = 0; l < loads; ++l) {
    const auto node = static_cast<std::size_t>(*rc::gen::inRange(1, static_cast<int>(n) + 1));
    structure.loads.push_back({node,
                               {Rational(*rc::gen::inRange(-300, 100), 100), 0},
                               *rc::gen::inRange(0, 4) > 0,
                               LoadKind::dead});
  }
  return structure;
}

}  // namespace

// RC_PARAMS="seed=1 max_success=10000" checks so many structures
TEST_CASE("critical factors of random chains with random ends agree with dense eigenvalues in fifty digits") {
  check_property("dense", [] {
    // A fifth to a third of what is drawn at full size is loaded and holds: the others are mechanisms, or
    // give way before, or their loads only pull.
    const auto full_size = rc::gen::resize(rc::kNominalSize, rc::gen::exec(random_structure));
    Structure<Rational> structure = *full_size;
    std::optional<StraightStructure> straight;
    for (int draw = 0; draw < 50 && !straight; ++draw) try {
        straight.emplace(structure);
      } catch (const Error&) {
        structure = *full_size;
      }
    RC_PRE(straight.has_value());
    const std::vector<Mpfr50> dense = dense_factors(structure);
    const auto found = straight->enclose(99, 25);
    RC_ASSERT(found.size() == dense.size());
    for (std::size_t m = 0; m < found.size(); ++m) {
      // condition of the dense matrices: spans up to 40, seven links: below 1e10, so 1e-36 of 50 digits
      const Mpfr50 slack = dense[m] * Mpfr50("1e-30");
      RC_ASSERT(from_rational<Mpfr50>(found[m].low) - slack <= dense[m]);
      RC_ASSERT(dense[m] <= from_rational<Mpfr50>(found[m].high) + slack);
    }
  });
}

TEST_CASE("the string and the pencil of one structure count the same") {
  check_property("counts", [] {
    const auto n = static_cast<std::size_t>(*rc::gen::inRange(1, 9));
    Structure<Rational> structure{Chain<Rational>(random_decimals(n, 10), random_decimals(n, 10))};
    structure.end_point = *rc::gen::inRange(0, 2) == 0 && n > 1 ? guided<Rational>() : Support<Rational>();
    if (!structure.end_point.across.is_held() && *rc::gen::inRange(0, 2) == 0) {
      structure.end_point.turn = random_restraint(n > 1);
      for (std::size_t link = 1; link <= n; ++link)
        structure.add_weight(link, {Rational(-*rc::gen::inRange(1, 9), 4), 0});
    } else {
      structure.add_compression();
    }
    const auto form = string_form(structure);
    RC_ASSERT(form.has_value());
    const auto pencil = straight_pencil(structure);
    RC_ASSERT(kind_of(pencil).modes == mode_count(form->chain));
    const Rational F(*rc::gen::inRange(1, 2000), 100);
    RC_ASSERT(count_below(form->straight(), F) == count_below(pencil, std::vector{F}).front());
  });
}

TEST_CASE("shapes by the string and by the pencil agree") {
  Structure<Rational> structure{Chain<Rational>({1, 2, 1, Rational(1, 2)}, {1, 3, 1, 2})};
  structure.add_compression();
  const auto by_string = StraightStructure(structure).in_decimals(9, 20, true);
  structure.end_point.turn =
      Restraint<Rational>::sprung(shifted(Rational(1), -30));  // next to nothing: no string
  const StraightStructure straight(structure);
  REQUIRE(!straight.has_string());
  const auto by_pencil = straight.in_decimals(9, 20, true);
  REQUIRE(by_pencil.size() == 3);
  for (std::size_t m = 0; m < 3; ++m) {
    CHECK(by_pencil[m].force == by_string[m].force);
    CHECK(by_pencil[m].signs == by_string[m].signs);
    for (std::size_t i = 0; i < 4; ++i) CHECK(by_pencil[m].q[i] == doctest::Approx(by_string[m].q[i]));
    CHECK(by_pencil[m].fy.convert_to<double>() == doctest::Approx(by_string[m].fy.convert_to<double>()));
  }
}

TEST_CASE(
    "the lateral force at the end point balances the moment of joint 1, whatever the size of the loads") {
  for (const Rational& size : {Rational(1), Rational(2202, 1000), Rational(77, 100)}) {
    Structure<Rational> structure{
        Chain<Rational>({Rational(1091, 1000), Rational(8393, 10000)}, {Rational(9553, 10000), 0})};
    structure.loads = {{2, {-size, 0}, true, LoadKind::dead}};
    const auto mode = StraightStructure(structure).in_decimals(1, 15, true)[0];
    // about the base: Fy (L1 + L2) = -k1 q1, to the digits of an angle
    CHECK(mode.fy.convert_to<double>() * (1.091 + 0.8393) ==
          doctest::Approx(-0.9553 * mode.q[0]).epsilon(1e-13));
  }
}

TEST_CASE("equal links, fixed and free: 2 - 2 cos((2 m - 1) pi / (2 n + 1)), textbook") {
  // two links: (3 -+ sqrt 5) / 2, the roots of F^2 - 3 F + 1
  const auto two = StraightStructure(cantilever(2)).enclose(9, 50);
  REQUIRE(two.size() == 2);
  for (const auto& root : two) {
    const auto p = [](const Rational& F) { return Rational(F * F - 3 * F + 1); };
    CHECK(p(root.low) * p(root.high) < 0);
  }
  for (const std::size_t n : {1u, 2u, 3u, 7u, 40u}) {
    const auto modes = StraightStructure(cantilever(n)).in_decimals(99, 15, true);
    REQUIRE(modes.size() == n);
    for (std::size_t m = 1; m <= n; ++m) {
      const double expected = 2 - 2 * std::cos((2.0 * static_cast<double>(m) - 1) * std::acos(-1.0) /
                                               (2.0 * static_cast<double>(n) + 1));
      CHECK(std::stod(modes[m - 1].force) == doctest::Approx(expected).epsilon(1e-13));
    }
  }
}

TEST_CASE("a rigid bar on a spring at its base gives way at k / L: Bathe, Finite Element Procedures, 1996") {
  Structure<Rational> bar{Chain<Rational>({Rational(5, 2)}, {Rational(7)})};
  bar.end_point = {};
  bar.add_compression();
  const auto modes = StraightStructure(bar).in_decimals(9, 30, true);
  REQUIRE(modes.size() == 1);
  CHECK(modes[0].force == "2.80000000000000000000000000000");
}

TEST_CASE("what cannot be computed is named") {
  const auto message = [](const Structure<Rational>& structure) {
    try {
      StraightStructure{structure};
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  Structure<Rational> structure{Chain<Rational>({1, 1}, {0, 1})};
  structure.end_point = {};
  structure.add_compression();
  CHECK(message(structure).find("mechanism") != std::string::npos);
  structure = cantilever(2);
  structure.loads[0].force = {1, 0};
  CHECK(message(structure).find("pull") != std::string::npos);
  structure.loads[0].force = {-1, 1};
  CHECK(message(structure).find("bends") != std::string::npos);
  structure = cantilever(2);
  structure.loads.push_back({2, {-1, 0}, false, LoadKind::dead});
  CHECK(message(structure).find("fixed loads alone") != std::string::npos);
  structure = cantilever(2);
  structure.end_point.along = Restraint<Rational>::held();
  CHECK(message(structure).find("both held along") != std::string::npos);
  structure = cantilever(2);
  structure.base.turn = Restraint<Rational>::held();
  CHECK(message(structure).find("clamped base") != std::string::npos);
}
