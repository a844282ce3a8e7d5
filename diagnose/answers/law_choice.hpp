#pragma once
/// \file
/// Which terms a torque law takes and how smooth it is, by cross-validation.

#include "diagnose/answers/law_terms.hpp"

namespace plumbline::diagnose {

/// Sums of squares and products of all terms and of the residual, over the values of one fold.
struct LawSums {
  Eigen::MatrixXd terms;
  Eigen::VectorXd with_residual;
  double residual = 0;

  void operator+=(const LawSums& other);
  void operator-=(const LawSums& other);
  /// What coefficients leave of the residual.
  [[nodiscard]] double left(const Eigen::VectorXd& coefficients) const;
};

/// Laws side by side, all of one shape.
struct ChosenLaw {
  double left = 0;               ///< sum of squares of the folds, each predicted without itself
  Eigen::Index knots = 0;        ///< of each law
  Eigen::VectorXd coefficients;  ///< of all terms, one law after the other
};

/// The law that predicts best the folds left out in turn: from a straight one, changed in one part at a time
/// (knots, sliders, arms) while that helps. Curvature is held against it, and an even part, so that a side
/// that was never bent answers as the other.
/// \param laws    how many laws the terms belong to
/// \param values  how many values there are: a law has half as many coefficients at most
ChosenLaw choose_law(std::size_t laws, const std::vector<LawSums>& by_fold, std::size_t values);

}  // namespace plumbline::diagnose
