#pragma once
/// \file
/// The loaded chains of sections 2 and 3: all their equilibria at a deflection, and their paths.

#include <functional>
#include <string>
#include <vector>

#include "proofs/census/census.hpp"
#include "proofs/paths/certified_path.hpp"
#include "proofs/paths/located_event.hpp"
#include "verify/judging/claim.hpp"

namespace plumbline::verify {

struct SlowPath;

/// A chain whose end point is held on the x axis.
struct HeldChain {
  Chain<Interval> chain;
  Interval reach;  ///< of the unloaded end point

  /// All equilibria at a deflection, proved complete. \throws Error where it is not decided
  [[nodiscard]] const proofs::Census& at(const Interval& deflection) const;
  [[nodiscard]] const proofs::Census& at(const Rational& deflection) const {
    return at(Interval(deflection));
  }
  /// What it does as it is slowly compressed so far. Computed once.
  [[nodiscard]] const SlowPath& compressed(double last) const;
};

/// The chain of a premise.
HeldChain held(const Premises& given, const std::string& id);

/// As far as the paths of Fig. 7 and of the chains of Table 1 are followed.
inline constexpr double far = 1.5;

/// Jacobian of a bent chain of n unit links, in rationals: rank 2.
Matrix<Rational> bent_jacobian(std::size_t n);

/// Its numbers, to tell it from others.
std::string key_of(const HeldChain& chain);

/// A chain held by its unloaded end point, turned onto the x axis.
HeldChain held(const Chain<Interval>& chain);

/// All equilibria with the end point on the x axis, proved complete. Computed once.
/// \throws Error where it is not decided
const proofs::Census& held_at(const Chain<Interval>& chain, const Interval& x);

/// The force of the paper's (6), J^T F + M = 0: what the chain exerts through its end point, with F_x
/// positive in compression. The program's own is what the environment exerts.
template <class Real>
struct PaperForce {
  Real x, y;
};
PaperForce<Interval> paper_force(const proofs::CertifiedEquilibrium& one);
template <class Real>
PaperForce<Real> paper_force(const BranchPoint<Real>& point) {
  return {-point.force.x, -point.force.y};
}

/// "2 stable, 2 unstable".
std::string types(const proofs::Census& census);
/// "1 minimum, 1 saddle, 1 maximum" of the energy of a four-link chain; on one sheet of the elbow if a sign
/// of q_4 is given.
std::string extrema(const proofs::Census& census, int sign_of_q4 = 0);

/// Signs of joint angles, such as "-+-+"; of all, or from a joint (counted from 0) on.
std::string signs(const proofs::CertifiedEquilibrium& one, std::size_t from = 0);
/// The shape of three links in the paper's words: U+ has two negative bends (3.1, before Fig. 7), U- two
/// positive ones; of the Z-shapes, with a bend of either sign, Z- has a negative first angle (3.1, Fig. 9).
std::string letter(const proofs::CertifiedEquilibrium& one);

/// A length as it is said: "0.1 L", or "0.0407 L" where it has no short decimal.
std::string in_lengths(const Rational& length);
/// Several: "0.1, 0.4 and 0.8 L".
std::string in_lengths(const std::vector<Rational>& lengths);

/// A number of an event as it is printed: no more digits than it is located to.
std::string located(const proofs::Located& number, int digits);

/// What a slowly compressed chain does: followed in double precision, its events located to fifty digits, its
/// stretches proved. Its end point stays on the x axis.
struct SlowPath {
  Chain<Interval> enclosed;
  Interval reach;  ///< of the unloaded end point
  Chain<proofs::Located> chain;
  Loading<proofs::Located> loading;
  std::vector<Branch<double>> stretches;             ///< one, and another after every loss of stability
  std::vector<BranchEvent<proofs::Located>> events;  ///< of all stretches
  std::vector<proofs::PathCertificate> proved;       ///< of each stretch

  [[nodiscard]] std::vector<BranchEvent<proofs::Located>> of_kind(EventKind kind) const;
  /// Proved: a stable equilibrium all the way, without bifurcation, fold or jump, which depends analytically
  /// on the deflection.
  [[nodiscard]] bool regular() const;
  /// "continuous", "a jump", or "open" where the proof fails.
  [[nodiscard]] std::string continuity() const;
  /// Proved: regular, and the force grows all along.
  [[nodiscard]] bool stiff() const;
  /// How many minima the tangent stiffness has along a regular path, proved.
  /// \throws Error where that is open
  [[nodiscard]] std::size_t softest() const;
  /// Proved: what is asked holds of every state of one stretch between two deflections; the question is put
  /// to enclosures of its joint angles and force, which may hold several states. The proof is without units,
  /// and so are these chains: their longest link and largest stiffness are one.
  [[nodiscard]] bool everywhere(const Rational& from, const Rational& to,
                                const std::function<bool(const proofs::CertifiedEquilibrium&)>& holds) const;
  /// What is proved of the stretches, in words.
  [[nodiscard]] Evidence evidence() const;
  /// The state at a deflection, to 64 digits.
  [[nodiscard]] BranchPoint<proofs::Located> at(const Rational& deflection) const;
};
SlowPath compress_slowly(const HeldChain& chain, double last, int side = 1);

/// The equilibrium of a census that a path has at that deflection.
/// \throws Error where there is none
proofs::CertifiedEquilibrium reached(const proofs::Census& census, const SlowPath& path,
                                     const Rational& deflection);

/// The states of a path at some deflections, each in a certified census.
std::vector<proofs::CertifiedEquilibrium> states(const SlowPath& path,
                                                 const std::vector<Rational>& deflections);

/// Mean stiffness of a path between neighbouring deflections, certified: somewhere between them the tangent
/// stiffness has that value.
std::vector<Interval> mean_stiffnesses(const SlowPath& path, const std::vector<Rational>& deflections);

/// The deflection at which a joint angle of the slowly compressed chain passes zero, between two deflections
/// where it has different signs. Computed once.
proofs::Located straightens_at(const SlowPath& path, std::size_t joint, const Rational& from,
                               const Rational& to);

/// The branch through an equilibrium of a census at a deflection, followed in double precision to growing or
/// falling deflection as far as the limits.
Branch<double> branch_through(const HeldChain& chain, const proofs::CertifiedEquilibrium& one,
                              double deflection, int direction, const TraceLimits<double>& limits);

/// Proofs that stable shapes leave a bifurcation for growing deflection: to each side, from next to it up to
/// another deflection.
std::vector<proofs::PathCertificate> leaving(const SlowPath& path,
                                             const BranchEvent<proofs::Located>& bifurcation, double to);

}  // namespace plumbline::verify
