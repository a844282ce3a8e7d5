#include <algorithm>
#include <plumbline/branch/branch_tree.hpp>
#include <plumbline/branch/straight_start.hpp>
#include <plumbline/loaded/nominal_model.hpp>
#include <random>

#include "tests/close_to.hpp"
#include "tests/property.hpp"

using namespace plumbline;

namespace {

using Nominal = NominalModel<double>;

}  // namespace

TEST_CASE("a straight chain has two branches a mode, which begin at its critical forces") {
  const Nominal model(Chain<double>({1, 2, 1, 1.5}, {1, 0.5, 2, 1}));
  Brancher<Nominal> brancher(model, {Control::end_point, {5.5, 0}, {-1, 0}}, Vector<double>::Zero(4));
  const double shortening = 1e-6;
  const auto starts = straight_starts(brancher, shortening);
  const auto forces = critical_forces(model.chain(), 3);
  REQUIRE(starts.size() == 6);
  for (std::size_t m = 0; m < 6; ++m) {
    // the force along a branch departs from the critical one in proportion to the shortening
    CHECK(-starts[m].force.x == close_to(forces[m / 2]).epsilon(1e-4));
    CHECK(starts[m].negative_directions == m / 2);
    CHECK((starts[m].theta + starts[m ^ 1U].theta).norm() < 1e-6);  // mirror images
  }
  const auto tree = branch_tree(brancher, starts, {shortening, 0.5});
  CHECK(tree.size() == 6);
  for (const auto& branch : tree) CHECK(branch.end == BranchEnd::load);
}

TEST_CASE("under a growing force the straight cantilever bifurcates at its own critical forces") {
  // the end is free to move sideways here, so K is the springs and the lateral force is zero: the
  // bifurcations are the eigenvalues of k (tridiagonal) against diag(L) in absolute angles; two unit links: 1
  // -+ : (3 -+ sqrt 5) / 2
  const Nominal model(Chain<double>({1, 1}, {1, 1}));
  Brancher<Nominal> brancher(model, {Control::force, {0, 0}, {-1, 0}}, Vector<double>::Zero(2));
  const auto branch = Tracer<Nominal>(brancher, {0, 4}).run(brancher.start(0, Vector<double>::Zero(2)));
  REQUIRE(branch.events.size() == 2);
  CHECK(branch.events[0].point.load == close_to((3 - std::sqrt(5)) / 2).epsilon(1e-12));
  CHECK(branch.events[1].point.load == close_to((3 + std::sqrt(5)) / 2).epsilon(1e-12));
  CHECK(branch.points.back().negative_directions == 2);
}

TEST_CASE("branches switch at a bifurcation: a symmetric zigzag and the two arches that leave it") {
  const double angle = std::acos(-1.0) / 10;
  std::vector<double> rest{0, angle, -angle};
  const auto p = end_point(Chain<double>({1, 1, 1}, {0, 1, 1}, rest), rest);
  rest[0] = -std::atan2(p.y, p.x);
  const Nominal model(Chain<double>({1, 1, 1}, {0, 1, 1}, rest));
  const auto shape = absolute_angles(rest);
  Brancher<Nominal> brancher(model, {Control::end_point, {std::hypot(p.x, p.y), 0}, {-1, 0}}, shape);
  const auto tree = branch_tree(brancher, {brancher.start(0, shape)}, {0, 0.5});
  // the zigzag, and one branch through the bifurcation from arch to arch
  REQUIRE(tree.size() == 2);
  const auto& arches = tree[1];
  CHECK(arches.points.front().load == 0.5);
  CHECK(arches.points.back().load == 0.5);
  CHECK(arches.points.front().theta(0) * arches.points.back().theta(0) < 0);
  for (const auto& point : arches.points) CHECK(point.negative_directions == 0);

  REQUIRE(tree[0].events[0].kind == EventKind::bifurcation);
  const double edge = tree[0].events[0].point.load + 1e-6;  // the arches are soon beyond it
  CHECK(branch_tree(brancher, {brancher.start(0, shape)}, {0, edge}, 1).size() ==
        1);  // no second one is begun
  CHECK(branch_tree(brancher, {brancher.start(0, shape)}, {0, edge}).size() == 2);
}

namespace {

/// A chain on a passive base that looks the same from both ends, held at its unloaded end points.
struct SymmetricChain {
  std::vector<double> length, stiffness, rest;
  double reach;

  /// \param equal  unit lengths and stiffnesses
  explicit SymmetricChain(bool equal) {
    const auto n = static_cast<std::size_t>(*rc::gen::inRange(3, 7));
    length.assign(n, 1), stiffness.assign(n, 1), rest.resize(n);
    std::vector<double> theta(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t twin = n - 1 - i;
      theta[i] = twin < i ? theta[twin] : 0.8 * random_hundredths(-1, 1) + 0.004;
      rest[i] = theta[i] - (i > 0 ? theta[i - 1] : 0);
      if (equal) continue;
      length[i] = twin < i ? length[twin] : random_hundredths(0, 1) + 0.5;
      if (i > 0) stiffness[i] = n - i < i ? stiffness[n - i] : random_hundredths(0, 2) + 0.5;
    }
    stiffness[0] = 0;
    const auto p = end_point(Chain<double>(length, stiffness, rest), rest);
    reach = std::hypot(p.x, p.y);
    double longest = 0;
    for (const double L : length) longest += L;
    RC_PRE(reach > 0.3 && reach < 0.999 * longest);  // neither folded up nor straight
    rest[0] -= std::atan2(p.y, p.x);
  }

  /// All its branches as its ends are pushed together.
  [[nodiscard]] std::vector<Branch<double>> tree(double longest) const {
    const Nominal model(Chain<double>(length, stiffness, rest));
    const auto shape = absolute_angles(rest);
    Brancher<Nominal> brancher(model, {Control::end_point, {reach, 0}, {-1, 0}}, shape);
    return branch_tree(brancher, {brancher.start(0, shape)}, {0, 0.8 * reach, longest});
  }
};

/// Whether a fold or a crossing lies between the points i and i + 1, or at one of them.
bool singular(const Branch<double>& branch, std::size_t i) {
  return std::any_of(branch.events.begin(), branch.events.end(), [&](const auto& event) {
    return event.kind != EventKind::quasi_buckling &&
           (event.before == i || event.point.theta == branch.points[i].theta ||
            event.point.theta == branch.points[i + 1].theta);
  });
}

}  // namespace

TEST_CASE("every crossing is met on both branches, and a closed branch closes") {
  check_property("branch trees of chains that look the same from both ends", [] {
    const auto tree = SymmetricChain(false).tree(0.05);
    std::vector<const BranchEvent<double>*> crossings;
    for (const auto& branch : tree) {
      RC_ASSERT(branch.end == BranchEnd::load || branch.end == BranchEnd::closed ||
                branch.end == BranchEnd::unbounded);
      for (const auto& event : branch.events) {
        if (event.kind == EventKind::bifurcation) crossings.push_back(&event);
      }
    }
    for (const auto* one : crossings) {
      const auto same = std::count_if(crossings.begin(), crossings.end(), [&](const auto* other) {
        return (one->point.theta - other->point.theta).cwiseAbs().maxCoeff() < 1e-6;
      });
      RC_ASSERT(same == 2);
    }
  });
}

TEST_CASE("a branch's points are close together, and its type changes where something happens alone") {
  check_property("points of branch trees", [] {
    for (const auto& branch : SymmetricChain(true).tree(0.05)) {
      for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
        const auto &a = branch.points[i], &b = branch.points[i + 1];
        // root mean square turn of equal links; a stride's length is that of its chord but for its bend
        RC_ASSERT((b.theta - a.theta).norm() < 1.5 * 0.05 * std::sqrt(static_cast<double>(a.theta.size())));
        // an eigenvalue changes its sign at a singular point only: a fold or a crossing
        RC_ASSERT(singular(branch, i) || a.negative_directions == b.negative_directions);
      }
    }
  });
}

TEST_CASE("folds and crossings do not depend on how far apart the points of a branch are") {
  check_property("events of branch trees", [] {
    const SymmetricChain chain(true);
    const auto fine = chain.tree(0.02), coarse = chain.tree(random_hundredths(0, 1) + 0.05);
    const auto singular_points = [](const std::vector<Branch<double>>& tree) {
      std::vector<std::pair<EventKind, double>> all;
      for (const auto& branch : tree) {
        for (const auto& event : branch.events) {
          if (event.kind != EventKind::quasi_buckling) all.emplace_back(event.kind, event.point.load);
        }
      }
      std::sort(all.begin(), all.end());
      return all;
    };
    const auto few = singular_points(coarse), many = singular_points(fine);
    RC_ASSERT(few.size() == many.size());
    for (std::size_t i = 0; i < few.size(); ++i) {
      RC_ASSERT(few[i].first == many[i].first);
      // places where a derivative vanishes are known to half the digits
      RC_ASSERT(std::abs(few[i].second - many[i].second) < 1e-6);
    }
  });
}

TEST_CASE("a branch that leaves a symmetric one turns there, which is a crossing and no fold") {
  // four equal links whose arches set out square to the load, so that rounding alone decides its sign there
  std::size_t crossings = 0;
  for (int outer = 30; outer < 50; outer += 2) {
    for (int inner = 60; inner < 80; inner += 2) {
      const double a = outer / 100.0, b = inner / 100.0;
      CAPTURE(a);
      CAPTURE(b);
      std::vector<double> rest{a, b - a, 0, a - b};
      const Chain<double> bent({1, 1, 1, 1}, {0, 1, 1, 1}, rest);
      const auto p = end_point(bent, rest);
      const double reach = std::hypot(p.x, p.y);
      rest[0] -= std::atan2(p.y, p.x);
      const Nominal model(Chain<double>({1, 1, 1, 1}, {0, 1, 1, 1}, rest));
      const auto shape = absolute_angles(rest);
      Brancher<Nominal> brancher(model, {Control::end_point, {reach, 0}, {-1, 0}}, shape);
      for (const auto& branch : branch_tree(brancher, {brancher.start(0, shape)}, {0, 0.8 * reach})) {
        for (const auto& crossing : branch.events) {
          if (crossing.kind != EventKind::bifurcation) continue;
          ++crossings;
          for (const auto& other : branch.events)
            CHECK((other.kind == EventKind::bifurcation ||
                   (other.point.theta - crossing.point.theta).norm() > 1e-2));
        }
      }
    }
  }
  CHECK(crossings >= 200);
}

TEST_CASE("a branch that turns back at a crossing is softest there, which is no quasi-buckling beside it") {
  // of 5,000 straight cantilevers of two to five links those where rounding showed one
  for (const auto& [seed, longest] :
       {std::pair{467U, 0.05}, {3199U, 0.05}, {5475U, 0.5}, {5827U, 0.5}, {5879U, 0.5}}) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const std::size_t n = 2 + random() % 4;
    std::vector<double> length(n), stiffness(n);
    double reach = 0;
    for (std::size_t i = 0; i < n; ++i) {
      length[i] = 0.5 + unit(random);
      stiffness[i] = 0.5 + 1.5 * unit(random);
      unit(random);
      reach += length[i];
    }
    const Nominal model(Chain<double>(length, stiffness));
    const Vector<double> straight = Vector<double>::Zero(static_cast<Eigen::Index>(n));
    Brancher<Nominal> brancher(model, {Control::force, {0, 0}, {-1, 0}}, straight);
    const auto tree = branch_tree(brancher, {brancher.start(0, straight)}, {0, 6 / reach, longest});
    CHECK(tree.size() > 1);
    for (std::size_t b = 1; b < tree.size(); ++b) {
      const auto crossings =
          std::count_if(tree[b].events.begin(), tree[b].events.end(),
                        [](const auto& event) { return event.kind == EventKind::bifurcation; });
      CHECK(crossings == 1);
      CHECK(tree[b].events.size() == 1);
    }
  }
}

TEST_CASE("what counts as the same place follows the precision that is set at run time") {
  const unsigned before = Mpfr::default_precision();
  for (const unsigned digits : {20U, 60U}) {
    Mpfr::default_precision(digits);
    using Model = NominalModel<Mpfr>;
    const Model model(Chain<Mpfr>({1, 1}, {1, 1}));
    const Vector<Mpfr> straight = Vector<Mpfr>::Zero(2);
    Brancher<Model> brancher(model, {Control::force, {0, 0}, {-1, 0}}, straight);
    const Branch<Mpfr> branch{
        {brancher.start(Mpfr(0), straight), brancher.start(Mpfr(1) / 4, straight)}, {}, BranchEnd::load};
    BranchPoint<Mpfr> beside = brancher.start(Mpfr(1) / 8, straight);
    // between 1000 sqrt(eps) of 20 digits, 1e-7, and of 60, 1e-27
    beside.theta(0) += pow(Mpfr(10), -15);
    CHECK(lies_on(brancher, branch, beside) == (digits == 20));
  }
  Mpfr::default_precision(before);
}

TEST_CASE(
    "a place between any two points of a branch lies on it, one beyond its ends or of its mirror image not") {
  const std::vector<double> rest{0.3, -0.5, 0.4};
  const auto traced = [](const std::vector<double>& bent) {
    const Nominal model(Chain<double>({1, 0.8, 1.2}, {1, 2, 1}, bent));
    const auto shape = absolute_angles(bent);
    Brancher<Nominal> brancher(model, {Control::force, {0, 0}, {-1, 0}}, shape);
    return Tracer<Nominal>(brancher, {0, 0.5}).run(brancher.start(0, shape));
  };
  const Nominal model(Chain<double>({1, 0.8, 1.2}, {1, 2, 1}, rest));
  Brancher<Nominal> brancher(model, {Control::force, {0, 0}, {-1, 0}}, absolute_angles(rest));
  const auto branch = traced(rest), mirrored = traced({-0.3, 0.5, -0.4});
  REQUIRE(branch.points.size() > 3);
  for (std::size_t i = 1; i < branch.points.size(); ++i) {
    const auto &a = branch.points[i - 1], &b = branch.points[i];
    const double way = brancher.product({b.theta - a.theta, {0, 0}, b.load - a.load}, a.tangent);
    CAPTURE(i);
    for (const double share : {0.01, 0.5, 0.99}) {
      const auto between = brancher.step(a, share * way);
      REQUIRE(between);
      CHECK(lies_on(brancher, branch, *between));
      CHECK_FALSE(lies_on(brancher, mirrored, *between));
    }
  }
  const auto before = brancher.step(branch.points.front(), -0.02),
             behind = brancher.step(branch.points.back(), 0.02);
  REQUIRE(before);
  REQUIRE(behind);
  CHECK_FALSE(lies_on(brancher, branch, *before));
  CHECK_FALSE(lies_on(brancher, branch, *behind));
}

TEST_CASE("a chain is straight where no joint is bent at rest, the first and the last included") {
  const std::vector<double> ones(3, 1);
  CHECK(is_straight(Chain<double>(ones, ones)));
  for (std::size_t bent = 0; bent < 3; ++bent) {
    std::vector<double> rest(3, 0);
    rest[bent] = -0.1;
    CHECK_FALSE(is_straight(Chain<double>(ones, ones, rest)));
  }
}
