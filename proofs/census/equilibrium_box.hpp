#pragma once
/// \file
/// The equilibrium equations over a box of angles and force: what can be cut off, and what is proved to hold
/// one root.

#include <array>
#include <optional>
#include <plumbline/chain/chain.hpp>
#include <plumbline/chain/kinematics.hpp>
#include <plumbline/loaded/equilibrium.hpp>
#include <vector>

#include "proofs/census/window.hpp"
#include "proofs/exact/span.hpp"

namespace plumbline::proofs {

constexpr std::size_t most_links = 16;

/// Unknowns theta_1 … theta_n and, where the end point is held, Fx and Fy.
using Box = std::array<Span, most_links + 2>;
using Midpoint = std::array<double, most_links + 2>;

class EquilibriumBox {
 public:
  /// \param chain   in units of its own (proofs/exact/units.hpp)
  /// \param load    the place of the end point, or the force
  /// \param window  of the elastic joints where the end point is held; under a force |k_i (q_i - rest_i)| <=
  ///                |F| z_i bounds them
  /// \throws Error where the search would have no bounds, or too wide ones
  EquilibriumBox(const Chain<Interval>& chain, Control control, const Point<Interval>& load,
                 const Window& window);

  [[nodiscard]] std::size_t links() const { return n_; }
  [[nodiscard]] std::size_t unknowns() const { return size_; }
  /// The box that holds every equilibrium counted.
  [[nodiscard]] Box everything() const;
  /// Where joint i of a box may be, by its range alone.
  [[nodiscard]] const Span& range(std::size_t joint) const { return range_[joint]; }

  /// Cuts off what the joint ranges, the closure, the moments of link after link and interval Newton steps
  /// exclude. The force may be unbounded. What is cut off, check_equilibria.py cuts off too. False: nothing
  /// is left.
  bool narrow(Box& z) const;
  /// A root near the middle of a box, in plain doubles.
  [[nodiscard]] std::optional<Midpoint> root_near(const Box& z) const;
  /// A box around a point, as large as possible, that holds exactly one root.
  [[nodiscard]] std::optional<Box> isolate(const Midpoint& root) const;
  /// Whether Krawczyk's operator maps a box around a point well into its inside: it holds exactly one root.
  [[nodiscard]] bool contracts(const Midpoint& centre, double radius, double force_radius) const;
  [[nodiscard]] bool held() const { return held_; }
  [[nodiscard]] bool passive(std::size_t joint) const { return passive_[joint]; }
  /// Force that turns a joint about as far as an angle, in radians, is wide.
  [[nodiscard]] double force_of(double angle) const { return angle / force_weight_; }
  /// The link of the widest range of directions: that to halve.
  [[nodiscard]] std::size_t widest(const Box& z) const;

 private:
  struct Matrix {
    std::array<std::array<double, most_links + 2>, most_links + 2> entry;
  };
  struct SpanMatrix {
    std::array<std::array<Span, most_links + 2>, most_links + 2> entry;
  };
  [[nodiscard]] Box residual(const Box& z) const;
  [[nodiscard]] SpanMatrix derivative(const Box& z) const;
  [[nodiscard]] bool inverse_of_middle(const SpanMatrix& A, Matrix& inverse) const;
  [[nodiscard]] double force_bound(const Chain<Interval>& chain, const Point<Interval>& place) const;
  bool bind(Span& known, const Span& other) const {
    known = intersection(known, other);
    return !known.empty();
  }
  [[nodiscard]] Span fx(const Box& z) const { return held_ ? z[n_] : load_x_; }
  [[nodiscard]] Span fy(const Box& z) const { return held_ ? z[n_ + 1] : load_y_; }
  bool recursion(Box& z) const;
  /// One interval Newton step.
  bool newton(Box& z) const;
  bool bounded_force(Box& z) const;
  [[nodiscard]] Span torque_in(const Box& z, std::size_t joint) const;
  bool ranges(Box& z) const;

  std::size_t n_, size_;
  bool held_;
  std::vector<Span> length_, stiffness_, rest_, range_;
  std::vector<bool> passive_;
  Span load_x_, load_y_;
  double force_limit_ = 0, force_weight_ = 1;
};

}  // namespace plumbline::proofs
