#include <doctest/doctest.h>

#include <plumbline/branch/slow_loading.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "tests/close_to.hpp"

using namespace plumbline;

namespace {

/// A link whose spring, k = 1, is wound up by so many turns while a force along x holds it there, let go as
/// the force weakens to nothing.
struct Unwinding {
  double wound, most;
  std::vector<Branch<double>> stretches;

  explicit Unwinding(int turns) : wound(turns * 2 * std::acos(-1.0)), most(1.2 * wound) {
    const NominalModel<double> model(Chain<double>({1}, {1}, {wound}));
    const Vector<double> start = Vector<double>::Zero(1);
    Brancher<NominalModel<double>> brancher(model, {Control::force, {most, 0}, {-1, 0}}, start);
    stretches = load_slowly(brancher, brancher.start(0, start), {0, most, 0.5});
  }
};

}  // namespace

TEST_CASE("a spring that is wound up lets go turn by turn, as the force that holds it weakens") {
  const Unwinding six(6);
  REQUIRE(six.stretches.size() == 7);
  for (std::size_t turn = 0; turn < 6; ++turn) {
    CAPTURE(turn);
    const auto &fold = six.stretches[turn].points.back(), &after = six.stretches[turn + 1].points.front();
    // by hand: F sin theta = wound - theta, and at the fold 0 = 1 + F cos theta, so F^2 = 1 + (wound -
    // theta)^2; a fold's angle is known to the square root of rounding, 1e-8, and so is its square beside
    // itself
    const double force = six.most - fold.load, left = six.wound - fold.theta(0);
    CHECK(six.stretches[turn].end == BranchEnd::unstable);
    CHECK(force * force == close_to(1 + left * left).epsilon(1e-7));
    // it comes to rest in the next turn, and in none beyond
    const double round = after.theta(0) / (2 * std::acos(-1.0));
    CHECK(round > static_cast<double>(turn + 1) - 1e-9);
    CHECK(round < static_cast<double>(turn + 1) + 0.25);
  }
  // without a force it is as it was
  CHECK(six.stretches.back().points.back().theta(0) == close_to(six.wound).epsilon(1e-14));
}

TEST_CASE("a chain that jumps on and on is given up after 64 jumps") {
  CHECK(Unwinding(63).stretches.size() == 64);
  CHECK_THROWS_WITH_AS(Unwinding(64), "slow loading: found 64 jumps, expected fewer", Error);
}
