#include <doctest/doctest.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <plumbline/branch/bifurcation.hpp>
#include <plumbline/branch/sharpen.hpp>
#include <plumbline/loaded/nominal_model.hpp>
#include <random>

#include "tests/close_to.hpp"

using namespace plumbline;

using Nominal = NominalModel<double>;

namespace {

/// A chain without any symmetry, and a point of it where two branches cross, made backwards: any shape and
/// any direction of the force; the force grown until the bordered matrix of springs and end point is
/// singular; the path of the end point square to what its null vector does there; and last the springs' rest
/// angles so that all of that is in balance.
struct Crossing {
  std::vector<double> length, stiffness, angle;
  Point<double> force;
  Loading<double> loading{Control::end_point, {0, 0}, {1, 0}};
  Vector<double> theta;
  Vector<double> null;                  ///< angles, then force
  Variation<double> first{}, second{};  ///< span the null space of the equations

  /// [K G; G^T 0] of the springs, at the force scaled by s.
  [[nodiscard]] Matrix<double> bordered(double s) const {
    const Nominal model(Chain<double>(length, stiffness, angle));
    Expansion<double, 1> at;
    model.expand(theta, {s * force.x, s * force.y}, at);
    const Eigen::Index n = theta.size();
    Matrix<double> B = Matrix<double>::Zero(n + 2, n + 2);
    for (Eigen::Index i = 0; i < n; ++i) {
      B(i, i) = at.hessian(0, i);
      if (i + 1 < n) B(i + 1, i) = B(i, i + 1) = at.hessian(1, i);
      for (Eigen::Index a = 0; a < 2; ++a) B(i, n + a) = B(n + a, i) = -at.end_point_gradient(i, a);
    }
    return B;
  }

  /// Whether there is one at up to five times the force.
  bool make() {
    const auto sign = [&](double s) { return bordered(s).determinant() > 0; };
    double low = 0, high = 0.05;
    while (sign(low) == sign(high) && high < 5) low = high, high += 0.05;
    if (sign(low) == sign(high)) return false;
    for (int i = 0; i < 100; ++i) (sign((low + high) / 2) == sign(low) ? low : high) = (low + high) / 2;
    force = {high * force.x, high * force.y};
    const Matrix<double> B = bordered(1);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(B, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Index n = theta.size();
    null = svd.matrixV().col(n + 1);
    const double pull = std::hypot(null(n), null(n + 1));
    if (pull < 0.05 || svd.singularValues()(n) < 0.05) return false;
    loading.direction = {-null(n + 1) / pull, null(n) / pull};
    // the load moves the end point along the direction; B has an answer to that, for it is square to `null`
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(n + 2);
    moved(n) = -loading.direction.x, moved(n + 1) = -loading.direction.y;
    Eigen::VectorXd answer = Eigen::VectorXd::Zero(n + 2);
    for (Eigen::Index i = 0; i <= n; ++i)
      answer += svd.matrixV().col(i) * (svd.matrixU().col(i).dot(moved) / svd.singularValues()(i));
    first = {answer.head(n), {answer(n), answer(n + 1)}, 1};
    second = {null.head(n), {null(n), null(n + 1)}, 0};
    return true;
  }

  /// What rounding can make of mu: its terms by their sizes, psi . psi0 = 1 with psi0 the weighted turn of
  /// the null vector, of which the largest is one.
  [[nodiscard]] double rounding(const Brancher<Nominal>& brancher) const {
    Expansion<double, 1> at;
    brancher.model().expand(theta, force, at);
    const Eigen::Index n = theta.size();
    const Vector<double> turn = null.head(n) / null.head(n).cwiseAbs().maxCoeff(),
                         psi0 = brancher.weighted(turn);
    const Vector<double> psi = null.cwiseAbs() / std::abs(psi0.dot(null.head(n)));
    const double push = std::abs(force.x) + std::abs(force.y),
                 most = std::max(1.0, theta.cwiseAbs().maxCoeff());
    double sum = 0, reach = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double link = std::abs(at.end_point_gradient(i, 0)) + std::abs(at.end_point_gradient(i, 1));
      sum += psi(i) * (most * std::abs(at.hessian(0, i)) + push * link);
      reach += link;
    }
    const double unit = psi0.cwiseAbs().maxCoeff() / at.hessian.row(0).cwiseAbs().maxCoeff();
    return std::numeric_limits<double>::epsilon() * (sum + (psi(n) + psi(n + 1)) * reach) * unit;
  }

  /// With rest angles that put the shape in balance.
  [[nodiscard]] Nominal balanced() const {
    Expansion<double, 1> at;
    Nominal(Chain<double>(length, stiffness, angle)).expand(theta, force, at);  // no spring is bent
    std::vector<double> rest = angle;
    double torque = 0;
    for (std::size_t i = length.size(); i-- > 0;) {
      torque -= at.residual(static_cast<Eigen::Index>(i));
      rest[i] -= torque / stiffness[i];
    }
    return Nominal(Chain<double>(length, stiffness, rest));
  }
};

Crossing any_crossing(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto n = static_cast<std::size_t>(3 + random() % 3);
  Crossing at;
  for (std::size_t i = 0; i < n; ++i) {
    at.length.push_back(between(0.5, 1.5));
    at.stiffness.push_back(between(0.5, 2.5));
    at.angle.push_back(between(-1, 1));
  }
  at.theta = absolute_angles(at.angle);
  const double way = between(-3, 3);
  at.force = {std::cos(way), std::sin(way)};
  at.loading.start = end_point(Chain<double>(at.length, at.stiffness, at.angle), at.angle);
  return at;
}

}  // namespace

TEST_CASE("a crossing without symmetry is found where it is, with both its tangents") {
  std::mt19937 random(3);
  int found_there = 0;
  for (int i = 0; i < 400; ++i) {
    Crossing made = any_crossing(random);
    if (!made.make()) continue;
    const Nominal model = made.balanced();
    Brancher<Nominal> brancher(model, made.loading, made.theta);
    Brancher<Nominal>::scale(made.first, 1 / brancher.length(made.first));
    Brancher<Nominal>::scale(made.second, 1 / brancher.length(made.second));
    // from a thousandth beside it, with neither tangent known
    BranchPoint<double> near{};
    near.theta = made.theta + 1e-3 * Vector<double>::Ones(made.theta.size());
    near.force = made.force;
    near.tangent = made.first;
    const auto found = detail::BifurcationSolver<Nominal>(brancher).near(near, made.second);
    // an isolated point has no tangents, and so near none Newton's method may go elsewhere
    if (!found || found->tangents.size() != 2 || (found->point.theta - made.theta).norm() > 1e-2) continue;
    ++found_there;
    CAPTURE(i);
    CHECK(found->simple());
    CHECK((found->point.theta - made.theta).norm() < 1e-8);
    CHECK(std::abs(found->point.load) < 1e-8);
    CHECK(std::abs(brancher.product(found->tangents[0], found->tangents[1])) < 1 - 1e-4);
    CHECK(found->rounding == close_to(made.rounding(brancher)).epsilon(1e-4));
    // a branch departs from its tangent by the square of the way, up to what rounding makes of the crossing
    for (const Variation<double>& tangent : found->tangents) {
      BranchPoint<double> at = found->point;
      at.tangent = tangent;
      const auto departure = [&](double h) {
        const auto on = brancher.step(at, h);
        if (!on) return std::numeric_limits<double>::quiet_NaN();
        return brancher.length(
            {on->theta - at.theta - h * tangent.theta, {0, 0}, on->load - at.load - h * tangent.load});
      };
      const double far = departure(1e-3), close = departure(1e-4);
      CHECK(far == close_to(100 * close).epsilon(0.1));  // but for the third order, a few 1e-3
    }
  }
  CHECK(found_there >= 30);
}

TEST_CASE(
    "a crossing without symmetry in fifty digits: the equations hold, and both tangents leave them alone") {
  using Exact = NominalModel<Mpfr50>;
  std::mt19937 random(5);
  int crossings = 0;
  for (int i = 0; i < 200 && crossings < 5; ++i) {
    Crossing made = any_crossing(random);
    if (!made.make()) continue;
    const Chain<double> chain = made.balanced().chain();
    const auto lifted = [](const std::vector<double>& x) { return std::vector<Mpfr50>(x.begin(), x.end()); };
    const Exact model(Chain<Mpfr50>(lifted(chain.length()), lifted(chain.stiffness()), lifted(chain.rest())));
    const auto wide = [](const Point<double>& p) { return Point<Mpfr50>{Mpfr50(p.x), Mpfr50(p.y)}; };
    const Loading<Mpfr50> loading{Control::end_point, wide(made.loading.start), wide(made.loading.direction)};
    Brancher<Exact> brancher(model, loading, Vector<Mpfr50>(made.theta.cast<Mpfr50>()));
    BranchPoint<double> near{};
    near.theta = made.theta + 1e-3 * Vector<double>::Ones(made.theta.size());
    near.force = made.force;
    near.tangent = made.first;
    const auto found =
        detail::BifurcationSolver<Exact>(brancher).near(lift<Mpfr50>(near), lift<Mpfr50>(made.second));
    // an isolated point has no tangents, and so near none Newton's method may go elsewhere
    if (!found || found->tangents.size() != 2) continue;
    if ((found->point.theta - made.theta.cast<Mpfr50>()).norm() > Mpfr50("1e-2")) continue;
    ++crossings;
    CAPTURE(i);
    const BranchPoint<Mpfr50>& point = found->point;
    Expansion<Mpfr50, 1> at;
    model.expand(point.theta, point.force, at);
    const Point<Mpfr50> wanted = loading.at(point.load);
    // what doubles made is a crossing to their digits, and the moment that makes up for the rest is told
    CHECK(found->imperfection < Mpfr50("1e-12"));
    // all sums are of a few terms of the size of one, each rounded in its fiftieth digit; five are spare
    const Mpfr50 rounding("1e-45");
    CHECK(abs(at.end_point.x - wanted.x) < rounding);
    CHECK(abs(at.end_point.y - wanted.y) < rounding);
    const Eigen::Index n = point.theta.size();
    for (const Variation<Mpfr50>& t : found->tangents) {
      Point<Mpfr50> moved{-t.load * loading.direction.x, -t.load * loading.direction.y};
      for (Eigen::Index j = 0; j < n; ++j) {
        const Mpfr50 x = at.end_point_gradient(j, 0), y = at.end_point_gradient(j, 1);
        Mpfr50 moment = at.hessian(0, j) * t.theta(j) - x * t.force.x - y * t.force.y;
        if (j > 0) moment += at.hessian(1, j - 1) * t.theta(j - 1);
        if (j + 1 < n) moment += at.hessian(1, j) * t.theta(j + 1);
        CHECK(abs(moment) < rounding);
        moved.x += x * t.theta(j);
        moved.y += y * t.theta(j);
      }
      CHECK(abs(moved.x) < rounding);
      CHECK(abs(moved.y) < rounding);
    }
  }
  CHECK(crossings == 5);
}

TEST_CASE(
    "under a force a crossing says what rounding can make of it: torques, and the force on every link") {
  // two links in line: K phi = F L phi, L the lengths; from K (2, -1; -1, 1) and the lengths two and one
  const Chain<double> chain({2, 1}, {1, 1});
  const double F = (2 - std::sqrt(2)) / 2;  // 2 F^2 - 4 F + 1 = 0
  const Nominal model(chain);
  Brancher<Nominal> brancher(model, {Control::force, {0.25, 0}, {-0.5, 0}}, Vector<double>::Zero(2));
  Vector<double> phi(2);
  phi << 1, 2 - 2 * F;
  BranchPoint<double> near{};
  near.theta = Vector<double>::Zero(2);
  near.load = 0.5 + 2 * F + 1e-3;
  near.force = {-F - 5e-4, 0};
  near.tangent = {Vector<double>::Zero(2), {-0.5, 0}, 1};
  Brancher<Nominal>::scale(near.tangent, 1 / brancher.length(near.tangent));
  Variation<double> bend{phi, {0, 0}, 0};
  Brancher<Nominal>::scale(bend, 1 / brancher.length(bend));
  const auto found = detail::BifurcationSolver<Nominal>(brancher).near(near, bend);
  REQUIRE(found);
  CHECK(found->simple());
  CHECK(found->point.load == close_to(0.5 + 2 * F).epsilon(1e-13));
  // weights 2/3 and 1/3; psi = phi / (psi0 . phi); it moves the end point by L . psi
  const Vector<double> turn = phi / phi.maxCoeff();
  const Vector<double> psi0 = (Vector<double>(2) << 2 * turn(0) / 3, turn(1) / 3).finished(),
                       psi = phi / psi0.dot(phi);
  const double H0 = 2 - 2 * F, H1 = 1 - F;
  const double sum = psi(0) * (std::abs(H0) + F * 2) + psi(1) * (std::abs(H1) + F),
               imposed = (2 * psi(0) + psi(1)) * (F + 0.5 * (0.5 + 2 * F));
  const double unit = psi0.maxCoeff() / H0;
  // all but the last digits of F
  CHECK(found->rounding ==
        close_to(std::numeric_limits<double>::epsilon() * (sum + imposed) * unit).epsilon(1e-9));
  CHECK(found->imperfection <= found->rounding);
}
