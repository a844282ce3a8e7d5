#include "diagnose/inference/start.hpp"

#include <doctest/doctest.h>

#include "tests/diagnose/arms.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

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

TEST_CASE("fits of one parameter start at nothing and a scale to either side, within its bounds") {
  const Study study(full_bench());
  const auto from = [&](double low, double high) {
    const Effect row = with_range(2, low, high);
    const InitialGuesses known = initial_guesses(study, EffectAt(row));
    CHECK(known.refined == 3);
    return known.points;
  };
  using Vectors = std::vector<std::vector<double>>;
  CHECK(from(-3, 3) == Vectors{{0}, {2}, {-2}});
  CHECK(from(0, 3) == Vectors{{0}, {2}});
  CHECK(from(-3, 1) == Vectors{{0}, {-2}});
  CHECK(from(-2, 2) == Vectors{{0}});  // not from a bound, where a fit may stay
}

TEST_CASE("an arm in space rests near its command: fits of one parameter start at nothing alone") {
  const Study study(arm_bench(industrial_arm(), 2));
  const Effect row = with_range(2, -3, 3);
  CHECK(initial_guesses(study, EffectAt(row)).points == std::vector<std::vector<double>>{{0}});
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
  CHECK(both.refined == 3);
  CHECK(initial_guesses(study, Candidate{{EffectAt(stated), EffectAt(one)}}).refined == 3);
  CHECK(initial_guesses(study, Candidate{{EffectAt(one), EffectAt(stated)}}).refined == 3);
  CHECK(initial_guesses(study, Candidate{}).points == Vectors{{}});
  Effect many = with_range(1, -1, 1);
  many.parameters = [](const Place&) {
    return std::vector<ParameterRange>(3, {"a", "ratio", Coordinate::plain, 1, -1, 1});
  };
  CHECK(initial_guesses(study, EffectAt(many)).points == Vectors{{0, 0, 0}});
}
