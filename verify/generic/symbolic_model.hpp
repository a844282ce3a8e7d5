#pragma once
/// \file
/// A chain of a premise in symbols, and what formulas may name of it.
///
/// Every name in the premise's lengths, stiffnesses and rest angles is a symbol, and so are the further ones
/// that a check declares, q1 … qn, the joint angles counted from rest, Fx and Fy, the force of J^T F + M = 0.
/// Of the model there are
///
///     x, y      the end point; x0, y0 at rest
///     E         the strain energy
///     T1 … Tn   the rows of J^T F + M
///     J11 … J2n, A11 …, B11 …, S11 …, z1 … zn  entries of the Jacobian, and of (33), S1 and S0 of a straight
///     chain; chi0 … the coefficients of its characteristic polynomial det(lambda I - B^-1 A)

#include <ginac/ginac.h>

#include "proofs/exact/expression.hpp"
#include "proofs/exact/symbolic_chain.hpp"
#include "proofs/exact/symbolic_statics.hpp"
#include "verify/judging/premises.hpp"

namespace plumbline::verify {

class SymbolicModel {
 public:
  /// \param chain    a premise with length and stiffness; rest angles are zero where it has none
  /// \param symbols  that formulas may use besides
  /// \param shape    of all joint angles from rest, as formulas, where the chain is not in a general shape
  SymbolicModel(const Premise& chain, const Printed& symbols, const Printed& shape);

  [[nodiscard]] const proofs::Formulas& formulas() const { return formulas_; }
  [[nodiscard]] std::size_t size() const { return length_.size(); }
  /// A formula in the symbols and in what the model has.
  [[nodiscard]] GiNaC::ex value(const std::string& formula) const;

 private:
  [[nodiscard]] GiNaC::ex named(const std::string& name) const;
  [[nodiscard]] proofs::SymbolicShape shape_at(const std::vector<GiNaC::ex>& q) const;

  proofs::Formulas formulas_;
  std::vector<GiNaC::ex> length_, stiffness_, rest_, q_;
};

}  // namespace plumbline::verify
