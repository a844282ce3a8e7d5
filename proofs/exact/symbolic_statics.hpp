#pragma once
/// \file
/// Statics of a short chain with symbolic lengths, stiffnesses and shape, for the formulas that the paper
/// prints.

#include <ginac/ginac.h>

#include <vector>

namespace plumbline::proofs {

/// A chain in a given shape; any entry may be an expression.
struct SymbolicShape {
  std::vector<GiNaC::ex> length, stiffness, q;
};

/// End point, 2 x 1.
GiNaC::matrix end_point(const SymbolicShape& shape);

/// Jacobian (7), (23), 2 x n: derivative of the end point with respect to the joint angles.
GiNaC::matrix jacobian(const SymbolicShape& shape);

/// J^T F + (k_1 q_1, …, k_n q_n), n x 1: zero where a chain that is straight when unloaded is in equilibrium,
/// with F the force that the chain exerts through its end point (compression positive, as in (6), (14),
/// (29)).
GiNaC::matrix torque_balance(const SymbolicShape& shape, const GiNaC::ex& Fx, const GiNaC::ex& Fy);

/// Hessian in absolute link orientations, n x n, of E + Fx x + Fy y (the same sign of F). On the directions
/// that keep the end point it decides stability under an imposed end point.
GiNaC::matrix hessian(const SymbolicShape& shape, const GiNaC::ex& Fx, const GiNaC::ex& Fy);

}  // namespace plumbline::proofs
