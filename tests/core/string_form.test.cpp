#include <doctest/doctest.h>

#include <plumbline/straight/buckling_mode.hpp>
#include <plumbline/straight/pencil_sweep.hpp>
#include <plumbline/straight/string_form.hpp>

#include "tests/close_to.hpp"

using namespace plumbline;

namespace {

Structure<double> cantilever(std::size_t n) {
  Structure<double> structure{Chain<double>(std::vector<double>(n, 1.0), std::vector<double>(n, 1.0))};
  structure.end_point = {};
  return structure;
}

}  // namespace

TEST_CASE("a cantilever of a million links has its lowest force to the last digits, in O(n)") {
  const std::size_t n = 1000000;
  Structure<double> structure = cantilever(n);
  structure.add_compression();
  const auto form = string_form(structure);
  REQUIRE(form);
  const double half = std::acos(-1.0) / (2.0 * (2.0 * static_cast<double>(n) + 1));
  // a few units in the last place, growing like the square root of n in practice: lowest_force.test.cpp
  CHECK(lowest_critical_force(form->straight()) ==
        close_to(4 * std::sin(half) * std::sin(half)).epsilon(1e-12));
}

TEST_CASE("a heavy cantilever of a million links tends to the column of 7.837 EI / L^3") {
  const std::size_t n = 1000000;
  Structure<double> structure = cantilever(n);
  for (std::size_t link = 1; link <= n; ++link) structure.add_weight(link, {-1, 0});
  const auto form = string_form(structure);
  REQUIRE(form);
  const double bars = static_cast<double>(n), factor = lowest_critical_force(form->straight());
  // k = EI / l, weight 1 a link: factor L^3 / EI = factor n^3; the base has k where a rod has 2 k: off by O(1
  // / n)
  CHECK(factor * bars * bars * bars == close_to(7.837347).epsilon(1e-5));
}

TEST_CASE("lists of every kind give the string its structure has") {
  Structure<double> structure = cantilever(4);
  structure.add_compression();
  CHECK(string_form(structure)->end_point == EndPoint::free);
  structure.end_point.turn = Restraint<double>::held();  // its direction held: one bead fewer
  CHECK(mode_count(string_form(structure)->chain) == 3);
  structure.end_point = guided<double>();
  CHECK(string_form(structure)->end_point == EndPoint::guided);
  structure.end_point.turn = Restraint<double>::sprung(1);
  CHECK(!string_form(structure));
  structure.end_point = {};
  structure.add_foundation(0.1);
  CHECK(!string_form(structure));
  structure = cantilever(4);
  structure.loads.push_back({2, {-1, 0}, true, LoadKind::dead});  // the two links beyond carry nothing
  REQUIRE(string_form(structure));
  CHECK(string_form(structure)->joints == 2);
  structure.loads.push_back({4, {2, 0}, true, LoadKind::dead});  // now they are pulled
  CHECK(!string_form(structure));
}

TEST_CASE("the pencil's sweep finds what the string has, in double") {
  Structure<double> structure{Chain<double>({1, 2, 0.5, 1}, {1, 0.5, 2, 1})};
  structure.add_compression();
  const auto pencil = straight_pencil(structure);
  const auto by_pencil = critical_factors(pencil, 9, 3);
  const auto by_string = critical_forces(structure.chain, 9);
  REQUIRE(by_pencil.size() == 3);
  for (std::size_t m = 0; m < 3; ++m) CHECK(by_pencil[m] == close_to(by_string[m]).epsilon(1e-11));
}

TEST_CASE("an eigenvalue that occurs twice has two shapes at right angles") {
  // two equal spans beside a held, passive joint: each buckles on its own
  Structure<double> structure{Chain<double>({1, 1, 1, 1}, {0, 1, 0, 1})};
  structure.across.resize(3);
  structure.across[1] = Restraint<double>::held();
  structure.add_compression();
  const auto pencil = straight_pencil(structure);
  const auto factors = critical_factors(pencil, 9, 2);
  REQUIRE(factors.size() == 2);
  CHECK(factors[0] == close_to(2));
  CHECK(factors[1] == close_to(2));
  const auto first = critical_deflections(pencil, factors[0]);
  const auto second = critical_deflections(pencil, factors[1], {first});
  CHECK(std::abs(first.normalized().dot(second.normalized())) < 0.99);
}
