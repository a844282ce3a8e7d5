#include "proofs/exact/symbolic_statics.hpp"

#include <doctest/doctest.h>

using namespace plumbline::proofs;
using GiNaC::ex;
using GiNaC::symbol;

TEST_CASE("balance of torques and Hessian are the derivatives of the potential, in q and in theta") {
  // q_i = theta_i - theta_(i - 1), so that d/dq_i is the sum of all d/dtheta_j from i on
  const std::vector<symbol> theta{symbol("a"), symbol("b"), symbol("c")};
  const symbol Fx("Fx"), Fy("Fy");
  SymbolicShape shape{{symbol("L1"), symbol("L2"), symbol("L3")},
                      {symbol("k1"), symbol("k2"), symbol("k3")},
                      {theta[0], theta[1] - theta[0], theta[2] - theta[1]}};
  const GiNaC::matrix end = end_point(shape), J = jacobian(shape), balance = torque_balance(shape, Fx, Fy),
                      H = hessian(shape, Fx, Fy);
  ex potential = Fx * end(0, 0) + Fy * end(1, 0);
  for (std::size_t i = 0; i < 3; ++i) potential += shape.stiffness[i] * pow(shape.q[i], 2) / 2;
  const auto by_q = [&](const ex& value, unsigned i) {
    ex sum = 0;
    for (unsigned j = i; j < 3; ++j) sum += value.diff(theta[j]);
    return sum;
  };
  for (unsigned i = 0; i < 3; ++i) {
    CHECK((balance(i, 0) - by_q(potential, i)).expand().is_zero());
    for (unsigned d = 0; d < 2; ++d) CHECK((J(d, i) - by_q(end(d, 0), i)).expand().is_zero());
    for (unsigned j = 0; j < 3; ++j)
      CHECK((H(i, j) - potential.diff(theta[i]).diff(theta[j])).expand().is_zero());
  }
}

TEST_CASE("a straight chain ends where its links together reach, and one turned by a right angle above") {
  const symbol L1("L1"), L2("L2");
  const auto end = [&](const ex& q1, const ex& q2) { return end_point({{L1, L2}, {1, 1}, {q1, q2}}); };
  CHECK(end(0, 0)(0, 0).is_equal(L1 + L2));
  CHECK(end(0, 0)(1, 0).is_zero());
  CHECK(end(0, GiNaC::Pi / 2)(0, 0).is_equal(L1));
  CHECK(end(0, GiNaC::Pi / 2)(1, 0).is_equal(L2));
}
