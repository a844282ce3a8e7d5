#include <plumbline/branch/trace.hpp>
#include <plumbline/chain/strain_energy.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "tests/close_to.hpp"
#include "tests/property.hpp"

using namespace plumbline;

namespace {

/// A chain of up to nine links in a plane, bent at rest, loaded along a ray.
struct Bench {
  Chain<double> chain;
  Loading<double> loading;
  double last, reach;
};

Bench random_bench() {
  const bool held = *rc::gen::arbitrary<bool>();
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(held ? 2 : 1, 10));
  std::vector<double> length, stiffness, rest;
  double reach = 0;
  for (std::size_t i = 0; i < n; ++i) {
    length.push_back(random_hundredths(0, 2) + 0.3);
    stiffness.push_back(random_hundredths(0, 3) + 0.3);
    rest.push_back(random_hundredths(-1, 1) + 0.005);  // never straight: at the edge of its reach
    reach += length.back();
  }
  if (held && n > 2 && *rc::gen::arbitrary<bool>()) stiffness[0] = 0;
  const Chain<double> chain(length, stiffness, rest);
  const double way = random_hundredths(0, 6), last = held ? (random_hundredths(0, 1) + 0.1) * reach / 2
                                                          : (random_hundredths(0, 8) + 1) / reach;
  const Point<double> start =
      held ? end_point(chain, rest)
           : Point<double>{0.1 * random_hundredths(-1, 1) / reach, 0.1 * random_hundredths(-1, 1) / reach};
  return {chain,
          {held ? Control::end_point : Control::force, start, {std::cos(way), std::sin(way)}},
          last,
          reach};
}

/// What follows the branches of a bench, and where they start: unloaded.
struct Start {
  Bench bench = random_bench();
  NominalModel<double> model{bench.chain};
  Brancher<NominalModel<double>> brancher{model, bench.loading, absolute_angles(bench.chain.rest())};
  BranchPoint<double> point = brancher.start(0, absolute_angles(bench.chain.rest()));

  Branch<double> follow(double longest) {
    return Tracer<NominalModel<double>>(brancher, {0, bench.last, longest, 100000}).run(point);
  }
};

/// Torque and place out of balance, beside the terms that they are sums of.
template <class Real>
Real imbalance(const NominalModel<Real>& model, const Loading<Real>& loading, const BranchPoint<Real>& point,
               const Real& reach) {
  using std::abs, std::max;
  Expansion<Real, 1> at;
  model.expand(point.theta, point.force, at);
  const Real force = abs(point.force.x) + abs(point.force.y);
  const Real moment = force * reach + at.hessian.row(0).cwiseAbs().maxCoeff();
  const Point<Real> wanted = loading.at(point.load);
  const bool held = loading.control == Control::end_point;
  const Real off = held ? abs(at.end_point.x - wanted.x) + abs(at.end_point.y - wanted.y)
                        : abs(point.force.x - wanted.x) + abs(point.force.y - wanted.y);
  return max(Real(at.residual.cwiseAbs().maxCoeff() / moment), Real(off / (held ? reach : Real(force + 1))));
}

}  // namespace

TEST_CASE("a series is the branch: within its reach every place is an equilibrium to rounding") {
  check_property("imbalance, energy and stiffness along a series", [] {
    Start start;
    auto& [bench, model, brancher, at] = start;
    brancher.refresh(at);
    BranchSeries<double> series;
    brancher.expand(at, series);
    const double s = std::min(series.reach, 0.5) * random_hundredths(-1, 1);
    const auto point = brancher.along(series, s);
    // order + 1 terms a quantity, each rounded once, twice over by Horner's scheme, and the truncation
    const double rounding = 4 * static_cast<double>(series.order()) * std::numeric_limits<double>::epsilon();
    RC_ASSERT(imbalance(model, bench.loading, point, bench.reach) < rounding);
    const double energy = strain_energy(bench.chain, joint_angles(point.theta));
    RC_ASSERT(std::abs(point.energy - energy) < rounding * (1 + energy));
    const auto exact = brancher.onto(point, 1e-6);
    RC_ASSERT(exact.has_value());
    RC_ASSERT(std::abs(exact->stiffness - point.stiffness) < 1e-9 * (1 + std::abs(exact->stiffness)));
  });
}

TEST_CASE("an expansion does not depend on the order of the one before it") {
  const Chain<double> chain(std::vector<double>(9, 1), std::vector<double>(9, 1),
                            std::vector<double>(9, 0.1));
  const NominalModel<double> model(chain);
  const Vector<double> shape = absolute_angles(chain.rest());
  const auto after = [&](std::initializer_list<Eigen::Index> orders) {
    Brancher<NominalModel<double>> brancher(model, {Control::force, {0, 0}, {-1, 0}}, shape);
    const auto point = brancher.start(0.01, shape);
    BranchSeries<double> series;
    for (const Eigen::Index order : orders) {
      series = BranchSeries<double>(order);
      brancher.refresh(point);
      brancher.expand(point, series);
    }
    return series;
  };
  const auto alone = after({20});
  for (const auto& series : {after({4, 20}), after({30, 20})}) {
    CHECK(series.reach == alone.reach);
    for (Eigen::Index k = 0; k <= 20; ++k) {
      for (int q = 0; q < BranchSeries<double>::quantities; ++q) {
        const auto quantity = BranchSeries<double>::Quantity(q);
        CHECK(series.coefficient(quantity, k) == alone.coefficient(quantity, k));
      }
    }
  }
}

TEST_CASE(
    "tangent stiffness is force over way, and by second derivatives where both turn back, however small") {
  // of one link with its end point held along x: powers of s of the force and of the way
  const auto stiffness = [](const std::vector<double>& force, const std::vector<double>& way, double s) {
    BranchSeries<double> series(4);
    const auto term = [&](std::size_t k) {
      return Variation<double>{Vector<double>::Zero(1), {force[k], 0}, way[k]};
    };
    series.begin(term(0), {0, 0});
    for (std::size_t k = 1; k < 5; ++k) series.set(static_cast<Eigen::Index>(k), term(k), {0, 0});
    series.complete(0, {Control::end_point, {0, 0}, {1, 0}});
    return series.stiffness(s);
  };
  // (s - 1/2)^2 (s^2 + 3) and (s - 1/2)^2 (s + 2): second derivatives 2 (s^2 + 3) = 13 / 2 and 2 (s + 2) = 5
  const std::vector<double> turning{0.75, -3, 3.25, -1, 1}, back{0.5, -1.75, 1, 1, 0};
  const std::vector<double> straight{0, 3, 0, 0, 0}, bent{0, 1, 2, 3, 4};
  // all are sums of few bits, but for one quotient
  CHECK(stiffness(turning, back, 0.5) == close_to(1.3).epsilon(1e-15));
  // sums as large as they are small: the sign of a turn is told beside its own second derivative
  const auto scaled = [](std::vector<double> x, double by) {
    for (double& one : x) one *= by;
    return x;
  };
  const double tiny = 0x1p-30;
  CHECK(stiffness(scaled(turning, tiny), scaled(back, tiny), 0.5) == close_to(1.3).epsilon(1e-15));
  // a hundredth beside the turn: the quotient of the slopes, (2 (s^2 + 3) + 2 s (s - 1/2)) / (2 (s + 2) + s -
  // 1/2)
  for (const double unit : {1.0, tiny, 1 / tiny}) {
    const double s = 0.51, expected = (2 * (s * s + 3) + 2 * s * 0.01) / (2 * (s + 2) + 0.01);
    // the slopes are differences a hundred times less than their terms
    CHECK(stiffness(scaled(turning, unit), scaled(back, unit), s) == close_to(expected).epsilon(1e-12));
  }
  // where one of them alone turns back it is zero, or infinite
  CHECK(stiffness(turning, straight, 0.5) == 0);
  CHECK(std::isinf(stiffness(straight, turning, 0.5)));
  // s + 2 s^2 + 3 s^3 + 4 s^4 at 1/2: 1 + 2 + 9/4 + 2 = 29/4
  CHECK(stiffness(bent, straight, 0.5) == close_to(29.0 / 12).epsilon(1e-15));
}

TEST_CASE("the type of a point inside a stride is that of its own matrix") {
  check_property("negative directions along a branch", [] {
    Start start;
    const auto branch = start.follow(0.02);
    RC_ASSERT(branch.end != BranchEnd::degenerate);
    for (const auto& point : branch.points) {
      const auto alone = start.brancher.onto(point, 1e-6);
      RC_ASSERT(alone.has_value());
      const bool at_fold =
          std::abs(point.tangent.load) < 1e-6 * start.brancher.load_scale();  // rounding decides
      RC_ASSERT(at_fold || alone->negative_directions == point.negative_directions);
    }
  });
}

TEST_CASE("what happens on a branch does not depend on the spacing of its points") {
  check_property("events with points 0.05 and 0.003 apart", [] {
    Start start;
    const auto wide = start.follow(0.05), fine = start.follow(0.003);
    RC_ASSERT(wide.end == fine.end);
    RC_ASSERT(wide.events.size() == fine.events.size());
    for (std::size_t i = 0; i < wide.events.size(); ++i) {
      RC_ASSERT(wide.events[i].kind == fine.events[i].kind);
      RC_ASSERT(std::abs(wide.events[i].point.load - fine.events[i].point.load) < 1e-9 * start.bench.reach);
    }
  });
}

TEST_CASE("fifty digits take a higher order, not shorter strides") {
  using Exact = NominalModel<Mpfr50>;
  const Chain<Mpfr50> chain({1, 1, 1, 1}, {1, 1, 1, 1},
                            {Mpfr50("-0.2417"), Mpfr50("0.6821"), Mpfr50("-0.7958"), Mpfr50("0.517")});
  const Exact model(chain);
  const Vector<Mpfr50> shape = absolute_angles(chain.rest());
  const Loading<Mpfr50> loading{Control::end_point, {Mpfr50("3.8"), 0}, {-1, 0}};
  Brancher<Exact> brancher(model, loading, shape);
  const auto branch = Tracer<Exact>(brancher, {0, Mpfr50("1.5"), 1}).run(brancher.start(0, shape));
  CHECK(branch.end == BranchEnd::load);
  CHECK(branch.points.size() < 30);
  for (const auto& point : branch.points)
    CHECK(imbalance(model, loading, point, Mpfr50(4)) < Mpfr50("1e-48"));
  REQUIRE(branch.events.size() == 1);
  CHECK(branch.events[0].kind == EventKind::quasi_buckling);
}
