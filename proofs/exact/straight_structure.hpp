#pragma once
/// \file
/// Critical load factors of a straight structure, with any ends, supports and dead loads: right in every
/// digit, proved by exact counts.

#include <plumbline/straight/pencil.hpp>
#include <plumbline/straight/string_form.hpp>

#include "proofs/exact/critical_modes.hpp"
#include "proofs/exact/enclosure.hpp"

namespace plumbline::proofs {

/// How many eigenvalues of an exact pencil lie below each of many factors. Intervals count where they are
/// certain of the sign of every pivot, fractions elsewhere.
std::vector<std::size_t> count_below(const StraightPencil<Rational>& pencil,
                                     const std::vector<Rational>& factors);

class StraightStructure {
 public:
  /// \throws Error for a structure that is not sound, whose loads do not lie along it or are not multiplied,
  ///         that is a mechanism, that gives way before the factor grows, or that no factor makes give way
  explicit StraightStructure(const Structure<Rational>& structure);

  /// How many positive critical factors there are.
  [[nodiscard]] std::size_t modes() const { return modes_; }
  /// The lowest so many between fractions, to so many digits.
  [[nodiscard]] std::vector<ForceEnclosure> enclose(std::size_t lowest, int digits) const;
  /// The lowest so many as decimals, with their shapes where these are wanted.
  [[nodiscard]] std::vector<CriticalMode> in_decimals(std::size_t lowest, int digits, bool shapes) const;
  /// Whether a string with beads has these factors, and each costs O(n) whatever the grading.
  [[nodiscard]] bool has_string() const { return string_.has_value(); }

 private:
  void find_pencil();
  [[nodiscard]] std::string rounded(const ForceEnclosure& factor, int digits) const;
  void add_string_shapes(std::vector<CriticalMode>& modes, int digits) const;
  void add_pencil_shapes(std::vector<CriticalMode>& modes, int digits) const;

  Structure<Rational> structure_;
  std::optional<StringForm<Rational>> string_;
  StraightPencil<Rational> pencil_;  ///< where there is no string
  std::size_t modes_ = 0;
};

}  // namespace plumbline::proofs
