#pragma once
/// \file
/// All equilibria of a chain, certified complete.
///
/// Under an imposed force |k_i (q_i - rest_i)| <= |F| z_i bounds the deflections, and the search covers every
/// shape. With the end point held it covers a window of joint angles (proofs/census/window.hpp), there every
/// shape. A passive joint is counted once around. In a window the joint moments are bounded, and so is the
/// force: were all joints within delta of the line along F through the end point, |p| would be within 4
/// delta^2 sum 1/L_i + delta of a sum ±L_1 … ±L_n; so some joint is farther off, and its moment bounds |F|.
///
/// The chain is measured in units of its own first, so that no number is far from one without need.
///
/// Branch and bound: a box of angles and force is contracted by the moment recursion from both ends and by an
/// interval Newton step, dropped when empty, and halved. Around each root found, a box as large as possible
/// is proved to hold exactly one (Krawczyk), and what lies in it is dropped. What can be neither dropped nor
/// proved at the smallest size is reported as undecided: there equilibria are degenerate, or nearly. Where
/// such boxes stand side by side equilibria form a continuum, and the search stops.
///
/// A complete census is checked against topology: where the space of shapes has no border, the sum of
/// (-1)^(negative directions) is its Euler characteristic, with the end point held as in
/// proofs/census/window.hpp, and under a force 1, or 0 where a joint is passive.

#include <plumbline/loaded/equilibrium.hpp>
#include <string>
#include <vector>

#include "proofs/census/window.hpp"

namespace plumbline::proofs {

/// One equilibrium, enclosed: exactly one lies in the box.
struct CertifiedEquilibrium {
  std::vector<Interval> q;  ///< relative joint angles; a passive joint's within half a turn
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
  Window window;                                 ///< the joint angles counted; empty under a force: all
  std::size_t boxes;                             ///< visited by the search
  bool balanced;  ///< whether topology has a law for the count here, which then holds

  /// Whether `equilibria` is all there is in the window.
  [[nodiscard]] bool complete() const { return undecided.empty(); }
};

struct CensusLimits {
  double smallest = 1e-6;        ///< width of a box, in radians, that is not halved any more
  std::size_t boxes = 60000000;  ///< after so many, about a minute, the search gives up
  std::size_t open = 10000;      ///< smallest boxes that stay undecided: more are a continuum
  std::size_t listed = 10000;    ///< so many equilibria, or places left undecided, and no more
};

/// All equilibria with the end point held at a place, in a window of joint angles, `unwound` if none is
/// given.
/// \throws Error out of reach; where some shape with all links in one line has this end point, or
/// nearly (the
///         force is not bounded); for more than `most_links`; where lengths or stiffnesses differ by more
///         than 1e60; when a limit is reached; at a continuum; when the count contradicts topology
Census census_at_end_point(const Chain<Interval>& chain, const Point<Interval>& place,
                           const Window& window = {}, const CensusLimits& limits = {});

/// All equilibria under a force.
/// \throws Error for more than `most_links`; where lengths or stiffnesses differ by more than 1e60, or the
///         force could turn a joint by more than 1e5 rad; when a limit is reached; at a continuum; when the
///         count contradicts topology
Census census_under_force(const Chain<Interval>& chain, const Point<Interval>& force,
                          const CensusLimits& limits = {});

}  // namespace plumbline::proofs
