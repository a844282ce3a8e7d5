#pragma once
/// \file
/// A straight uniform rod (Euler, Bernoulli: it bends, and neither shears nor shortens) with its ends,
/// supports and loads: the limit of a chain of n equal bars as n grows.
///
/// Small deflections w(x) of the rod compressed by N(x) have, against every w̃ that the supports allow,
///
///     a(w, w̃) = ∫ E I w'' w̃'' - N w' w̃' + (b - m ω²) w w̃ dx + Σ c w' w̃' + Σ k w w̃ + Σ p w' w̃ = 0 ,
///
/// b the stiffness of the bed, m = 1 the mass, both per length, c and k springs against turning and across, p
/// forces that follow the tangent (q such a force per length: ∫ q w' w̃ dx). Only these terms are not
/// symmetric: without them there is an energy.

#include <plumbline/structure/structure.hpp>

namespace plumbline::proofs {

/// A force on the rod, against x where it is positive.
struct RodLoad {
  Rational at;                     ///< from the base
  Rational force;                  ///< at load factor 1
  bool multiplied = true;          ///< by the load factor; else it is there as it stands
  LoadKind kind = LoadKind::dead;  ///< dead, or along the tangent
};

/// Own weight of a stretch of the rod, against x where it is positive.
struct RodWeight {
  Rational from, to;               ///< from the base
  Rational per_length;             ///< at load factor 1
  bool multiplied = true;          ///< by the load factor
  LoadKind kind = LoadKind::dead;  ///< dead, or along the tangent
};

/// A support between the ends.
struct RodSupport {
  Rational at;  ///< from the base
  Restraint<Rational> across;
};

struct Rod {
  Rational EI{1}, length{1};                    ///< bending stiffness; length
  Support<Rational> base = pinned<Rational>();  ///< whose springs across and against turning are the rod's
  Support<Rational> end_point = guided<Rational>();
  std::vector<RodSupport> supports = {};
  Rational bed{0};  ///< force per deflection and length
  std::vector<RodLoad> loads = {};
  std::vector<RodWeight> weights = {};
};

/// What is proportional to the load factor but for a part that is fixed.
struct Growing {
  Rational fixed{0}, multiplied{0};

  Growing& operator+=(const Growing& other) {
    fixed += other.fixed;
    multiplied += other.multiplied;
    return *this;
  }
};

/// A place where something holds the rod or acts on it.
struct RodNode {
  Restraint<Rational> across, turn;
  Growing follower;  ///< force along the tangent
};

/// A stretch between two nodes, on which the compression is linear.
struct RodStretch {
  Rational length;
  Growing compression;  ///< at its beginning
  Growing slope;        ///< growth of the compression along it
  Growing tangential;   ///< force along the tangent, per length
};

/// A rod from node to node, in units of its length and of E I / length^2.
struct DividedRod {
  std::vector<RodNode> nodes;         ///< the base first
  std::vector<RodStretch> stretches;  ///< stretch i between the nodes i and i + 1
  Rational bed;
  /// Whether some load follows the tangent where the rod can move: then there is no energy.
  [[nodiscard]] bool follower() const;
};

/// \throws Error where not exactly one end is held along the rod
DividedRod divided(const Rod& rod);

}  // namespace plumbline::proofs
