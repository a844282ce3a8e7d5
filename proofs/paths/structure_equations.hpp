#pragma once
/// \file
/// The equations of equilibria of a planar structure with any ends, supports and dead loads, over boxes.
///
/// Unknowns u are the directions of the links that turn, the base's slides, the forces (multipliers) of what
/// is held, and the factor of the loads. With the forces X_i, Y_i that act on the far end of link i and
/// beyond, the moment of link i vanishes,
///
///     k_i (t_i - t_{i-1} - r_i) - k_{i+1} (t_{i+1} - t_i - r_{i+1}) + L_i (X_i sin t_i - Y_i cos t_i) = 0 ,
///
/// so do the forces on a slide, and what is held stays in its place.

#include <plumbline/space/bent_equilibrium.hpp>
#include <plumbline/structure/structure.hpp>

#include "proofs/paths/hyper_dual.hpp"
#include "proofs/paths/tube_equations.hpp"

namespace plumbline::proofs {

class StructureEquations final : public TubeEquations {
 public:
  /// \throws Error for a follower load
  explicit StructureEquations(const Structure<Rational>& structure);

  [[nodiscard]] Eigen::Index unknowns() const { return moving() + held_ + 1; }
  /// How many of them are directions or slides: the first ones.
  [[nodiscard]] Eigen::Index moving() const {
    return static_cast<Eigen::Index>(length_.size() - first_ + slides_.size());
  }
  /// The unknowns of a point of the model that bent_structure() makes of the structure.
  [[nodiscard]] Vector<Span> at(const BentStructure<double>& model, const BentPoint<double>& point) const;

  [[nodiscard]] Vector<Span> value(const Vector<Span>& u) override;
  [[nodiscard]] Matrix<Span> derivative(const Vector<Span>& u, const Vector<Span>& normal) override;
  [[nodiscard]] Vector<Span> second(const Vector<Span>& u, const Vector<Span>& v,
                                    const Vector<Span>& w) override;
  /// Directions in which the energy falls, of those that what is held permits; nothing where that is open.
  [[nodiscard]] std::optional<std::size_t> negative_directions(const Vector<Span>& u);

 private:
  struct Place {
    HyperDual x, y;
    [[nodiscard]] HyperDual& along(int coordinate) { return coordinate == 0 ? x : y; }
  };
  struct Spring {
    std::size_t node;
    int coordinate;  ///< 0 along, 1 across
    bool held;
    Span stiffness, slack;  ///< slack: where it pulls at nothing, or is held
  };
  struct Dead {
    std::size_t node;
    Span x, y;
    bool multiplied;
  };
  using Unknowns = std::vector<HyperDual>;

  void add_spring(std::size_t node, int coordinate, const Restraint<Rational>& restraint);
  [[nodiscard]] std::vector<HyperDual> directions(const Unknowns& u) const;
  [[nodiscard]] std::vector<Place> places(const Unknowns& u, const std::vector<HyperDual>& theta) const;
  /// On every node, and what holds a node adds its equation.
  [[nodiscard]] std::vector<Place> pulls(const Unknowns& u, std::vector<Place>& place,
                                         std::vector<HyperDual>& held) const;
  [[nodiscard]] std::vector<HyperDual> equations(const Unknowns& u) const;

  std::size_t first_;  ///< link that turns, from 0
  std::vector<Span> length_, stiffness_, rest_, slack_;
  std::vector<Spring> springs_, slides_;
  std::vector<Dead> loads_;
  Hold turn_;
  Span turn_stiffness_, moment_;
  Eigen::Index held_ = 0;
};

}  // namespace plumbline::proofs
