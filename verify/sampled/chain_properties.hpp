#pragma once
/// \file
/// What holds for every straight chain, as checks on one chain. The proofs stand in proofs/theorems.md.

#include <optional>
#include <plumbline/chain/mode.hpp>
#include <span>
#include <vector>

namespace plumbline::verify {

/// A chain, what Algorithm 1 makes of it in 50 digits and in double, and how far each may be off.
///
/// The radius of force i is 10 n eps c_i with the condition c_i = |B| |B^-1 A| |v_i|^2 / (q_i^T M q_i), where
/// M = -S1 and norms are Frobenius's. A backward stable solution of B C = A disturbs column j of C by
/// B^-1 dB_j c_j with |dB_j| <= p eps |B|, a backward stable eigenvalue routine adds a disturbance of norm
/// p eps |C|, with p a low-degree polynomial in n. As A and B are symmetric, the left eigenvector of C is B
/// v, so that to first order |d lambda| <= p eps |B| |C| |v|^2 / |v^T B v|, and lambda v^T B v = v^T A v.
struct Sample {
  /// \throws Error when Algorithm 1 fails in 50 digits
  explicit Sample(const Chain<double>& chain);

  /// Whether the first-order bound means anything in a number type with this epsilon: the radius of force i
  /// is below a quarter of its distance to its neighbours, and of its distance to what rounding makes of the
  /// defective double zero, |lambda| <= sqrt(10 n eps |C| |z| / z_1).
  [[nodiscard]] bool resolved(std::size_t i, double epsilon) const;

  /// Relative distance of force i from the nearest force that Algorithm 1 finds in double; infinite when it
  /// finds none at all.
  [[nodiscard]] double error_in_double(std::size_t i) const;

  Chain<Rational> exact;
  std::vector<Mode<Mpfr50>> modes;
  std::vector<double> forces_in_double;  ///< none when Algorithm 1 fails
  std::vector<double> condition;         ///< 10 n c_i
  double zero_scale;                     ///< 10 n |C| |z| / z_1
  std::vector<Rational> below, above;    ///< force i less and plus its 50-digit radius
};

/// How much of what a property allows is used up: 1 or less where it holds; nothing where the property says
/// nothing about this chain.
using Margin = std::optional<double>;

struct ChainProperty {
  const char* name;
  const char* statement;
  Margin (*margin)(const Sample&);
};

std::span<const ChainProperty> chain_properties();

}  // namespace plumbline::verify
