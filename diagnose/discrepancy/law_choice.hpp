#pragma once
/// \file
/// Which terms a torque law takes and how smooth it is, by cross-validation.

#include <optional>
#include <vector>

#include "diagnose/discrepancy/law_terms.hpp"

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

/// The values in folds, each of them in as many: what every fold holds is predicted from all the others.
struct LawFolds {
  std::vector<LawSums> parts;
  double times = 1;  ///< so many folds hold each value
};

/// Which terms a law may use.
struct LawShape {
  Eigen::Index knots = 3;
  std::vector<Eigen::Index> sliders = {}, arms = {};
  std::optional<Eigen::Index> profile = {};  ///< which of the sliders that may have one

  /// Those that dissipate.
  [[nodiscard]] Eigen::Index losses() const {
    return static_cast<Eigen::Index>(sliders.size() + arms.size());
  }
  [[nodiscard]] Eigen::Index terms() const { return knots + losses() + (profile ? profile_knots : 0); }
};

/// Laws side by side, all of one shape.
struct ChosenLaw {
  double left = 0;  ///< sum of squares of the values, each predicted without the fold that holds it
  LawShape shape;
  Eigen::VectorXd coefficients;  ///< of all terms, one law after the other
};

/// What a shape has to gain over another, in chi-square: a term that is not there gains one or two by chance.
inline constexpr double noticed_gain = 4;

/// The law of a shape that predicts best the folds left out in turn, over how smooth it is. Curvature is held
/// against it, and an even part, so that a side that was never bent answers as the other.
/// \param laws  how many laws the terms belong to
ChosenLaw fit_law(const LawShape& shape, std::size_t laws, const LawFolds& folds);

/// The best one law over its shape: from a straight one, changed in one part at a time (knots, sliders, arms)
/// while that helps; or one of a slider with a profile, where that leaves clearly less.
/// \param values  how many values there are
ChosenLaw choose_law(const LawFolds& folds, std::size_t values);

/// Whether there are two values for each coefficient.
bool affordable(const LawShape& shape, std::size_t laws, std::size_t values);

}  // namespace plumbline::diagnose
