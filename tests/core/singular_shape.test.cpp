#include <plumbline/space/bent_branch.hpp>
#include <plumbline/space/space_pencil.hpp>

#include "tests/property.hpp"

using namespace plumbline;

namespace {

/// Two to four links about axes that whole numbers state, straight, some nodes and the last direction held.
SpaceStructure<Rational> random_held_chain() {
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(2, 5));
  const std::vector<std::array<Rational, 3>> axes{{0, 0, 1}, {0, 1, 0},  {0, 1, 1}, {0, 2, -1},
                                                  {1, 0, 1}, {-1, 2, 0}, {1, 1, 1}, {1, 0, 0}};
  std::vector<Rational> length;
  std::vector<SpaceJoint<Rational>> joints(n);
  for (SpaceJoint<Rational>& joint : joints) {
    length.emplace_back(*rc::gen::inRange(1, 6));
    for (int count = *rc::gen::inRange(1, 4); count > 0; --count)
      joint.axes.push_back({*rc::gen::elementOf(axes), 1, 0});
  }
  SpaceStructure<Rational> structure(SpaceChain<Rational>(length, joints));
  structure.across.resize(n - 1);
  for (Restraint<Rational>& support : structure.across) {
    if (*rc::gen::inRange(0, 2) == 0) support = Restraint<Rational>::held();
  }
  structure.end_point = {{}, Restraint<Rational>::held(), {}};
  if (*rc::gen::inRange(0, 2) == 0) structure.end_point.turn = Restraint<Rational>::held();
  return structure;
}

/// What is held at the straight shape to first order, exactly, in turns by 1 / |axis|, in which it is whole
/// for whole lengths: a column for each constraint. The sizes of the axes come along.
std::pair<Matrix<Rational>, Vector<Mpfr50>> first_order(const SpaceStructure<Rational>& structure,
                                                        const BentExpansion<Mpfr50>& at) {
  Matrix<Rational> C(at.held_gradient.cols(), at.held_gradient.rows());
  Vector<Mpfr50> sizes(C.rows());
  Eigen::Index turn = 0;
  for (const SpaceJoint<Rational>& joint : structure.chain.joint) {
    for (const Axis<Rational>& axis : joint.axes) {
      const auto& a = axis.direction;
      sizes(turn) = sqrt(from_rational<Mpfr50>(Rational(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])));
      for (Eigen::Index i = 0; i < C.cols(); ++i)
        C(turn, i) = round(Mpfr50(at.held_gradient(i, turn) * sizes(turn))).convert_to<long>();
      ++turn;
    }
  }
  return {C, sizes};
}

BentExpansion<Mpfr50> expanded(const BentStructure<Mpfr50>& model, const Vector<Mpfr50>& multiplier) {
  BentExpansion<Mpfr50> at;
  model.expand(model.rest(), Mpfr50(0), multiplier, at);
  return at;
}

Vector<Mpfr50> wide(const Matrix<Rational>& from, Eigen::Index column) {
  Vector<Mpfr50> to(from.rows());
  for (Eigen::Index i = 0; i < to.size(); ++i) to(i) = from_rational<Mpfr50>(from(i, column));
  return to;
}

}  // namespace

TEST_CASE(
    "a straight shape whose dependent constraints bend what they permit is singular, an independent one is "
    "not") {
  // lambda . C = 0: along a permitted motion v the combination of constraints changes by v . B v / 2, and
  // holds to second order only where that vanishes
  check_property("second order", [] {
    const SpaceStructure<Rational> structure = random_held_chain();
    const BentStructure<Mpfr50> model = bent_structure(from_rational<Mpfr50>(structure));
    const auto straight = expanded(model, Vector<Mpfr50>::Constant(model.held(), Mpfr50(0)));
    const auto [C, sizes] = first_order(structure, straight);
    const Matrix<Rational> dependent = detail::null_space<Rational>(C);
    const Matrix<Rational> motions = detail::null_space<Rational>(Matrix<Rational>(C.transpose()));
    bool bends = false;
    for (Eigen::Index d = 0; d < dependent.cols(); ++d) {
      const Matrix<Mpfr50> B = expanded(model, wide(dependent, d)).hessian - straight.hessian;
      for (Eigen::Index i = 0; i < motions.cols(); ++i) {
        for (Eigen::Index j = 0; j <= i; ++j) {
          const Vector<Mpfr50> v = wide(motions, i).cwiseProduct(sizes),
                               w = wide(motions, j).cwiseProduct(sizes);
          bends =
              bends || abs(v.dot(B * w)) > Mpfr50(1e-30);  // whole numbers and roots of them, in 50 digits
        }
      }
    }
    RC_CLASSIFY(bends);
    const Vector<double> rest = Vector<double>::Constant(model.size(), 0.0);
    const bool singular = is_singular(model, rest);
    if (bends) RC_ASSERT(singular);
    if (dependent.cols() == 0) RC_ASSERT(!singular);
    RC_ASSERT(is_singular(bent_structure(from_rational<double>(structure)), rest) == singular);
  });
}

TEST_CASE("what is dependent in every shape leaves no shape singular") {
  // joint 2 and the end point of a chain whose axes are all along y: z alone is held, y holds itself
  const SpaceJoint<Rational> hinge{{{{0, 1, 0}, 1, 0}}};
  SpaceStructure<Rational> structure(SpaceChain<Rational>({1, 2, 1}, {hinge, hinge, hinge}));
  structure.across = {Restraint<Rational>::held(), {}};
  structure.end_point = {{}, Restraint<Rational>::held(), {}};
  const BentStructure<double> model = bent_structure(from_rational<double>(structure));
  CHECK_FALSE(is_singular(model, model.rest()));
  // a link that is held at both ends and turns about itself: its second axis is held by both coordinates
  const SpaceJoint<Rational> first{{{{0, 0, 1}, 1, 0}, {{0, 1, 0}, 1, 0}, {{1, 0, 0}, 1, 0}}};
  SpaceStructure<Rational> twisted(SpaceChain<Rational>({1, 1}, {first, {{{{0, 0, 1}, 1, 0}}}}));
  twisted.across = {Restraint<Rational>::held()};
  twisted.end_point = {{}, Restraint<Rational>::held(), {}};
  const BentStructure<double> spun = bent_structure(from_rational<double>(twisted));
  CHECK_FALSE(is_singular(spun, spun.rest()));
}

TEST_CASE("two families of shapes of a clamped pair of links cross a quarter turn out of the plane") {
  // joints z, y, z and y, the last link's direction held: the first joint turns by c and -c, or at c a
  // quarter of a turn about its y axis alone
  const SpaceJoint<double> first{{{{0, 0, 1}, 1, 0}, {{0, 1, 0}, 1, 0}, {{0, 0, 1}, 1, 0}}};
  SpaceStructure<double> structure(SpaceChain<double>({1, 2}, {first, {{{{0, 1, 0}, 1, 0}}}}));
  structure.end_point = {{}, Restraint<double>::held(), Restraint<double>::held()};
  const BentStructure<double> model = bent_structure(structure);
  const double quarter = std::acos(0.0);
  const auto turned = [](double c, double b) {
    Vector<double> x(4);
    x << -c, b, c, 0;
    return x;
  };
  CHECK(is_singular(model, turned(quarter, 0)));
  CHECK(is_singular(model, turned(-quarter, 1e-7)));
  CHECK_FALSE(is_singular(model, turned(0.3, 0)));
  CHECK_FALSE(is_singular(model, turned(quarter, 0.3)));
}

TEST_CASE("an event at a singular shape ends the branch and is none") {
  Structure<double> structure(Chain<double>({1, 1}, {1, 1}));
  structure.end_point = {};
  structure.add_compression();
  const BentStructure<double> model = bent_structure(structure);
  const BentLimits<double> limits{0, 4};
  BentTracer<double> tracer(model, limits, [](const Vector<double>&) { return true; });
  const auto branch = tracer.run(tracer.solver().at_factor(model.rest(), 0, Vector<double>()).value());
  CHECK(branch.end == BentEnd::singular);
  CHECK(branch.events.empty());
  CHECK(branch.points.back().factor < (3 - std::sqrt(5)) / 2);  // k / L times that is critical
}

TEST_CASE("a path ends with its budget of linear systems") {
  Structure<double> structure(Chain<double>({1, 1}, {1, 1}));
  structure.end_point = {};
  structure.add_compression();
  const BentStructure<double> model = bent_structure(structure);
  BentLimits<double> limits{0, 10};
  limits.solves = 50;
  BentTracer<double> tracer(model, limits);
  const auto start = tracer.solver().at_factor(model.rest(), 0, Vector<double>());
  REQUIRE(start);
  const auto history = load_slowly(tracer, *start, limits);
  CHECK(history.back().end == BentEnd::budget);
  CHECK(history.back().points.back().factor < 10);
}
