#include <doctest/doctest.h>

#include <plumbline/branch/slow_loading.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "tests/close_to.hpp"

using namespace plumbline;

namespace {

using Nominal = NominalModel<double>;

Nominal table1(std::vector<double> rest) {
  return Nominal(Chain<double>({1, 1, 1, 1}, {1, 1, 1, 1}, std::move(rest)));
}
const std::vector<double> u_shape{-0.3179, 0.0558, 0.3804, 0.3524}, z_shape{-0.2417, 0.6821, -0.7958, 0.5170};

/// The paper's three-link chain with a passive base, its end point on the x axis, compressed along it.
struct ThreeLinks {
  Nominal model;
  Vector<double> shape;
  Loading<double> loading;
  ThreeLinks(double alpha1, double alpha2) : model(Chain<double>({1, 1, 1}, {0, 1, 1}, {0, alpha1, alpha2})) {
    std::vector<double> q = model.chain().rest();
    const auto p = end_point(model.chain(), q);
    q[0] = -std::atan2(p.y, p.x);
    shape = absolute_angles(q);
    loading = {Control::end_point, {std::hypot(p.x, p.y), 0}, {-1, 0}};
  }
};
const double pi = std::acos(-1.0);

std::vector<BranchEvent<double>> of_kind(const std::vector<BranchEvent<double>>& events, EventKind kind) {
  std::vector<BranchEvent<double>> result;
  for (const auto& event : events) {
    if (event.kind == kind) result.push_back(event);
  }
  return result;
}

}  // namespace

TEST_CASE("along a branch every point is an equilibrium and energy grows by the force's work") {
  const Nominal model = table1(z_shape);
  const auto shape = absolute_angles(model.chain().rest());
  Brancher<Nominal> brancher(model, {Control::end_point, {3.8, 0}, {-1, 0}}, shape);
  const auto error_of_work = [&](double longest) {
    const auto branch = Tracer<Nominal>(brancher, {0, 1.5, longest}).run(brancher.start(0, shape));
    REQUIRE(branch.end == BranchEnd::load);
    CHECK(branch.points.back().load == 1.5);
    Expansion<double, 1> at;
    double error = 0;
    for (std::size_t i = 0; i < branch.points.size(); ++i) {
      const auto& p = branch.points[i];
      model.expand(p.theta, p.force, at);
      CHECK(at.residual.cwiseAbs().maxCoeff() < 1e-13);
      CHECK(std::abs(at.end_point.x - (3.8 - p.load)) < 1e-13);
      if (i == 0) continue;
      // trapezoidal rule with the slopes at both ends: fourth order
      const auto& o = branch.points[i - 1];
      const double h = p.load - o.load;
      const double work = -h * (p.force.x + o.force.x) / 2 + h * h * (o.stiffness - p.stiffness) / 12;
      error += std::abs(p.energy - o.energy - work);
    }
    return error;
  };
  // fourth order, 4^4 = 256, once the longest step and not the horizon rules everywhere
  CHECK(error_of_work(0.005 / 4) < error_of_work(0.005) / 100);
}

TEST_CASE("a symmetric zigzag crosses a bifurcation; a nearly symmetric one turns before it") {
  const ThreeLinks exact(pi / 10, -pi / 10);
  Brancher<Nominal> symmetric(exact.model, exact.loading, exact.shape);
  const auto branch = Tracer<Nominal>(symmetric, {0, 1}).run(symmetric.start(0, exact.shape));
  const auto buckling = of_kind(branch.events, EventKind::bifurcation);
  REQUIRE(buckling.size() == 1);
  CHECK(branch.points.front().negative_directions == 0);
  CHECK(branch.points.back().negative_directions == 1);
  // on the symmetric branch theta = (-a, b, -a) throughout
  for (const auto& p : branch.points) CHECK(std::abs(p.theta(0) - p.theta(2)) < 1e-9);
  const double critical = buckling[0].point.load;
  CHECK_THROWS_WITH_AS(load_slowly(symmetric, branch.points.back(), {0, 1}),
                       "slow loading: found an unstable start, expected a stable one", Error);
  // what the crossing says of itself is what the equations say there, to rounding
  const auto& crossing = buckling[0].point;
  Expansion<double, 1> at;
  exact.model.expand(crossing.theta, crossing.force, at);
  CHECK(at.residual.cwiseAbs().maxCoeff() < 1e-13);
  CHECK(std::abs(at.end_point.x - crossing.end_point.x) < 1e-13);
  CHECK(std::abs(at.end_point.y - crossing.end_point.y) < 1e-13);
  CHECK(std::abs(at.energy - crossing.energy) < 1e-13);

  for (const double off : {1e-3, 1e-6, -1e-6, 1e-8, -1e-10, 1e-12}) {
    CAPTURE(off);
    const ThreeLinks nearly(pi / 10 + off, -pi / 10);
    Brancher<Nominal> brancher(nearly.model, nearly.loading, nearly.shape);
    const auto turned = Tracer<Nominal>(brancher, {0, 1}).run(brancher.start(0, nearly.shape));
    REQUIRE(turned.end == BranchEnd::load);
    CHECK(of_kind(turned.events, EventKind::bifurcation).empty());
    for (const auto& p : turned.points) CHECK(p.negative_directions == 0);
    // it leaves the zigzag to the side of the imperfection, into an arch
    const auto& last = turned.points.back();
    CHECK((last.theta(2) > 0) == (off > 0));
    CHECK(std::abs(last.theta(0) - last.theta(2)) > 1);
    // the bend lies next to the crossing: its distance scales like off^(2/3) (unfolding of a pitchfork)
    for (const auto& p : turned.points) {
      if (p.load < critical - 20 * std::pow(std::abs(off), 2.0 / 3.0))
        CHECK(std::abs(p.theta(0) - p.theta(2)) < 0.1);
    }
  }
}

TEST_CASE("the bifurcation of the symmetric zigzag, to 50 digits") {
  using Exact = NominalModel<Mpfr50>;
  const Mpfr50 angle = boost::math::constants::pi<Mpfr50>() / 10;
  const Chain<Mpfr50> chain({1, 1, 1}, {0, 1, 1}, {0, angle, -angle});
  const Exact model(chain);
  std::vector<Mpfr50> q = chain.rest();
  const auto p = end_point(chain, q);
  q[0] = -atan2(p.y, p.x);
  Vector<Mpfr50> shape = absolute_angles(q);
  Brancher<Exact> brancher(model, {Control::end_point, {sqrt(p.x * p.x + p.y * p.y), 0}, {-1, 0}}, shape);
  const auto branch = Tracer<Exact>(brancher, {Mpfr50(0), Mpfr50(1) / 10}).run(brancher.start(0, shape));
  REQUIRE(branch.events.size() == 1);
  const auto& buckled = branch.events[0].point;
  // By hand: theta = (-a, b, -a); the antisymmetric second variation, on (1, 0, -1) turned into the tangent
  // space, vanishes with the moment balance of one end link: F sin a = k (a + b - angle), where the middle
  // link moves with the tangent: checked here through the determinant of the bordered matrix, in exact 5 x 5
  // form.
  Expansion<Mpfr50, 1> at;
  model.expand(buckled.theta, buckled.force, at);
  Matrix<Mpfr50> K = Matrix<Mpfr50>::Constant(5, 5, Mpfr50(0));
  for (int i = 0; i < 3; ++i) {
    K(i, i) = at.hessian(0, i);
    if (i < 2) K(i + 1, i) = K(i, i + 1) = at.hessian(1, i);
    for (int a = 0; a < 2; ++a) K(i, 3 + a) = K(3 + a, i) = at.end_point_gradient(i, a);
  }
  Mpfr50 determinant(1);
  for (int k = 0; k < 5; ++k) {  // plain elimination, rows exchanged for the largest pivot
    int best = k;
    for (int i = k + 1; i < 5; ++i) {
      if (abs(K(i, k)) > abs(K(best, k))) best = i;
    }
    K.row(best).swap(K.row(k));
    determinant *= K(k, k);
    for (int i = k + 1; i < 5; ++i) {
      const Mpfr50 factor = K(i, k) / K(k, k);
      for (int j = k; j < 5; ++j) K(i, j) -= factor * K(k, j);
    }
  }
  CHECK(abs(determinant) < Mpfr50("1e-46"));
  CHECK(abs(buckled.load - Mpfr50("0.040735331464751")) < Mpfr50("1e-14"));
}

TEST_CASE("folds: one link under a compression that is too much for it snaps when pushed aside") {
  // k = L = 1, Fx = -1.2, Fy = -load: theta = 1.2 sin theta - load cos theta. By hand load = (1.2 sin theta -
  // theta) / cos theta, whose derivative vanishes where 1.2 - cos theta = theta sin theta
  const double at_fold =
      boost::math::tools::bisect([](double t) { return 1.2 - std::cos(t) - t * std::sin(t); }, 0.3, 1.2,
                                 [](double a, double b) { return b - a < 1e-15; })
          .first;
  const double fold_load = (1.2 * std::sin(at_fold) - at_fold) / std::cos(at_fold);
  const Nominal model(Chain<double>({1}, {1}));
  Vector<double> start(1);
  start << 1;
  Brancher<Nominal> brancher(model, {Control::force, {-1.2, 0}, {0, -1}}, start);
  const auto first = brancher.start(0, start);
  REQUIRE(first.negative_directions == 0);
  const auto branch = Tracer<Nominal>(brancher, {-2, 2}).run(first);
  const auto folds = of_kind(branch.events, EventKind::fold);
  REQUIRE(folds.size() == 2);  // there, and back by symmetry: the branch is an S
  CHECK(folds[0].point.load == close_to(fold_load).epsilon(1e-14));
  CHECK(folds[0].point.theta(0) == close_to(at_fold).epsilon(1e-7));
  CHECK(folds[1].point.load == close_to(-fold_load).epsilon(1e-14));
  CHECK(std::abs(folds[0].point.stiffness) < 1e-7);

  const auto history = load_slowly(brancher, first, {-2, 2});
  REQUIRE(history.size() == 2);
  const auto &before = history[0].points.back(), &after = history[1].points.front();
  CHECK(before.load == close_to(fold_load));
  CHECK(std::abs(after.load - before.load) < 1e-5);
  CHECK(after.theta(0) < -0.8);
  const auto total = [](const BranchPoint<double>& at) {
    return at.energy - at.force.x * at.end_point.x - at.force.y * at.end_point.y;
  };
  CHECK(total(after) < total(before));
  CHECK(history[1].points.back().load == 2);
}

TEST_CASE("two folds close together: the points between them are unstable") {
  // one link, k = L = 1, under -1 - e: load = ((1 + e) sin theta - theta) / cos theta nearly e theta -
  // theta^3 / 3, a cusp: folds at theta = +- sqrt(e), with a second derivative of the energy below 0 in
  // between
  const double e = 1e-4;
  const Nominal model(Chain<double>({1}, {1}));
  Vector<double> start(1);
  start << 0.1;
  Brancher<Nominal> brancher(model, {Control::force, {-1 - e, 0}, {0, -1}}, start);
  for (const double longest : {0.003, 0.004, 0.006}) {
    const auto branch = Tracer<Nominal>(brancher, {-1, 1, longest}).run(brancher.start(-1e-3, start));
    CHECK(of_kind(branch.events, EventKind::fold).size() == 2);
    std::size_t between = 0;
    for (const auto& p : branch.points) {
      const double t = p.theta(0), second = 1 - (1 + e) * std::cos(t) - p.load * std::sin(t);
      if (std::abs(second) < 1e-9) continue;  // at a fold either will do
      CHECK(p.negative_directions == (second < 0 ? 1 : 0));
      between += second < 0;
    }
    CHECK(between >= 3);
  }
}

TEST_CASE("a slowly loaded symmetric zigzag leaves to the side it is told, without a jump") {
  const ThreeLinks exact(pi / 10, -pi / 10);
  Brancher<Nominal> brancher(exact.model, exact.loading, exact.shape);
  for (const int side : {1, -1}) {
    const auto history = load_slowly(brancher, brancher.start(0, exact.shape), {0, 1}, side);
    REQUIRE(history.size() == 2);
    const auto &before = history[0].points.back(), &after = history[1].points.front();
    CHECK(std::abs(after.load - before.load) < 1e-5);
    CHECK((after.theta - before.theta).cwiseAbs().maxCoeff() < 0.05);
    const auto& last = history[1].points.back();
    CHECK(last.load == 1);
    CHECK((last.theta(0) > last.theta(2)) == (side > 0));
  }
}

TEST_CASE("quasi-buckling: the stiffness is least where it is said to be") {
  const Nominal model = table1(z_shape);
  const auto shape = absolute_angles(model.chain().rest());
  Brancher<Nominal> brancher(model, {Control::end_point, {3.8, 0}, {-1, 0}}, shape);
  const auto branch = Tracer<Nominal>(brancher, {0, 1.5}).run(brancher.start(0, shape));
  REQUIRE(branch.events.size() == 1);
  CHECK(branch.events[0].kind == EventKind::quasi_buckling);
  const auto least = branch.events[0].point;
  for (const double off : {-0.05, 0.05}) {
    const auto near = brancher.at_load(least, least.load + off);
    REQUIRE(near);
    CHECK(near->stiffness > least.stiffness);
  }
}

TEST_CASE("points close together show no event that is not there") {
  const ThreeLinks exact(pi / 10, -pi / 10);
  Brancher<Nominal> brancher(exact.model, exact.loading, exact.shape);
  for (const double longest : {0.05, 0.005, 0.0005}) {
    const auto branch = Tracer<Nominal>(brancher, {0, 1, longest}).run(brancher.start(0, exact.shape));
    REQUIRE(branch.events.size() == 2);
    CHECK(branch.events[0].kind == EventKind::bifurcation);
    CHECK(branch.events[1].kind == EventKind::quasi_buckling);
  }
}

TEST_CASE("the arches have a stiffness where they leave the zigzag, though force and way both turn there") {
  const ThreeLinks exact(pi / 10, -pi / 10);
  Brancher<Nominal> brancher(exact.model, exact.loading, exact.shape);
  const auto zigzag = Tracer<Nominal>(brancher, {0, 0.1}).run(brancher.start(0, exact.shape));
  BranchPoint<double> at = zigzag.events.at(0).point;
  at.tangent = zigzag.events[0].crossing;
  const auto beside = brancher.step(at, -0.01);
  REQUIRE(beside);
  auto inwards = *beside;
  Brancher<Nominal>::scale(inwards.tangent, beside->tangent.load > 0 ? -1 : 1);
  const auto arches = Tracer<Nominal>(brancher, {0, 0.1}).run(inwards);
  REQUIRE(arches.events.size() == 1);
  // symmetric in the way from the crossing, so 0.01 off it differs by the order of 0.01^2
  CHECK(arches.events[0].point.stiffness == close_to(beside->stiffness).epsilon(1e-3));
}

TEST_CASE("a branch in other units is the same branch, point by point") {
  const auto traced = [](double meter, double newton, const std::vector<double>& rest) {
    const double k = newton * meter;
    const Nominal model(Chain<double>({meter, meter, meter, meter}, {k, k, k, k}, rest));
    const auto shape = absolute_angles(model.chain().rest());
    Brancher<Nominal> brancher(model, {Control::end_point, end_point(model.chain(), rest), {-1, 0}}, shape);
    return Tracer<Nominal>(brancher, {0, 1.5 * meter}).run(brancher.start(0, shape));
  };
  for (const auto& rest : {u_shape, z_shape}) {
    const auto plain = traced(1, 1, rest);
    for (const auto& [meter, newton] : {std::pair{0x1p-10, 0x1p0}, {0x1p0, 0x1p20}, {0x1p9, 0x1p-13}}) {
      CAPTURE(meter);
      CAPTURE(newton);
      const auto scaled = traced(meter, newton, rest);
      REQUIRE(scaled.points.size() == plain.points.size());
      REQUIRE(scaled.events.size() == plain.events.size());
      for (std::size_t i = 0; i < plain.points.size(); ++i) {
        const auto &one = plain.points[i], &other = scaled.points[i];
        // Units that are powers of two round nothing; but of the border's rows others may become pivots, and
        // what differs by rounding (1e-16) is worth more where the branch is as soft as it gets (1e-3).
        CHECK((other.theta - one.theta).cwiseAbs().maxCoeff() < 1e-12);
        CHECK(std::abs(other.load / meter - one.load) < 1e-12);
        CHECK(std::abs(other.force.x / newton - one.force.x) < 1e-12);
        CHECK(std::abs(other.energy / (newton * meter) - one.energy) < 1e-12);
        CHECK(other.negative_directions == one.negative_directions);
      }
    }
  }
}

TEST_CASE("a crossing in other units is the same, with what rounding can make of it") {
  // under a force, and held; the crossing of the symmetric zigzag, and the first one of a straight cantilever
  struct Found {
    std::size_t points;
    double load, theta, force, imperfection, rounding;
  };
  const auto found = [](double meter, double newton, bool held) {
    const double k = newton * meter;
    const ThreeLinks zigzag(pi / 10, -pi / 10);
    const std::vector<double> straight{0, 0, 0};
    const auto& rest = held ? zigzag.model.chain().rest() : straight;
    const Nominal model(Chain<double>({meter, meter, meter}, {held ? 0 : k, k, k}, rest));
    const Loading<double> loading =
        held ? Loading<double>{Control::end_point, {meter * zigzag.loading.start.x, 0}, {-1, 0}}
             : Loading<double>{Control::force, {0, 0}, {-1, 0}};
    const Vector<double> shape = held ? zigzag.shape : Vector<double>(Vector<double>::Zero(3));
    Brancher<Nominal> brancher(model, loading, shape);
    const double unit = held ? meter : newton;
    const auto branch =
        Tracer<Nominal>(brancher, {0, unit * (held ? 0.1 : 0.25)}).run(brancher.start(0, shape));
    REQUIRE(branch.events.size() == 1);
    const auto& event = branch.events[0];
    const auto at = detail::BifurcationSolver<Nominal>(brancher).near(event.point, event.crossing);
    REQUIRE(at);
    CHECK(at->simple());
    // the way to the other side: what is stable has one negative direction more behind the crossing
    CHECK(event.point.negative_directions == 0);
    CHECK(branch.points.back().negative_directions == 1);
    return Found{branch.points.size(),       at->point.load / unit, at->point.theta(0),
                 at->point.force.x / newton, at->imperfection,      at->rounding};
  };
  for (const bool held : {true, false}) {
    CAPTURE(held);
    const Found plain = found(1, 1, held);
    // 4 sin^2(pi / 14), of det(K - F L)
    if (!held) CHECK(std::abs(plain.load - 0.19806226419516171) < 1e-12);
    for (const auto& [meter, newton] : {std::pair{0x1p-10, 0x1p0}, {0x1p0, 0x1p20}, {0x1p9, 0x1p-13}}) {
      CAPTURE(meter);
      CAPTURE(newton);
      const Found scaled = found(meter, newton, held);
      CHECK(scaled.points == plain.points);
      CHECK(std::abs(scaled.load - plain.load) < 1e-12);
      CHECK(std::abs(scaled.theta - plain.theta) < 1e-12);
      CHECK(std::abs(scaled.force - plain.force) < 1e-12);
      CHECK(scaled.rounding ==
            close_to(plain.rounding).epsilon(1e-6));  // a sum of sizes, of a point to 1e-12
      CHECK(scaled.imperfection <= 64 * plain.rounding);
    }
  }
}

TEST_CASE("a cantilever that is bent by a billionth has no crossing, in any units") {
  for (const auto& [meter, newton] :
       {std::pair{1.0, 1.0}, {0x1p-10, 0x1p0}, {0x1p10, 0x1p0}, {0x1p10, 0x1p-10}}) {
    CAPTURE(meter);
    CAPTURE(newton);
    const double k = newton * meter;
    const Nominal straight(Chain<double>({meter, meter, meter}, {k, k, k}));
    const Nominal bent(Chain<double>({meter, meter, meter}, {k, k, k}, {1e-9, 0, 0}));
    const Loading<double> push{Control::force, {0, 0}, {-1, 0}};
    Brancher<Nominal> on(straight, push, Vector<double>::Zero(3)),
        beside(bent, push, Vector<double>::Zero(3));
    const auto branch = Tracer<Nominal>(on, {0, 0.25 * newton}).run(on.start(0, Vector<double>::Zero(3)));
    REQUIRE(branch.events.size() == 1);
    const auto& event = branch.events[0];
    const auto near = detail::BifurcationSolver<Nominal>(beside).near(event.point, event.crossing);
    REQUIRE(near);
    // the moment that would straighten it, a billionth of a joint's stiffness, acts on a mode of about its
    // size
    CHECK(near->imperfection > 1e-10);
    CHECK(near->imperfection < 1e-8);
    CHECK_FALSE(near->simple());
  }
}

TEST_CASE("a held chain's force is bounded up to a million times its own, whichever way it acts") {
  // two unit links and springs: the reach is 2, the joints' softness at rest 1/2 + 1, and so the force 1/3
  const Nominal model(Chain<double>({1, 1}, {1, 1}));
  const Vector<double> straight = Vector<double>::Zero(2);
  Brancher<Nominal> held(model, {Control::end_point, {2, 0}, {-1, 0}}, straight);
  Brancher<Nominal> pushed(model, {Control::force, {0, 0}, {-1, 0}}, straight);
  BranchPoint<double> point{};
  for (const auto& [x, y] :
       {std::pair{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.5, 0.5}, {0.5, -0.5}, {-0.5, -0.5}}) {
    CAPTURE(x);
    CAPTURE(y);
    for (const double million : {0.99e6, 1.01e6}) {
      point.force = {x * million / 3, y * million / 3};
      CHECK(held.force_bounded(point) == (million < 1e6));
      CHECK(pushed.force_bounded(point));  // it is what it is told to be
    }
  }
}

TEST_CASE("the work of a step grows linearly with the chain") {
  // the discretised elastica: its path does not depend on n beyond the discretisation error O(1/n)
  double force_at_200 = 0;
  for (const std::size_t n : {200U, 2000U}) {
    const double N = static_cast<double>(n);
    std::vector<double> length(n, 1 / N), stiffness(n, N), rest(n, -0.5 / N);
    rest[0] = 0.25;
    const Nominal model{Chain<double>(length, stiffness, rest)};
    const auto shape = absolute_angles(rest);
    const auto p = end_point(model.chain(), rest);
    Brancher<Nominal> brancher(model, {Control::end_point, p, {-1, 0}}, shape);
    const auto branch = Tracer<Nominal>(brancher, {0, 0.3}).run(brancher.start(0, shape));
    CHECK(branch.end == BranchEnd::load);
    CHECK(branch.points.size() < 200);
    if (n == 200) {
      force_at_200 = branch.points.back().force.x;
    } else {
      CHECK(branch.points.back().force.x == close_to(force_at_200).epsilon(0.05));
    }
  }
}

TEST_CASE("a step is made where Newton's method contracts at once, and to no place far from where it aimed") {
  // one link, k = L = 1, under a compression of 1.2, pushed aside: load = (1.2 sin theta - theta) / cos theta
  const Nominal model(Chain<double>({1}, {1}));
  Brancher<Nominal> brancher(model, {Control::force, {-1.2, 0}, {0, -1}}, Vector<double>::Zero(1));
  const auto balanced = [](const BranchPoint<double>& point) {
    const double theta = point.theta(0);
    return point.load == close_to((1.2 * std::sin(theta) - theta) / std::cos(theta)).epsilon(1e-12);
  };
  const auto from = brancher.start(0.01, Vector<double>::Constant(1, -0.9));
  CHECK(balanced(from));
  for (const double h : {0.01, 0.1, -0.01}) {
    const auto step = brancher.step(from, h), at_load = brancher.at_load(from, from.load + h);
    REQUIRE(step);
    REQUIRE(at_load);
    CHECK(balanced(*step));
    CHECK(balanced(*at_load));
    CHECK(at_load->load == from.load + h);
    const double ahead =
        brancher.product({step->theta - from.theta, {0, 0}, step->load - from.load}, from.tangent);
    CHECK(ahead == close_to(h).epsilon(1e-12));
  }
  // the branch turns by half a radian on the way
  for (const double h : {0.5, 1.0, 3.0, 30.0}) {
    CHECK_FALSE(brancher.step(from, h));
    CHECK_FALSE(brancher.at_load(from, from.load + h));
  }
  BranchPoint<double> beside = from;
  beside.theta(0) += 0.01;
  CHECK(brancher.onto(beside, 0.1));
  CHECK_FALSE(brancher.onto(beside, 1e-3));
}

TEST_CASE(
    "a branch is cut before its first unstable point, at the fold or crossing there, not where it only "
    "weakens") {
  const auto cut = [](EventKind last, std::size_t before, std::vector<std::size_t> types) {
    Branch<double> branch{{}, {}, BranchEnd::load};
    for (const std::size_t negative : types) {
      BranchPoint<double> point{};
      point.load = static_cast<double>(branch.points.size());
      point.negative_directions = negative;
      branch.points.push_back(point);
    }
    BranchEvent<double> event{last, before, {}, {}};
    event.point.load = static_cast<double>(before) + 0.5;
    branch.events = {event, {EventKind::fold, 3, {}, {}}};
    const bool lost = detail::cut_where_unstable(branch);
    CHECK(lost == (branch.end == BranchEnd::unstable));
    std::vector<double> loads;
    for (const BranchPoint<double>& point : branch.points) loads.push_back(point.load);
    CHECK(branch.events.size() == (lost ? 1 : 2));  // what lies behind goes
    return loads;
  };
  using Loads = std::vector<double>;
  CHECK(cut(EventKind::fold, 1, {0, 0, 1, 1, 1}) == Loads{0, 1, 1.5});
  CHECK(cut(EventKind::bifurcation, 1, {0, 0, 1, 1, 1}) == Loads{0, 1, 1.5});
  CHECK(cut(EventKind::quasi_buckling, 1, {0, 0, 1, 1, 1}) == Loads{0, 1});
  CHECK(cut(EventKind::fold, 0, {0, 0, 1, 1, 1}) == Loads{0, 1});  // an event of before
  CHECK(cut(EventKind::fold, 1, {0, 0, 0, 0, 0}) == Loads{0, 1, 2, 3, 4});
}
