#include <doctest/doctest.h>

#include <plumbline/branch/sharpen.hpp>
#include <plumbline/branch/trace.hpp>
#include <plumbline/loaded/nominal_model.hpp>

using namespace plumbline;

TEST_CASE(
    "a bifurcation in more digits keeps which way the branch goes, and which way the other one crosses") {
  const auto zigzag = [](auto angle) {
    using Real = decltype(angle);
    return NominalModel<Real>(Chain<Real>({1, 1, 1}, {0, 1, 1}, {0, angle, -angle}));
  };
  const auto push = [](const auto& model) {
    using Real = typename std::remove_cvref_t<decltype(model)>::Real;
    using std::atan2, std::sqrt;
    std::vector<Real> q = model.chain().rest();
    const auto p = end_point(model.chain(), q);
    q[0] = -atan2(p.y, p.x);
    const Real span = sqrt(p.x * p.x + p.y * p.y);
    return std::pair{Loading<Real>{Control::end_point, {span, Real(0)}, {Real(-1), Real(0)}},
                     absolute_angles(q)};
  };
  const auto model = zigzag(boost::math::constants::pi<double>() / 10);
  const auto [loading, shape] = push(model);
  Brancher<NominalModel<double>> low(model, loading, shape);
  const auto branch = Tracer<NominalModel<double>>(low, {0, 0.1}).run(low.start(0, shape));
  REQUIRE(branch.events.size() == 1);
  const auto wide = zigzag(Mpfr50(boost::math::constants::pi<Mpfr50>() / 10));
  const auto [wide_loading, wide_shape] = push(wide);
  Brancher<NominalModel<Mpfr50>> high(wide, wide_loading, wide_shape);
  const auto event = sharpen(high, branch.events[0]);
  // The symmetric branch keeps theta_1 = theta_3, and the arches leave it where that alone changes.
  CHECK(abs(event.point.theta(0) - event.point.theta(2)) < Mpfr50("1e-45"));
  CHECK(abs(event.point.tangent.theta(0) - event.point.tangent.theta(2)) < Mpfr50("1e-20"));
  CHECK(abs(event.crossing.theta(0) + event.crossing.theta(2)) < Mpfr50("1e-20"));
  CHECK(abs(event.crossing.theta(1)) < Mpfr50("1e-20"));
  CHECK(event.point.tangent.load > Mpfr50("1e-3"));
}
