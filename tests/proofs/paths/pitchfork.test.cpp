#include "proofs/paths/pitchfork.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <plumbline/branch/trace.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "proofs/exact/as_double.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/paths/joined_branches.hpp"
#include "proofs/paths/unfolding.hpp"
#include "tests/close_to.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

struct Path {
  Chain<Rational> chain;
  Control control;
  double last;
  bool all = false;  ///< branches, not the slow loading alone
};

/// What is proved of a load along -x.
JoinedBranches proved(const Path& path) {
  const auto exact = from_rational<Interval>(path.chain);
  Loading<Interval> loading{path.control, {0, 0}, {-1, 0}};
  if (path.control == Control::end_point) loading.start = end_point(exact, exact.rest());
  const Point<double> start{as_double(loading.start.x), as_double(loading.start.y)};
  const PathTask task{convert<double>(exact, as_double), {path.control, start, {-1, 0}}, path.last, 0.05};
  return certify(path.all ? follow_all(task) : follow_slowly(task), exact, loading,
                 symmetries(path.chain, path.control, {-1, 0}));
}

std::vector<Rational> decimals(const std::vector<const char*>& texts) {
  std::vector<Rational> values;
  for (const char* text : texts) values.push_back(*parse_decimal(text));
  return values;
}

}  // namespace

TEST_CASE("a symmetric chain's path goes through its pitchfork without a gap, in any units") {
  const Rational large(1000000000), small(1, 1000000000);
  const std::vector<Path> paths{
      {Chain<Rational>({1, 1, 1}, {0, 1, 1}, decimals({"-0.1", "0.3", "-0.3"})), Control::end_point, 0.1},
      {Chain<Rational>({1, Rational(7, 10), 1}, {0, 2, 2}, decimals({"0.1", "0.2", "-0.2"})),
       Control::end_point, 0.3},
      {Chain<Rational>({1, 1, 1, 1}, {0, 1, 2, 1}, decimals({"0", "0.3", "0", "-0.3"})), Control::end_point,
       0.5},
      {Chain<Rational>({1, 1, 1, 1, 1}, {0, 1, 2, 2, 1}, decimals({"0", "0.3", "-0.2", "0.2", "-0.3"})),
       Control::end_point, 0.7},
      {Chain<Rational>({large, large, large}, {0, small, small}, decimals({"-0.1", "0.3", "-0.3"})),
       Control::end_point, 1e8},
      {Chain<Rational>({1, 1, 1}, {1, 1, 1}), Control::force, 0.5},
      {Chain<Rational>({1, 2, Rational(1, 2), 1}, {1, 2, 1, 3}), Control::force, 0.5}};
  for (const Path& path : paths) {
    const JoinedBranches joined = proved(path);
    REQUIRE(joined.branches.size() == 2);
    REQUIRE(joined.forks.size() == 1);
    const ProvedFork& fork = joined.forks[0];
    CHECK(fork.load.width() < 1e-10 * path.last);
    CHECK(fork.symmetric.size() == 1);
    CHECK(fork.bent.size() == 1);
    for (const PathCertificate& part : joined.branches) {
      REQUIRE(part.certified());
      CHECK(part.gaps.empty());
    }
    CHECK(joined.branches[0].runs.back().to < fork.load.low);
  }
}

TEST_CASE("all branches of a symmetric chain: both that cross go through the pitchfork") {
  const Path path{Chain<Rational>({1, 1, 1}, {0, 1, 1}, decimals({"-0.1", "0.3", "-0.3"})),
                  Control::end_point, 0.1, true};
  const JoinedBranches joined = proved(path);
  REQUIRE(joined.forks.size() == 1);
  CHECK(joined.forks[0].symmetric.size() == 2);
  CHECK(joined.forks[0].bent.size() == 2);
  for (const PathCertificate& part : joined.branches) CHECK(part.gaps.empty());
}

TEST_CASE("a chain that is symmetric but for one unit in a far digit has no pitchfork, and that is proved") {
  const std::vector<std::pair<const char*, bool>> bends{
      {"-0.2999999999999999", true},
      {"-0.300000000000000000000000000001", true},
      {"-0.3000000000000000000000000000000000000000000001", true},
      // beyond what 64 digits tell apart
      {"-0.3000000000000000000000000000000000000000000000000000"
       "000000000000000000000000000000000000000000000001",
       false}};
  for (const auto& [bend, decided] : bends) {
    CAPTURE(bend);
    const JoinedBranches open = proved(
        {Chain<Rational>({1, 1, 1}, {0, 1, 1}, decimals({"0", "0.3", bend})), Control::end_point, 0.1});
    CHECK(open.forks.empty());
    REQUIRE(open.branches[0].gaps.size() == 1);
    CHECK(open.branches[0].gaps[0].unfolded == decided);
  }
  // what is left open is told in the units of the chain
  const Rational large(1000000000);
  const auto bends_by = decimals({"0", "0.3", "-0.2999999999999999"});
  const auto gaps = [&](const Rational& unit) {
    const double last = 0.1 * static_cast<double>(unit);
    return proved({Chain<Rational>({unit, unit, unit}, {0, 1, 1}, bends_by), Control::end_point, last})
        .branches[0]
        .gaps;
  };
  const auto plain = gaps(1), scaled = gaps(large);
  REQUIRE(plain.size() == 1);
  REQUIRE(scaled.size() == 1);
  // strides in other units are others, so that the ends agree to a share of the loads alone
  CHECK(scaled[0].loads.low == close_to(1e9 * plain[0].loads.low).epsilon(1e-2));
  CHECK(scaled[0].loads.high == close_to(1e9 * plain[0].loads.high).epsilon(1e-2));
  // not straight by as little, and loaded from the side by as little
  const Chain<Rational> bent({1, 1, 1}, {1, 1, 1}, decimals({"0", "1e-30", "0"}));
  const JoinedBranches under_force = proved({bent, Control::force, 0.3});
  REQUIRE(under_force.branches[0].gaps.size() == 1);
  CHECK(under_force.branches[0].gaps[0].unfolded);
}

TEST_CASE("where two branches cross, and where none passes another, nothing is called unfolded") {
  const auto exact = from_rational<Interval>(Chain<Rational>({1, 1, 1}, {1, 1, 1}));
  const Loading<Interval> push{Control::force, {0, 0}, {-1, 0}};
  Vector<double> crossing = Vector<double>::Zero(4);
  crossing(3) = 0.19806226419516171;  // the least root of det(K - F L), 4 sin^2(pi / 14)
  CHECK_FALSE(unfolded(exact, push, crossing, 1e-5));
  crossing(3) += 1e-3;
  CHECK_FALSE(unfolded(exact, push, crossing, 1e-5));
}

TEST_CASE("a fork joins what lies on its two branches, and no equilibrium of another mode") {
  // three unit links under a force F along -x: K theta = F sin theta
  Eigen::Matrix3d K;
  K << 2, -1, 0, -1, 2, -1, 0, -1, 1;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(K);
  const double critical = modes.eigenvalues()(0);
  const Chain<Rational> chain({1, 1, 1}, {1, 1, 1});
  const Symmetry mirrored = symmetries(chain, Control::force, {-1, 0}).at(0);
  // beside mode j, theta · mode = amplitude; where the force is `from` the load counts from 0
  const auto bent = [&](Eigen::Index j, double amplitude, double from) {
    const Eigen::Vector3d mode = modes.eigenvectors().col(j);
    Eigen::Vector4d u;
    u << amplitude * mode, modes.eigenvalues()(j);
    for (int newton = 0; newton < 8; ++newton) {
      const Eigen::Array3d theta = u.head<3>();
      Eigen::Vector4d f;
      f << K * u.head<3>() - u(3) * theta.sin().matrix(), mode.dot(u.head<3>()) - amplitude;
      Eigen::Matrix4d D = Eigen::Matrix4d::Zero();
      D.topLeftCorner<3, 3>() = K;
      D.topLeftCorner<3, 3>() -= (u(3) * theta.cos()).matrix().asDiagonal();
      D.topRightCorner<3, 1>() = -theta.sin().matrix();
      D.bottomLeftCorner<1, 3>() = mode.transpose();
      u -= D.inverse() * f;
    }
    u(3) += from;
    return PieceEnd{u, 1e-9};
  };
  const auto fork_of = [&](double from, const std::vector<PieceEnd>& ends) {
    Vector<double> crossing = Vector<double>::Zero(4);
    crossing(3) = from + critical;
    return pitchfork(from_rational<Interval>(chain),
                     {Control::force, {Interval::from_double(from), 0}, {-1, 0}}, mirrored, crossing, ends);
  };
  for (const double from : {0.0, 8.0}) {
    CAPTURE(from);
    PieceEnd straight{Vector<double>::Zero(4), 1e-9};
    straight.point(3) = from + 0.97 * critical;
    const auto fork = fork_of(from, {straight, bent(0, 0.05, from)});
    REQUIRE(fork);
    CHECK(fork->load.low <= from + critical);
    CHECK(from + critical <= fork->load.high);
    CHECK(fork->load.width() < 1e-11);
    CHECK(fork->symmetric == std::vector<std::size_t>{0});
    CHECK(fork->bent == std::vector<std::size_t>{1});
    const auto other = fork_of(from, {straight, bent(0, 0.05, from), bent(1, 0.02, from)});
    CHECK_FALSE((other && other->bent.size() == 2));
  }
}

TEST_CASE("a symmetric equilibrium is joined where the loads up to it are proved, and no farther") {
  const Chain<Rational> chain({1, 1, 1}, {0, 1, 1}, decimals({"-0.1", "0.3", "-0.3"}));
  const auto exact = from_rational<Interval>(chain);
  const Loading<Interval> push{Control::end_point, end_point(exact, exact.rest()), {-1, 0}};
  const NominalModel<double> model(convert<double>(exact, as_double));
  const auto rest = absolute_angles(model.chain().rest());
  Brancher<NominalModel<double>> brancher(
      model, {Control::end_point, {as_double(push.start.x), as_double(push.start.y)}, {-1, 0}}, rest);
  const auto zigzag = Tracer<NominalModel<double>>(brancher, {0, 0.1}).run(brancher.start(0, rest));
  REQUIRE(zigzag.events.size() == 1);
  const BranchPoint<double>& symmetric = zigzag.events[0].point;
  BranchPoint<double> bent = symmetric;
  bent.tangent = zigzag.events[0].crossing;
  const auto end = [&](const BranchPoint<double>& from, double h) {
    const auto there = brancher.step(from, h);
    REQUIRE(there);
    Vector<double> u(6);
    u << there->theta, there->force.x, there->force.y, there->load;
    return PieceEnd{u, 1e-9};
  };
  Vector<double> crossing(6);
  crossing << symmetric.theta, symmetric.force.x, symmetric.force.y, symmetric.load;
  // A crossing that is told with a shape off balance is found from there, and none is proved beside it.
  Vector<double> off_balance = crossing;
  off_balance.head(3) += 1e-3 * symmetric.tangent.theta;
  for (const Vector<double>& told : {crossing, off_balance}) {
    const auto fork = pitchfork(exact, push, symmetries(chain, Control::end_point, {-1, 0}).at(0), told,
                                {end(bent, 0.01), end(symmetric, 0.008)});
    REQUIRE(fork);
    // the events of a branch in doubles are right to some 1e-14
    CHECK(std::abs(fork->load.low - symmetric.load) < 1e-11);
    CHECK(std::abs(fork->load.high - symmetric.load) < 1e-11);
  }
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    const auto joined = [&](double h) {
      const auto fork = pitchfork(exact, push, symmetries(chain, Control::end_point, {-1, 0}).at(0), crossing,
                                  {end(bent, 0.01), end(symmetric, side * h)});
      REQUIRE(fork);
      CHECK(fork->bent == std::vector<std::size_t>{0});
      return !fork->symmetric.empty();
    };
    CHECK(joined(0.008));
    // At the load of the crossing alone the operator contracts over boxes that hold equilibria as far as this
    // one. Over all the loads up to its own it does not: the branch may leave such a box on the way, and it
    // is not said to lead here.
    CHECK_FALSE(joined(0.035));
  }
}

TEST_CASE("symmetries are those of the exact numbers") {
  const Chain<Rational> straight({1, 1}, {1, 1}), base({1, 2, 1}, {0, 3, 3});
  CHECK(symmetries(straight, Control::force, {-1, 0}).size() == 1);
  CHECK(symmetries(straight, Control::force, {-1, 1}).empty());
  CHECK(symmetries(base, Control::end_point, {-1, 0}).size() == 3);
  CHECK(symmetries(base, Control::force, {-1, 0}).size() == 1);
  CHECK(
      symmetries(Chain<Rational>({1, 2, Rational(1000001, 1000000)}, {0, 3, 3}), Control::end_point, {-1, 0})
          .size() == 1);
}
