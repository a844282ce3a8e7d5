#include "proofs/paths/certified_structure.hpp"

#include <doctest/doctest.h>

#include "proofs/paths/structure_equations.hpp"
#include "proofs/paths/structure_path.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// From rest as far as the factor goes.
BentBranch<double> followed_structure(const Structure<Rational>& structure, double last, double step = 0.05) {
  const auto model = bent_structure(from_rational<double>(structure));
  BentLimits<double> limits{0, last};
  limits.longest = step;
  BentTracer<double> tracer(model, limits);
  const auto start = tracer.solver().at_factor(model.rest(), 0, Vector<double>::Constant(model.held(), 0.0));
  REQUIRE(start.has_value());
  return tracer.run(*start);
}

/// One link that leans by an angle, whose base slides against a spring of stiffness one, whose end point is
/// led across and pressed down: half of von Mises's truss.
Structure<Rational> half_truss(const Rational& lean) {
  Structure<Rational> structure(Chain<Rational>({1}, {0}, {lean}));
  structure.base.along = Restraint<Rational>::sprung(Rational(1));
  structure.end_point = {Restraint<Rational>::held(), {}, {}};
  structure.loads.push_back({1, {0, -1}, true, LoadKind::dead});
  return structure;
}

/// Two links of length one, springs of one, free at the end, under a dead force along them.
Structure<Rational> two_links_upright() {
  Structure<Rational> structure(Chain<Rational>({1, 1}, {1, 1}));
  structure.end_point = {};
  structure.add_compression();
  return structure;
}

/// Something of everything.
Structure<Rational> manifold() {
  Structure<Rational> structure(
      Chain<Rational>({1, Rational(3, 2), Rational(1, 2), 1}, {1, 2, 1, 3}, {Rational(1, 10), 0, 0, 0}));
  structure.base.across = Restraint<Rational>::sprung(Rational(5));
  structure.across = {{}, Restraint<Rational>::sprung(Rational(1, 2)), {}};
  structure.end_point.turn = Restraint<Rational>::sprung(Rational(1, 4));
  for (std::size_t link = 1; link <= 4; ++link)
    structure.add_weight(link, {0, Rational(-1, 5)}, link % 2 == 0);
  structure.add_compression();
  structure.moment = Rational(1, 7);
  return structure;
}

}  // namespace

TEST_CASE(
    "the equations of a structure hold where its model is at rest, and their derivatives along the branch") {
  for (const auto& structure : {manifold(), two_links_upright(), half_truss(Rational(1, 2))}) {
    const auto model = bent_structure(from_rational<double>(structure));
    StructureEquations equations(structure);
    const auto branch = followed_structure(structure, 0.1);
    const auto& point = branch.points.back();
    const Vector<Span> u = equations.at(model, point), none = Vector<Span>::Constant(u.size(), Span(0));
    // Newton's method ends within a thousand roundings of sums of ten terms of size ten
    CHECK(equations.value(u).unaryExpr(magnitude_of).maxCoeff() < 1e-10);
    // the tangent of the model is that of the equations: as the point a step further has it
    BentPoint<double> further = point;
    further.x += 1e-4 * point.tangent_x;
    further.multiplier += 1e-4 * point.tangent_multiplier;
    further.factor += 1e-4 * point.tangent_factor;
    const Vector<Span> step = equations.at(model, further) - u;
    const Matrix<Span> M = equations.derivative(u, none);
    Vector<Span> first = none;
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      for (Eigen::Index j = 0; j < u.size(); ++j) first(i) += M(i, j) * step(j);
    }
    CHECK(first.unaryExpr(magnitude_of).maxCoeff() < 1e-10);
    // E(u + d) = E + E' d + E'' d d / 2 but for terms of the third order, (1e-4)^3 times ten
    const Vector<Span> rest = equations.value(u + step) - equations.value(u) - first -
                              Vector<Span>(Span(0.5) * equations.second(u, step, step));
    CHECK(rest.unaryExpr(magnitude_of).maxCoeff() < 1e-10);
    CHECK(equations.negative_directions(u) == point.negative_directions);
  }
}

TEST_CASE("the fold of half a truss is proved where it is known to be") {
  // F = (cos t - cos a) tan t is largest at cos^3 t = cos a: (1 - cos^(2/3) a)^(3/2)
  const auto structure = half_truss(Rational(1, 2));
  const auto proved = certify(structure, followed_structure(structure, 1), 1);
  CAPTURE(proved.failure);
  REQUIRE(proved.certified());
  CHECK(proved.gaps.empty());
  REQUIRE(proved.folds.size() == 1);
  const double fold = std::pow(1 - std::pow(std::cos(0.5), 2.0 / 3), 1.5);
  CHECK(proved.folds[0].low <= fold * (1 + 1e-14));
  CHECK(proved.folds[0].high >= fold * (1 - 1e-14));
  CHECK(proved.folds[0].width() < 1e-6);
  REQUIRE(proved.runs.size() == 2);
  CHECK(proved.runs[0].negative_directions == 0);
  CHECK(proved.runs[1].negative_directions == 1);
}

TEST_CASE("an upright cantilever is proved on both sides of its critical factor, which stays in a gap") {
  const auto structure = two_links_upright();
  const auto proved = certify(structure, followed_structure(structure, 0.5), 0.5);
  CAPTURE(proved.failure);
  REQUIRE(proved.certified());
  REQUIRE(proved.gaps.size() == 1);
  CHECK(proved.gaps[0].contains((3 - std::sqrt(5.0)) / 2));
  REQUIRE(proved.runs.size() == 2);
  CHECK(proved.runs[0].negative_directions == 0);
  CHECK(proved.runs[1].negative_directions == 1);
}

TEST_CASE("a structure with something of everything is proved as one stable curve") {
  const auto structure = manifold();
  const auto proved = certify(structure, followed_structure(structure, 0.3), 0.3);
  CAPTURE(proved.failure);
  REQUIRE(proved.certified());
  REQUIRE(proved.runs.size() == 1);
  CHECK(proved.runs[0].from == 0);
  CHECK(proved.runs[0].to == 0.3);
  CHECK(proved.runs[0].negative_directions == 0);
}

TEST_CASE("a point beside the curve and a curve of another structure are not proved") {
  const auto structure = manifold();
  const auto branch = followed_structure(structure, 0.3);
  auto off = branch;
  off.points[2].x(1) += 1e-3;
  CHECK_FALSE(certify(structure, off, 0.3).certified());
  auto harder = structure;  // a curve of another structure
  harder.moment = Rational(2, 7);
  CHECK_FALSE(certify(harder, branch, 0.3).certified());
}

TEST_CASE("a constraint said twice is one: the path is that without it") {
  Structure<Rational> once(Chain<Rational>({1, 1}, {0, 1}));
  once.base.turn = Restraint<Rational>::held();
  once.end_point = {};
  once.loads.push_back({2, {0, 1}, true, LoadKind::dead});
  Structure<Rational> twice = once;
  twice.across = {Restraint<Rational>::held()};  // the clamped link's far end
  const auto proved = certify(twice, followed_structure(twice, 0.3), 0.3),
             alone = certify(once, followed_structure(once, 0.3), 0.3);
  CAPTURE(proved.failure);
  REQUIRE(proved.certified());
  REQUIRE(proved.runs.size() == 1);
  CHECK(proved.runs[0].to == 0.3);
  CHECK(proved.runs[0].negative_directions == 0);
  CHECK(proved.segments == alone.segments);
}

TEST_CASE("a fork of links of unlike lengths is proved in few tubes") {
  // near the fork, at F = 1, the factor grows with the square of the deflection: its sign is known at points
  Structure<Rational> structure(Chain<Rational>({1, 40, 1}, {0, 1, 1}));
  structure.end_point = {{}, Restraint<Rational>::sprung(1), {}};
  structure.add_compression();
  const auto branches = follow_slowly(bent_structure(from_rational<double>(structure)),
                                      bent_structure(from_rational<Mpfr50>(structure)), {3, 0.05, 1})
                            .branches;
  REQUIRE(branches.size() == 2);
  const auto proved = certify(structure, branches[1], 3);
  CAPTURE(proved.failure);
  REQUIRE(proved.certified());
  CHECK(proved.runs.size() == 1);
  CHECK(proved.segments < 1000);
}
