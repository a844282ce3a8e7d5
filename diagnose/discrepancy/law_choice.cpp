#include "diagnose/discrepancy/law_choice.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// What may be held against curvature, over the squares of a knot's term. A law with a profile has many knots
/// on both counts, and is smooth.
std::vector<double> smoothnesses(const LawShape& shape) {
  return shape.profile ? std::vector{1e-2, 1e-1} : std::vector{1e-6, 1e-4, 1e-2, 1.0};
}

/// What a shape may be changed to, a part of it at a time.
using Choices = std::vector<std::vector<Eigen::Index>>;

Choices slider_choices() {
  Choices all{{}};
  for (Eigen::Index m = 0; m < slip_places; ++m) {
    all.push_back({m});
    all.push_back({slip_places + m});
    all.push_back({m, slip_places + m});
  }
  all.push_back({0, 2, 4});
  all.push_back({0, 2, 4, slip_places, slip_places + 2, slip_places + 4});
  all.emplace_back();
  for (Eigen::Index m = 0; m < slip_places; ++m) all.back().push_back(m);
  return all;
}

std::vector<LawShape> neighbours(const LawShape& shape) {
  static const Choices sliders = slider_choices(), arms{{}, {0}, {1}, {2}, {0, 1, 2}};
  std::vector<LawShape> all;
  for (const Eigen::Index knots : {3, 5, 9, 17, 33}) all.push_back({knots, shape.sliders, shape.arms});
  for (const auto& chosen : sliders) all.push_back({shape.knots, chosen, shape.arms});
  for (const auto& chosen : arms) all.push_back({shape.knots, shape.sliders, chosen});
  return all;
}

/// The finest terms as combinations of a shape's, for one law.
/// \param all_terms  those of profiles among them or not
Eigen::MatrixXd selection(const LawShape& shape, Eigen::Index all_terms) {
  Eigen::MatrixXd chosen = Eigen::MatrixXd::Zero(all_terms, shape.terms());
  const double stride = static_cast<double>(finest_knots - 1) / static_cast<double>(shape.knots - 1);
  for (Eigen::Index fine = 0; fine < finest_knots; ++fine)
    for (Eigen::Index k = 0; k < shape.knots; ++k)
      chosen(fine, k) =
          std::max(0.0, 1 - std::abs(static_cast<double>(fine) / stride - static_cast<double>(k)));
  Eigen::Index column = shape.knots;
  for (const Eigen::Index m : shape.sliders) chosen(finest_knots + m, column++) = 1;
  for (const Eigen::Index m : shape.arms) chosen(finest_knots + slider_terms + m, column++) = 1;
  if (shape.profile)
    chosen.block(plain_terms + *shape.profile * profile_knots, column, profile_knots, profile_knots)
        .setIdentity();
  return chosen;
}

/// What is held against a law: curvature, and an even part that is no constant, so that a side that was never
/// bent answers as the other; sliders and arms of any size a little.
Eigen::MatrixXd penalty(const LawShape& shape, double smoothness) {
  constexpr double evenness = 1e-5, size = 1e-6;
  Eigen::MatrixXd weight = size * Eigen::MatrixXd::Identity(shape.terms(), shape.terms());
  const auto hold_straight = [&](Eigen::Index first, Eigen::Index knots) {
    for (Eigen::Index k = first + 1; k + 1 < first + knots; ++k) {
      Eigen::VectorXd bend = Eigen::VectorXd::Zero(shape.terms());
      bend(k - 1) = bend(k + 1) = 1;
      bend(k) = -2;
      weight += smoothness * bend * bend.transpose();
    }
  };
  const Eigen::Index profile_at = shape.knots + shape.losses();
  hold_straight(0, shape.knots);
  hold_straight(profile_at, shape.terms() - profile_at);
  const Eigen::Index middle = shape.knots / 2;
  for (Eigen::Index k = 1; k <= middle; ++k) {
    Eigen::VectorXd even = Eigen::VectorXd::Zero(shape.terms());
    even(middle + k) = even(middle - k) = 1;
    even(middle) = -2;
    weight += evenness * even * even.transpose();
  }
  for (Eigen::Index m = shape.knots; m < profile_at; ++m) weight(m, m) += 0.1 * smoothness;
  return weight;
}

/// The same for each of several laws, along the diagonal.
Eigen::MatrixXd repeated(const Eigen::MatrixXd& one, std::size_t laws) {
  const auto count = static_cast<Eigen::Index>(laws);
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(count * one.rows(), count * one.cols());
  for (Eigen::Index b = 0; b < count; ++b)
    all.block(b * one.rows(), b * one.cols(), one.rows(), one.cols()) = one;
  return all;
}

LawSums reduced(const Eigen::MatrixXd& chosen, const LawSums& full) {
  return {chosen.transpose() * full.terms * chosen, chosen.transpose() * full.with_residual, full.residual};
}

/// Least squares in the coefficients of a shape; sliders and arms dissipate, so none is negative. A profile
/// may be: a joint that is driven, or switched at the ends of its way, gives back more than it took.
Eigen::VectorXd solve(const LawShape& shape, const LawSums& sums, const Eigen::MatrixXd& held_against) {
  Eigen::MatrixXd normal = sums.terms + held_against;
  Eigen::VectorXd right = sums.with_residual;
  while (true) {
    const Eigen::VectorXd solution = normal.ldlt().solve(right);
    Eigen::Index worst = -1;
    for (Eigen::Index i = 0; i < solution.size(); ++i) {
      const Eigen::Index term = i % shape.terms() - shape.knots;
      const bool dissipates = term >= 0 && term < shape.losses();
      if (dissipates && solution(i) < 0 && (worst < 0 || solution(i) < solution(worst))) worst = i;
    }
    if (worst < 0) return solution;
    normal.row(worst).setZero();
    normal.col(worst).setZero();
    normal(worst, worst) = 1;
    right(worst) = 0;
  }
}

/// The mean square of a knot's term.
double knot_scale(const LawShape& shape, const LawSums& all) {
  return all.terms.diagonal().head(shape.knots).mean();
}

}  // namespace

void LawSums::operator+=(const LawSums& other) {
  terms += other.terms;
  with_residual += other.with_residual;
  residual += other.residual;
}

void LawSums::operator-=(const LawSums& other) {
  terms -= other.terms;
  with_residual -= other.with_residual;
  residual -= other.residual;
}

double LawSums::left(const Eigen::VectorXd& c) const {
  return std::max(0.0, residual - 2 * c.dot(with_residual) + c.dot(terms * c));
}

bool affordable(const LawShape& shape, std::size_t laws, std::size_t values) {
  return 2 * static_cast<std::size_t>(shape.terms()) * laws <= std::max<std::size_t>(values, 8);
}

ChosenLaw fit_law(const LawShape& shape, std::size_t laws, const LawFolds& folds) {
  const Eigen::Index all_terms = folds.parts.front().with_residual.size() / static_cast<Eigen::Index>(laws);
  const Eigen::MatrixXd chosen = repeated(selection(shape, all_terms), laws);
  std::vector<LawSums> parts;
  for (const LawSums& part : folds.parts) parts.push_back(reduced(chosen, part));
  LawSums whole = parts.front();
  for (std::size_t f = 1; f < parts.size(); ++f) whole += parts[f];
  whole.terms /= folds.times, whole.with_residual /= folds.times, whole.residual /= folds.times;
  ChosenLaw best;
  for (const double smoothness : smoothnesses(shape)) {
    const Eigen::MatrixXd held_against =
        knot_scale(shape, whole) * repeated(penalty(shape, smoothness), laws);
    double left = 0;
    for (const LawSums& part : parts) {
      LawSums rest = whole;
      rest -= part;
      left += part.left(solve(shape, rest, held_against)) / folds.times;
    }
    if (best.coefficients.size() > 0 && !(left < best.left)) continue;
    best = {left, shape, chosen * solve(shape, whole, held_against)};
  }
  return best;
}

ChosenLaw choose_law(const LawFolds& folds, std::size_t values) {
  constexpr int rounds = 6;
  // Of the squares: a profile follows much that has another reason.
  constexpr double clearly = 0.8;
  ChosenLaw best = fit_law({}, 1, folds);
  const auto try_one = [&](const LawShape& other, double asked) {
    if (!affordable(other, 1, values)) return;
    if (ChosenLaw trial = fit_law(other, 1, folds); trial.left < best.left - asked) best = std::move(trial);
  };
  for (int round = 0; round < rounds; ++round) {
    const double before = best.left;
    for (const LawShape& other : neighbours(best.shape))
      try_one(other, other.terms() > best.shape.terms() ? noticed_gain : 0);
    if (!(best.left < before)) break;
  }
  const double asked = (1 - clearly) * best.left;
  for (Eigen::Index slip = 0; slip < profile_count; ++slip)
    try_one({profile_knots, {}, {}, slip}, best.shape.profile ? 0 : asked);
  return best;
}

}  // namespace plumbline::diagnose
