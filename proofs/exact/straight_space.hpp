#pragma once
/// \file
/// Critical forces of the straight chain in space: right in every digit, proved by exact counts.

#include <plumbline/space/space_pencil.hpp>

#include "proofs/exact/critical_modes.hpp"
#include "proofs/exact/enclosure.hpp"

namespace plumbline::proofs {

/// A buckling mode of a chain in space.
struct SpaceMode {
  std::string force;  ///< correctly rounded decimal
  /// Angles about all axes, joint by joint; the largest is 1 or -1, the first that is not zero is positive.
  std::vector<double> q;
};

class StraightSpace {
 public:
  /// \throws Error for a mechanism, for a chain that gives way before the factor grows, and where no positive
  ///         factor makes it give way
  explicit StraightSpace(const SpaceStructure<Rational>& structure);

  [[nodiscard]] std::size_t modes() const { return modes_; }
  /// The number of critical factors below one.
  [[nodiscard]] std::size_t below(const Rational& factor) const;
  /// The lowest so many between fractions, to so many digits.
  [[nodiscard]] std::vector<ForceEnclosure> enclose(std::size_t lowest, int digits) const;
  /// The lowest so many as decimals, with their shapes, each of which leaves no more of (K - F G) y than its
  /// digits account for.
  [[nodiscard]] std::vector<SpaceMode> in_decimals(std::size_t lowest, int digits) const;

 private:
  [[nodiscard]] std::vector<double> angles(const Vector<Mpfr>& y) const;

  std::size_t axes_;
  std::vector<double> length_of_axis_;
  SpacePencil<Rational> pencil_;
  std::size_t modes_;
};

}  // namespace plumbline::proofs
