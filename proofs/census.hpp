#pragma once
/// \file
/// All equilibria of a chain, certified complete.
///
/// The search covers every shape: under an imposed end point every joint deflects by up to half a turn from
/// rest, |q_i - rest_i| <= pi, so each shape of the chain occurs once, with the smallest deflections that
/// make it; under an imposed force |k_i (q_i - rest_i)| <= |F| z_i bounds the deflections, and nothing at all
/// is left out. A passive joint is counted once around, |q_i| <= pi. With |q_i - rest_i| <= pi the joint
/// moments are bounded, and so is the force: were all joints within delta of the line along F through the end
/// point, |p| would be within 4 delta^2 sum 1/L_i + delta of a sum ±L_1 … ±L_n; so some joint is farther off,
/// and its moment bounds |F|.
///
/// Branch and bound: a box of angles and force is contracted by the moment recursion from both ends and by an
/// interval Newton step, dropped when empty, and halved. Around each root found, a box as large as possible
/// is proved to hold exactly one (Krawczyk), and what lies in it is dropped. What can be neither dropped nor
/// proved at the smallest size is reported as undecided: there equilibria are degenerate, or nearly.

#include <plumbline/loaded/equilibrium.hpp>
#include <string>
#include <vector>

namespace plumbline::proofs {

/// One equilibrium, enclosed: exactly one lies in the box.
struct CertifiedEquilibrium {
  std::vector<Interval> q;  ///< relative joint angles
  Interval fx, fy;          ///< force that the environment exerts on the end point
  Interval x, y;            ///< end point
  Interval energy;          ///< stored energy
  /// Negative directions of the Hessian in the sense of the control; nothing where the enclosure leaves it
  /// open.
  std::optional<std::size_t> negative_directions;
};

struct Census {
  std::vector<CertifiedEquilibrium> equilibria;  ///< by energy
  std::vector<std::vector<Interval>> undecided;  ///< boxes of joint angles that may hold further ones
  std::size_t boxes;                             ///< visited by the search

  /// Whether `equilibria` is all there is.
  [[nodiscard]] bool complete() const { return undecided.empty(); }
};

struct CensusLimits {
  double smallest = 1e-6;        ///< width of a box, in radians, that is not halved any more
  std::size_t boxes = 60000000;  ///< after so many, about a minute, the search gives up
};

/// All equilibria with the end point held at a place.
/// \throws Error out of reach; where some shape with all links in one line has this end point, or nearly (the
/// force
///         is not bounded); for more than `most_links`; when the box limit is reached
Census census_at_end_point(const Chain<Interval>& chain, const Point<Interval>& place,
                           const CensusLimits& limits = {});

/// All equilibria under a force.
Census census_under_force(const Chain<Interval>& chain, const Point<Interval>& force,
                          const CensusLimits& limits = {});

}  // namespace plumbline::proofs
