#include "proofs/exact/symbolic_statics.hpp"

namespace plumbline::proofs {
namespace {

using GiNaC::ex;

std::vector<ex> orientations(const SymbolicShape& shape) {
  std::vector<ex> theta;
  ex sum = 0;
  for (const ex& angle : shape.q) theta.push_back(sum = (sum + angle).expand());
  return theta;
}

/// Whether the angle is a negative multiple: its sine and cosine are then written with the positive one.
bool is_negative_multiple(const ex& angle) {
  return GiNaC::is_a<GiNaC::mul>(angle) && angle.op(angle.nops() - 1).info(GiNaC::info_flags::negative);
}
ex sine(const ex& angle) {
  return is_negative_multiple(angle) ? ex(-sin(-angle)) : ex(sin(angle));
}
ex cosine(const ex& angle) {
  return is_negative_multiple(angle) ? ex(cos(-angle)) : ex(cos(angle));
}

unsigned count(const SymbolicShape& shape) {
  return static_cast<unsigned>(shape.length.size());
}

}  // namespace

GiNaC::matrix end_point(const SymbolicShape& shape) {
  GiNaC::matrix p(2, 1);
  const std::vector<ex> theta = orientations(shape);
  for (std::size_t j = 0; j < theta.size(); ++j) {
    p(0, 0) += shape.length[j] * cosine(theta[j]);
    p(1, 0) += shape.length[j] * sine(theta[j]);
  }
  return p;
}

GiNaC::matrix jacobian(const SymbolicShape& shape) {
  const std::vector<ex> theta = orientations(shape);
  GiNaC::matrix J(2, count(shape));
  ex x = 0;
  ex y = 0;
  for (unsigned i = count(shape); i-- > 0;) {
    x += shape.length[i] * cosine(theta[i]);
    y += shape.length[i] * sine(theta[i]);
    J(0, i) = -y;
    J(1, i) = x;
  }
  return J;
}

GiNaC::matrix torque_balance(const SymbolicShape& shape, const ex& Fx, const ex& Fy) {
  const GiNaC::matrix J = jacobian(shape);
  GiNaC::matrix balance(count(shape), 1);
  for (unsigned i = 0; i < count(shape); ++i) {
    balance(i, 0) = J(0, i) * Fx + J(1, i) * Fy + shape.stiffness[i] * shape.q[i];
  }
  return balance;
}

GiNaC::matrix hessian(const SymbolicShape& shape, const ex& Fx, const ex& Fy) {
  const std::vector<ex> theta = orientations(shape);
  GiNaC::matrix H(count(shape), count(shape));
  for (unsigned i = 0; i < count(shape); ++i) {
    H(i, i) += shape.stiffness[i] - shape.length[i] * (Fx * cosine(theta[i]) + Fy * sine(theta[i]));
    if (i == 0) continue;
    H(i - 1, i - 1) += shape.stiffness[i];
    H(i - 1, i) -= shape.stiffness[i];
    H(i, i - 1) -= shape.stiffness[i];
  }
  return H;
}

}  // namespace plumbline::proofs
