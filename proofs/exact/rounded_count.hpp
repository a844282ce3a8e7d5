#pragma once
/// \file
/// How many critical forces lie below a fraction, counted in arithmetic that rounds, where rounding cannot
/// have changed the count.
///
/// By theorem "Rounded counts" a run along a string of n - 1 beads in numbers with the unit roundoff w counts
/// what lies below some force within a relative distance of (1 - w)^-(8n + 16) - 1 from the one that it is
/// given. Two runs, a little more than that below and above F, bracket the count at F: where they agree it is
/// certain.

#include <optional>
#include <plumbline/straight/straight_chain.hpp>
#include <vector>

namespace plumbline::proofs {

class RoundedCount {
 public:
  using Counts = std::vector<std::optional<std::size_t>>;

  /// Of one part (exact_count.hpp) of a chain of integers.
  RoundedCount(const std::vector<Integer>& length, const std::vector<Integer>& stiffness, EndPoint end_point,
               std::size_t part)
      : length_(length), stiffness_(stiffness), end_point_(end_point), part_(part) {}

  /// The number of critical forces of the part below each force; nothing where that stays open.
  [[nodiscard]] Counts below(const std::vector<Rational>& forces) const;

 private:
  void in_lanes(const std::vector<Rational>& forces, Counts& counts) const;
  template <Floating Real>
  void in_turn(const std::vector<Rational>& forces, Counts& counts) const;

  const std::vector<Integer>&length_, &stiffness_;
  EndPoint end_point_;
  std::size_t part_;
};

}  // namespace plumbline::proofs
