#include "diagnose/inference/least_squares.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "diagnose/decision/rival.hpp"
#include "diagnose/design/separation.hpp"
#include "diagnose/inference/start.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// What rounding may leave of numbers of about one.
constexpr double of_rounding = 1e-12;

/// A fit of so many parameters, none at a bound, that leaves these residuals.
Fit fit_leaving(const Eigen::MatrixXd& jacobian, std::vector<double> whitened) {
  Fit fit;
  fit.jacobian = jacobian;
  fit.whitened = std::move(whitened);
  fit.at_bound.assign(static_cast<std::size_t>(jacobian.cols()), false);
  return fit;
}

/// A row of an effect with one parameter, of which a test asks where fits of it start.
Effect with_range(double scale, double low, double high) {
  Effect row;
  row.id = "made_up";
  row.parameters = [=](const Place&) {
    return std::vector<ParameterRange>{{"a", "ratio", Coordinate::plain, scale, low, high}};
  };
  return row;
}

}  // namespace

TEST_CASE("least squares of three values on two columns, by hand") {
  const Eigen::MatrixXd columns{{1.0, 0.0}, {1.0, 1.0}, {1.0, 2.0}};
  const LeastSquares line(columns);
  CHECK(line.rank() == 2);
  // 1, 2, 6: the slope is 5 / 2, the middle 3
  const Eigen::VectorXd found = line.solve(Eigen::Vector3d(1, 2, 6));
  CHECK(found(0) == close_to(0.5));
  CHECK(found(1) == close_to(2.5));
  const Eigen::MatrixXd basis = line.orthonormal();
  REQUIRE(basis.rows() == 3);
  REQUIRE(basis.cols() == 2);
  CHECK((basis.transpose() * basis - Eigen::Matrix2d::Identity()).norm() < of_rounding);
  CHECK((columns - basis * (basis.transpose() * columns)).norm() < of_rounding);
}

TEST_CASE("a column that depends on others does not count; none at all are no columns") {
  const LeastSquares twice(Eigen::MatrixXd{{1.0, 2.0}, {1.0, 2.0}, {0.0, 0.0}});
  CHECK(twice.rank() == 1);
  const Eigen::VectorXd found = twice.solve(Eigen::Vector3d(3, 5, 7));
  CHECK(found(0) + 2 * found(1) == close_to(4));
  CHECK(found.array().abs().minCoeff() == 0);
  const LeastSquares nothing(Eigen::MatrixXd::Zero(3, 2));
  CHECK(nothing.rank() == 0);
  CHECK(nothing.solve(Eigen::Vector3d(1, 2, 3)) == Eigen::Vector2d(0, 0));
  const LeastSquares none(Eigen::MatrixXd(3, 0));
  CHECK(none.rank() == 0);
  CHECK(none.solve(Eigen::Vector3d(1, 2, 3)).size() == 0);
  CHECK(none.orthonormal().size() == 0);
}

TEST_CASE("a triangular factor has the lengths and angles of its columns") {
  const Eigen::MatrixXd columns{{1.0, -2.0}, {0.5, 1.0}, {3.0, 4.0}, {0.0, 1.0}};
  const Eigen::MatrixXd factor = triangular_factor(columns);
  REQUIRE(factor.rows() == 2);
  CHECK(factor(1, 0) == 0);
  CHECK((factor.transpose() * factor - columns.transpose() * columns).norm() < 40 * of_rounding);
  const Eigen::MatrixXd wide = triangular_factor(Eigen::MatrixXd{{3.0, 1.0, 2.0}, {4.0, 0.0, 1.0}});
  CHECK(wide.rows() == 2);
  CHECK(std::abs(wide(0, 0)) == close_to(5));
}

TEST_CASE("what one explanation predicts beyond another is its residual less") {
  const Eigen::MatrixXd slope{{1.0, 0.0}, {0.0, 2.0}, {1.0, 1.0}};
  const Fit truth = fit_leaving(slope, {0.5, -1, 2});
  Fit imitator = fit_leaving(slope, {1, 1, 1});
  LinearisedAlternative rows = linearised_alternative(truth, imitator);
  CHECK(rows.difference == Eigen::Vector3d(0.5, 2, -1));
  CHECK(rows.slope == slope);
  // Normal equations of two columns: sums (2, 1; 1, 5), (-0.5, 3); the step is (-5.5, 6.5) / 9.
  const double left = 0.25 + 4 + 1 - (-0.5 * -5.5 + 3 * 6.5) / 9;
  CHECK(separation(rows) == close_to(left));
  imitator.at_bound = {false, true};
  rows = linearised_alternative(truth, imitator);
  CHECK(rows.slope.col(0) == slope.col(0));
  CHECK(rows.slope.col(1).norm() == 0);
  CHECK(separation(rows) == close_to(5.25 - 0.25 / 2));
  imitator.at_bound = {true, false};
  CHECK(separation(linearised_alternative(truth, imitator)) == close_to(5.25 - 9.0 / 5));
  imitator.at_bound = {true, true};
  CHECK(separation(linearised_alternative(truth, imitator)) == close_to(5.25));
}

TEST_CASE("a separation does not depend on the units of parameters, on rows that matter, or on their order") {
  Eigen::MatrixXd slope{{1.0, 2.0}, {0.0, 1.0}, {3.0, -1.0}, {1.0, 1.0}, {2.0, 0.5}};
  const Eigen::VectorXd difference{{1.0, -2.0, 0.5, 3.0, 1.0}};
  const double whole = separation({difference, slope});
  CHECK(whole > 1);
  Eigen::MatrixXd other = slope;
  other.col(0) *= 1e-9;
  other.col(1) *= 1e6;
  CHECK(separation({difference, other}) == close_to(whole).epsilon(1e-9));
  const LinearisedAlternative fewer = reduced({difference, slope});
  CHECK(fewer.slope.rows() == 3);
  CHECK(fewer.slope.cols() == 2);
  CHECK(separation(fewer) == close_to(whole).epsilon(1e-9));
  const LinearisedAlternative both =
      stacked({difference.head(2), slope.topRows(2)}, {difference.tail(3), slope.bottomRows(3)});
  CHECK(both.difference == difference);
  CHECK(both.slope == slope);
  CHECK(separation({difference, Eigen::MatrixXd(5, 0)}) == close_to(1 + 4 + 0.25 + 9 + 1));
  CHECK(separation({difference, Eigen::MatrixXd::Zero(5, 1)}) == close_to(15.25));
}

TEST_CASE("fits of one parameter start at nothing and a scale to either side, within its bounds") {
  const Study study(full_bench());
  const auto from = [&](double low, double high) {
    const Effect row = with_range(2, low, high);
    const InitialGuesses known = initial_guesses(study, EffectAt(row));
    CHECK(known.refined == 1);
    return known.points;
  };
  using Vectors = std::vector<std::vector<double>>;
  CHECK(from(-3, 3) == Vectors{{0}, {2}, {-2}});
  CHECK(from(0, 3) == Vectors{{0}, {2}});
  CHECK(from(-3, 1) == Vectors{{0}, {-2}});
  CHECK(from(-2, 2) == Vectors{{0}});  // not from a bound, where a fit may stay
}

TEST_CASE("starts of several effects are all combinations, in the order of the effects") {
  const Study study(full_bench());
  const Effect one = with_range(2, 0, 3), other = with_range(5, -9, 9);
  Effect stated = with_range(1, -1, 0.5);
  std::size_t asked_joint = 9;
  stated.initial_guesses = [&](const Place& at, const Excitation&) {
    asked_joint = at.joint;
    return InitialGuesses{{{-3}, {0.25}, {4}}, 2};
  };
  using Vectors = std::vector<std::vector<double>>;
  CHECK(initial_guesses(study, EffectAt(stated, 3)).points == Vectors{{-1}, {0.25}, {0.5}});
  CHECK(asked_joint == 2);
  CHECK(initial_guesses(study, EffectAt(stated)).refined == 2);
  CHECK(asked_joint == 0);
  const InitialGuesses both = initial_guesses(study, Candidate{{EffectAt(one), EffectAt(other)}});
  CHECK(both.points == Vectors{{0, 0}, {0, 5}, {0, -5}, {2, 0}, {2, 5}, {2, -5}});
  CHECK(both.refined == 1);
  CHECK(initial_guesses(study, Candidate{{EffectAt(stated), EffectAt(one)}}).refined == 2);
  CHECK(initial_guesses(study, Candidate{{EffectAt(one), EffectAt(stated)}}).refined == 2);
  CHECK(initial_guesses(study, Candidate{}).points == Vectors{{}});
  Effect many = with_range(1, -1, 1);
  many.parameters = [](const Place&) {
    return std::vector<ParameterRange>(3, {"a", "ratio", Coordinate::plain, 1, -1, 1});
  };
  CHECK(initial_guesses(study, EffectAt(many)).points == Vectors{{0, 0, 0}});
}

TEST_CASE("an effect covers itself at its place and its special cases") {
  CHECK(covers({"backlash", 2}, {"backlash", 2}));
  CHECK_FALSE(covers({"backlash", 2}, {"backlash", 1}));
  CHECK(covers(EffectAt("direction_friction"), EffectAt("joint_friction")));
  CHECK_FALSE(covers(EffectAt("joint_friction"), EffectAt("direction_friction")));
}

TEST_CASE("an effect with five values and more has many, but for machining as a whole") {
  const Study study(full_bench());
  const auto rows = [](std::size_t values) {
    Effect row = with_range(1, -1, 1);
    row.parameters = [values](const Place&) {
      return std::vector<ParameterRange>(values, {"a", "ratio", Coordinate::plain, 1, -1, 1});
    };
    return row;
  };
  const Effect four = rows(4), five = rows(5), six = rows(6);
  CHECK(many_valued(study, {{EffectAt(four)}}) == 0);
  CHECK(many_valued(study, {{EffectAt(five)}}) == 1);
  CHECK(many_valued(study, {{EffectAt(five), EffectAt(four), EffectAt(six)}}) == 2);
  const std::vector<double> rest(6, 0.1);
  Experiment long_chain = three_links();
  long_chain.link_length.assign(6, 0.1);
  long_chain.joint_stiffness.assign(6, 1);
  long_chain.link_mass.assign(6, 0);
  press(long_chain, rest, {-0.01, 0}, 8, true);
  const Study six_joints(long_chain);
  CHECK(many_valued(six_joints, {{EffectAt("stiffness_spread")}}) == 1);
  const Candidate machining{{{"stiffness_spread"}, {"length_spread"}, {"rest_spread"}}};
  REQUIRE(machining.has_all_tolerances());
  CHECK(many_valued(six_joints, machining) == 0);
}
