#pragma once
/// \file
/// The equations of equilibria of a planar structure over a box of directions of its links, as a census
/// halves and narrows it.

#include <optional>
#include <vector>

#include "proofs/census/structure_census.hpp"

namespace plumbline::proofs {

/// Of the unknowns: directions of links that turn, then the force across.
using Ranges = std::vector<Span>;

/// The equilibrium equations over a box.
class StructureBox {
 public:
  /// \throws Error beyond the limits that docs/ends-and-loads.md states
  StructureBox(const Structure<Rational>& structure, const Rational& factor, int turns);

  /// Links that turn.
  [[nodiscard]] std::size_t turning() const { return unknown_.size(); }
  /// Unknowns.
  [[nodiscard]] std::size_t size() const { return unknown_.size() + (held_ ? 1 : 0); }
  /// Bounds of the window: of the force across, and of every joint from its rest.
  [[nodiscard]] double largest_force() const { return largest_force_; }
  [[nodiscard]] double widest_turn() const { return turn_[0].high; }

  /// The window.
  [[nodiscard]] Ranges everything() const;

  /// False: nothing is left.
  bool contract(Ranges& box) const;

  /// Whether one Newton step leads strictly inside: exactly one root; the box is then that much smaller.
  bool isolates(Ranges& box) const;

  /// A box around one root, as far as Newton's steps narrow it; where they gain little, as near a critical
  /// load, the part of it that is not proved to be empty.
  [[nodiscard]] Ranges narrowed(Ranges box) const;

  /// Of a box around one root: without the third at either end of its widest side, where that is proved to be
  /// empty.
  [[nodiscard]] std::optional<Ranges> part_with_root(const Ranges& box) const;

  static double widest(const Ranges& box);

  /// Whether two boxes that overlap, each around one root, are around the same: their hull has one as well.
  [[nodiscard]] bool around_one(const Ranges& a, const Ranges& b) const;

  /// A box of the same shapes whose directions lie as near to another's as whole turns of passive joints
  /// bring them: no spring counts those.
  [[nodiscard]] Ranges unwound(const Ranges& box, const Ranges& like) const;

  /// The hull of two boxes and a little more: a Newton step leads strictly inside no box that is already as
  /// small as it can make it.
  [[nodiscard]] Ranges widened(const Ranges& a, const Ranges& b) const;

  /// Place, energy and type of the equilibrium in a box.
  [[nodiscard]] StructureEquilibrium described(const Ranges& box) const;

  /// Whether a box is not certainly outside the window.
  [[nodiscard]] bool counted(const Ranges& box) const;

  /// Joint angles and directions of all links.
  [[nodiscard]] Ranges angles(const Ranges& theta) const;
  [[nodiscard]] Ranges directions(const Ranges& box) const;

 private:
  static double size_of(const Ranges& box);

  /// A hundred times what the springs and loads can turn the chain with.
  void bound_force(const Span& reach);

  [[nodiscard]] Span place_across(const Ranges& theta, std::size_t links) const;

  /// The force across that link i passes on: loads, springs and what holds the end point, beyond it.
  [[nodiscard]] Ranges passed_across(const Ranges& theta, const Span& force) const;

  bool bind(Span& known, const Span& other) const;

  /// From the end point to the base, what the moment at a joint says of its angle; and the closure.
  bool moments(Ranges& box) const;

  [[nodiscard]] Ranges residual(const Ranges& box) const;

  [[nodiscard]] Matrix<Span> derivative(const Ranges& box) const;

  bool newton(Ranges& box) const;

  std::size_t n_;
  bool held_;
  Ranges length_, stiffness_, rest_, slack_, turn_, spring_, fx_, fy_;
  std::vector<bool> fixed_;
  std::vector<std::size_t> unknown_;
  Span end_turn_{0}, moment_{0}, y_rest_{0};
  double largest_force_ = 0;
};

}  // namespace plumbline::proofs
