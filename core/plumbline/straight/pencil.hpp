#pragma once
/// \file
/// A straight structure as a symmetric pencil: the loads' factors at which it may leave the straight line are
/// the positive eigenvalues of K - factor G.
///
/// The unknowns are the deflections w of the nodes across the line, those that are held left out, those of a
/// clamped link taken as one. With the slopes t_j = (w_j - w_{j-1}) / L_j and N = fixed + factor multiplied,
///
///     2 E = sum k_i (t_i - t_{i-1})^2 + sum s_i w_i^2 - sum N_j L_j t_j^2 ,
///
/// so that K and G have half a bandwidth of two, whatever holds the chain.

#include <plumbline/base/bordered_band.hpp>
#include <plumbline/structure/structure.hpp>

namespace plumbline {

/// K - factor G.
template <Number Real>
struct StraightPencil {
  Band<Real, 2> stiffness;            ///< K: springs and fixed loads
  Band<Real, 2> load;                 ///< G: loads that the factor multiplies
  std::vector<Eigen::Index> unknown;  ///< of each node, -1 for one that is held

  /// Number of unknowns.
  [[nodiscard]] Eigen::Index size() const { return stiffness.cols(); }
  /// The matrix at a factor.
  [[nodiscard]] Band<Real, 2> at(const Real& factor) const {
    Band<Real, 2> T = stiffness;
    for (Eigen::Index i = 0; i < T.cols(); ++i) {
      for (Eigen::Index d = 0; d <= 2; ++d) T(d, i) -= factor * load(d, i);
    }
    return T;
  }
  /// Deflections of all nodes from those that are unknown.
  [[nodiscard]] std::vector<Real> deflections(const Vector<Real>& w) const {
    std::vector<Real> all;
    for (const Eigen::Index i : unknown) all.push_back(i < 0 ? Real(0) : w(i));
    return all;
  }
};

namespace detail {

/// The unknowns of the nodes.
template <Number Real>
std::vector<Eigen::Index> unknowns(const Structure<Real>& structure) {
  const std::size_t n = structure.chain.size();
  std::vector<std::size_t> leader(n + 1);  // of what moves as one
  for (std::size_t i = 0; i <= n; ++i) leader[i] = i;
  if (structure.base.turn.is_held()) leader[1] = leader[0];
  if (structure.end_point.turn.is_held()) leader[n] = leader[n - 1];
  std::vector<bool> held(n + 1, false);
  for (std::size_t i = 0; i <= n; ++i) {
    if (structure.across_at(i).is_held()) held[leader[i]] = true;
  }
  std::vector<Eigen::Index> unknown(n + 1, -1);
  Eigen::Index next = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    if (leader[i] == i && !held[i]) unknown[i] = next++;
    if (leader[i] != i) unknown[i] = unknown[leader[i]];
  }
  return unknown;
}

/// Adds factor (sum c_a w_a)^2 to a quadratic form.
template <Number Real, std::size_t terms>
void add_square(Band<Real, 2>& matrix, const std::array<std::pair<Eigen::Index, Real>, terms>& sum,
                const Real& factor) {
  for (const auto& [i, a] : sum) {
    for (const auto& [j, b] : sum) {
      if (i >= 0 && j >= 0 && i >= j) matrix(i - j, j) += factor * a * b;
    }
  }
}

}  // namespace detail

/// \throws Error for a structure that is not sound, whose loads do not lie along it, or that has no load to
///         multiply; and for a follower load, whose pencil is not symmetric
template <Ordered Real>
StraightPencil<Real> straight_pencil(const Structure<Real>& structure) {
  structure.require_sound();
  if (structure.follower())
    throw Error("load", "a follower force, which has no energy",
                "dead forces: the symmetric pencil is theirs");
  const auto [fixed, multiplied] = compression(structure);
  const Chain<Real>& chain = structure.chain;
  const std::size_t n = chain.size();
  StraightPencil<Real> pencil{{}, {}, detail::unknowns(structure)};
  const Eigen::Index size = *std::max_element(pencil.unknown.begin(), pencil.unknown.end()) + 1;
  pencil.stiffness = Band<Real, 2>::Constant(3, size, Real(0));
  pencil.load = pencil.stiffness;
  const auto slope = [&](std::size_t link) {  // from 0
    const Real per_length = Real(1) / chain.length()[link];
    return std::array{std::pair(pencil.unknown[link], Real(-per_length)),
                      std::pair(pencil.unknown[link + 1], per_length)};
  };
  for (std::size_t i = 0; i < n; ++i) {
    const auto ahead = slope(i);
    if (i == 0) {
      if (!structure.base.turn.is_held()) detail::add_square(pencil.stiffness, ahead, chain.stiffness()[0]);
    } else {
      const auto behind = slope(i - 1);
      const std::array bend{std::pair(behind[0].first, Real(-behind[0].second)),
                            std::pair(behind[1].first, Real(-behind[1].second)), ahead[0], ahead[1]};
      detail::add_square(pencil.stiffness, bend, chain.stiffness()[i]);
    }
    detail::add_square(pencil.stiffness, ahead, Real(-fixed[i] * chain.length()[i]));
    detail::add_square(pencil.load, ahead, Real(multiplied[i] * chain.length()[i]));
  }
  if (structure.end_point.turn.hold == Hold::sprung)
    detail::add_square(pencil.stiffness, slope(n - 1), structure.end_point.turn.stiffness);
  for (std::size_t i = 0; i <= n; ++i) {
    const Restraint<Real> across = structure.across_at(i);
    if (across.hold == Hold::sprung)
      detail::add_square(pencil.stiffness, std::array{std::pair(pencil.unknown[i], Real(1))},
                         across.stiffness);
  }
  return pencil;
}

/// The number of negative eigenvalues of an exact band, singular or not.
template <Ordered Real>
std::size_t negative_eigenvalues(const Band<Real, 2>& matrix) {
  BorderedBand<Real, 2> factored(Real(0));
  factored.factor(matrix);
  factored.no_border();
  return factored.negative(0);
}

/// What an exact pencil is about.
struct PencilKind {
  std::size_t unstable;  ///< directions in which the structure gives way before the factor grows
  bool mechanism;        ///< whether one costs nothing
  std::size_t modes;     ///< positive eigenvalues of the pencil
};

/// Of an exact pencil. Its eigenvalues are counted by inertia: where K is positive definite, so many below a
/// factor F > 0 as K - F G has negative eigenvalues, and as many altogether as G has positive ones.
inline PencilKind kind_of(const StraightPencil<Rational>& pencil) {
  const auto negated = [](Band<Rational, 2> matrix) {
    for (Eigen::Index i = 0; i < matrix.cols(); ++i) {
      for (Eigen::Index d = 0; d <= 2; ++d) matrix(d, i) = -matrix(d, i);
    }
    return matrix;
  };
  const std::size_t negative = negative_eigenvalues(pencil.stiffness);
  const std::size_t positive = negative_eigenvalues(negated(pencil.stiffness));
  return {negative, negative + positive < static_cast<std::size_t>(pencil.size()),
          negative_eigenvalues(negated(pencil.load))};
}

}  // namespace plumbline
