#pragma once
/// \file
/// The lowest critical force of a string in two or three runs along it: a coarser string, eight beads drawn
/// together to one, and so on down to a few beads, says where to begin.

#include <optional>
#include <plumbline/laguerre.hpp>

namespace plumbline {

/// A string with an eighth of the beads: each group's mass in its centre, which keeps mass, first moment and
/// length, and so the lowest frequency to second order in the size of a group.
template <std::floating_point Real>
class CoarseString {
 public:
  explicit CoarseString(const StringPiece<Real>& fine)
      : mass_((fine.size() + group - 1) / group), spacing_(mass_.size()) {
    Real before = 0;  // from the support or the last group's centre to this group's first bead
    for (std::size_t i = 0; i < mass_.size(); ++i) {
      const std::size_t first = i * group, end = std::min(first + group, fine.size());
      Real mass = 0, moment = 0, behind = 0;
      for (std::size_t bead = end; bead-- > first;) {
        if (bead < fine.spacing.size()) behind += fine.spacing[bead];
        mass += fine.mass[bead];
        moment += fine.mass[bead] * behind;
      }
      const Real to_next = moment / mass, from_first = behind - to_next;
      (i == 0 ? lead_ : spacing_[i - 1]) = before + from_first;
      mass_[i] = mass;
      before = to_next;
    }
    spacing_.back() = before;
    largest_mass_ = group * fine.largest_mass;
    largest_spacing_ = 2 * group * fine.largest_spacing;
    slope_ = fine.slope > 0 ? 1 / (1 / fine.slope + lead_) : 0;
    free_end_ = fine.free_end();
  }
  [[nodiscard]] StringPiece<Real> piece() const {
    const std::span<const Real> spacing(spacing_);
    return {0,      mass_,         spacing.first(mass_.size() - (free_end_ ? 1 : 0)),
            slope_, largest_mass_, largest_spacing_};
  }

 private:
  static constexpr std::size_t group = 8;
  Scratch<Real> mass_, spacing_;
  Real lead_{0}, slope_, largest_mass_, largest_spacing_;
  bool free_end_;
};

/// The one root in a bracket.
template <Floating Real>
Root<Real> root_in(const StringPiece<Real>& string, Bracket<Real> bracket) {
  while (!close_in(bracket, sweep(string, bracket.next), string.size())) {
  }
  return {bracket.next, bracket.rate};
}

/// The root number `index` by Laguerre's iteration from a value that is nearly it. Nothing when it turns out
/// that it is not.
template <Floating Real>
std::optional<Root<Real>> refined(const StringPiece<Real>& string, std::size_t index, const Root<Real>& from,
                                  int runs, const Real& enough = epsilon<Real>() / Real(8)) {
  const Real far(1e9);
  Bracket<Real> bracket{
      Real(from.value / far), Real(from.value * far), index, index + 1, from.value, from.rate};
  bracket.enough = enough;
  while (runs-- > 0) {
    const auto at = sweep(string, bracket.next);
    if (at.below < index || at.below > index + 1) return std::nullopt;
    if (close_in(bracket, at, string.size())) return Root<Real>{bracket.next, bracket.rate};
  }
  return std::nullopt;
}

/// The lowest critical force of a string, to a relative error that is enough.
template <std::floating_point Real>
Root<Real> lowest_force(const StringPiece<Real>& string, Real enough = epsilon<Real>() / 8) {
  if (string.size() > 32) {
    const CoarseString<Real> coarse(string);
    const Root<Real> near{lowest_force(coarse.piece(), Real(1e-6)).value, Real(1)};
    if (const auto root = refined(string, 0, near, 5, enough)) return *root;
  }
  Bracket<Real> bracket = all_of(string);
  bracket.up_to = 1;
  bracket.enough = enough;
  bracket.next = bracket.low;
  bracket.last = std::numeric_limits<Real>::infinity();  // the first step may be as long as it likes
  bracket.rate = Real(1);  // close_in knows better: all other roots are on one side
  return root_in(string, bracket);
}

}  // namespace plumbline
