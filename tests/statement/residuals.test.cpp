// Every vector and number that is printed of a structure, held against the equations that it solves, which
// are assembled once more from the energy of the bent chain.

#include <Eigen/QR>
#include <cmath>
#include <plumbline/space/bent_equilibrium.hpp>

#include "proofs/exact/straight_space.hpp"
#include "proofs/exact/straight_structure.hpp"
#include "statement/chain_file.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::statement;

namespace {

std::string hundredths(int low, int high) {
  return std::to_string(*rc::gen::inRange(low, high)) + "e-2";
}

std::string joined(std::size_t count, int low, int high) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + hundredths(low, high);
  return "[" + text + "]";
}

/// Ends and loads along x, of any kind that leaves the base in place.
std::string along(std::size_t n, const std::string& force_end) {
  const std::string ends[] = {"\"guided\"", "\"free\"", "\"clamped\"", "{ across = 0.5 }"};
  std::string text = "end_point = " + ends[*rc::gen::inRange(0, 4)] + "\n";
  if (*rc::gen::inRange(0, 3) == 0) text += "foundation = 0.2\n";
  return text + "loads = [{ force = [-1" + force_end + " }, { force = [-0.5" + force_end +
         ", at = " + std::to_string(*rc::gen::inRange(2, static_cast<int>(n) + 1)) + " }]\n";
}

std::string random_in_plane(std::size_t n) {
  return "lengths = " + joined(n, 30, 200) + "\nstiffness = " + joined(n, 30, 300) + "\n" + along(n, ", 0]");
}

/// Joints of one or two axes anyhow, none along the chain.
std::string random_in_space(std::size_t n) {
  std::string joints;
  for (std::size_t i = 0; i < n; ++i) {
    const bool two = *rc::gen::inRange(0, 2) == 0;
    joints += std::string(i > 0 ? ", " : "") + "{ axes = [[0, " + hundredths(30, 200) + ", " +
              hundredths(-200, 200) + "]" + (two ? ", [" + hundredths(-100, 100) + ", -0.3, 1]" : "") +
              "], stiffness = " + joined(two ? 2 : 1, 30, 300) + " }";
  }
  return "lengths = " + joined(n, 30, 200) + "\njoints = [" + joints + "]\n" + along(n, ", 0, 0]");
}

/// How much of H v the forces of what is held do not take up, and what v moves of it; beside |H| |v|.
double residual(const BentStructure<double>& model, double factor, const std::vector<double>& q) {
  const Vector<double> v = Eigen::Map<const Vector<double>>(q.data(), static_cast<Eigen::Index>(q.size()));
  BentExpansion<double> at;
  model.expand(model.rest(), factor, Vector<double>::Constant(model.held(), 0.0), at);
  Vector<double> left = at.hessian * v;
  double moved = 0;
  if (model.held() > 0) {
    const Matrix<double> columns = at.held_gradient.transpose();
    left -= columns * columns.colPivHouseholderQr().solve(left);
    moved = (at.held_gradient * v).norm() / (at.held_gradient.norm() * v.norm());
  }
  return left.norm() / (at.hessian.norm() * v.norm()) + moved;
}

}  // namespace

TEST_CASE("each shape that is printed is one in which the structure rests beside the straight line") {
  check_property("shapes", [] {
    const auto n = static_cast<std::size_t>(*rc::gen::inRange(2, 6));
    const std::string text = *rc::gen::inRange(0, 2) == 0 ? random_in_plane(n) : random_in_space(n);
    RC_LOG() << text;
    const StatedChain chain = parse_chain(text, "c");
    // an angle has sixteen digits, and so has the factor; both meet stiffnesses within a few hundred of each
    // other
    const double slack = 1e-12;
    const auto check = [&](const auto& modes, const BentStructure<double>& model) {
      for (const auto& mode : modes) RC_ASSERT(residual(model, std::stod(mode.force), mode.q) < slack);
    };
    try {
      if (const auto* plane = std::get_if<PlaneChain>(&chain)) {
        check(proofs::StraightStructure(plane->structure).in_decimals(99, 17, true),
              bent_structure(from_rational<double>(plane->structure)));
      } else {
        const auto& structure = std::get<SpaceStructure<Rational>>(chain);
        check(proofs::StraightSpace(structure).in_decimals(99, 17),
              bent_structure(from_rational<double>(structure)));
      }
    } catch (const Error& error) {
      RC_LOG() << error.what();
      RC_DISCARD("no critical factor");
    }
  });
}

TEST_CASE("the energy of an equilibrium falls with the factor by what the loads work, a moment's part too") {
  const Structure<Rational> exact =
      parse_plane_chain(
          "lengths = [1, 0.7, 1.2]\nstiffness = [1, 2, 0.5]\nend_point = { across = 0.3, turn = 0.2 }\n"
          "loads = [{ moment = 0.7 }, { force = [-0.1, 0.2] }, { weight = 0.3 },\n"
          "         { force = [0, -0.4], at = 2, fixed = true }]\n",
          "c")
          .structure;
  const auto structure = from_rational<double>(exact);
  const auto model = bent_structure(structure);
  BentSolver<double> solver(model);
  BentPoint<double> point = solver.settle(model.rest(), 0).value();
  // dV = -(work of a unit of the factor) dF along equilibria; Simpson's rule errs by h^4 / 180 of the fourth
  // derivative, here below 1e-9
  constexpr int steps = 200;
  const double last = 0.8, h = last / steps, begin = model.potential(point.x, 0);
  double work = 0;
  for (int i = 0; i <= steps; ++i) {
    const auto next = solver.at_factor(point.x, i * h, point.multiplier);
    REQUIRE(next.has_value());
    point = *next;
    BentExpansion<double> at;
    model.expand(point.x, point.factor, point.multiplier, at);
    double unit = structure.moment * point.x.sum();
    for (const Load<double>& load : structure.loads) {
      if (load.multiplied)
        unit += load.force.x * at.place[load.node](0) + load.force.y * at.place[load.node](1);
    }
    work += unit * (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2) * h / 3;
  }
  CHECK(model.potential(point.x, last) - begin == doctest::Approx(-work).epsilon(1e-8));
}
