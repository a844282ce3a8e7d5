#pragma once
/// \file
/// How many critical forces lie below a given fraction: exactly, in integers.
///
/// The recursion of <plumbline/critical_force.hpp> with the denominators cleared once. With M_i = z_i g_i and
/// F = P / D it reads, up to a positive factor that grows along the chain,
///
///     t = D z_{i+1} M_i - P L_i h_i;   h_{i+1} = D z_i k_{i+1} h_i + z_{i+1} t,   M_{i+1} = k_{i+1} t.
///
/// With a free end point all z are one (straight_chain.hpp). No common factor is ever sought, which is what
/// exact fractions spend their time on; still the integers grow along the chain, and a count costs O(n^2)
/// operations on words. They decide what is left open by counts in rounded arithmetic on either side of the
/// force, of more and more digits: where these agree, theorem "Rounded counts" makes them the exact count.

#include <plumbline/straight/straight_chain.hpp>
#include <vector>

namespace plumbline::proofs {

/// A stretch of the chain, joints `first` to `last` from 0, that buckles on its own. A passive joint between
/// two elastic ones divides a chain in two: the stretch before it, where the rest stays straight and turns
/// about the joint, and the stretch behind it, where what lies before stays straight. Other chains are one
/// part.
struct ChainPart {
  std::size_t first, last;
  bool operator==(const ChainPart&) const = default;
};

/// The parts of a chain, in order.
/// \throws Error for n = 1 or a mechanism
std::vector<ChainPart> parts(const Chain<Rational>& chain);

class ExactCount {
 public:
  /// \throws Error for n = 1 or a mechanism
  explicit ExactCount(const StraightChain<Rational>& chain);
  explicit ExactCount(const Chain<Rational>& guided) : ExactCount(StraightChain<Rational>(guided)) {}

  /// The number of critical forces below F.
  [[nodiscard]] std::size_t below(const Rational& F) const;
  /// The number of those of one part.
  [[nodiscard]] std::size_t below(const Rational& F, const ChainPart& part) const;
  /// Below each of many forces, which costs much less than one by one; on all processors.
  [[nodiscard]] std::vector<std::size_t> below(const std::vector<Rational>& forces) const;
  [[nodiscard]] const std::vector<ChainPart>& parts() const { return parts_; }

 private:
  [[nodiscard]] std::vector<std::size_t> below(const std::vector<Rational>& forces, std::size_t part) const;
  [[nodiscard]] std::size_t exactly_below(const Rational& scaled, const ChainPart& part) const;

  EndPoint end_point_;
  std::vector<ChainPart> parts_;
  std::vector<Integer> length_, distance_, stiffness_;
  Rational per_force_;  ///< force of the chain of integers over the force of the given one
};

}  // namespace plumbline::proofs
