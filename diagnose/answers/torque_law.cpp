#include "diagnose/answers/torque_law.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumbline::diagnose {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr std::size_t folds = 5;

/// The base model and how its channels answer to a torque at each elastic joint.
struct Response {
  Prediction base;
  std::vector<std::size_t> joints;               ///< elastic, from 0
  std::vector<std::vector<Trace>> per_torque;    ///< [joint][run], by 1 N m
};

Response response(const Study& study, const Instance& base) {
  Response all;
  Candidate torques;
  for (std::size_t j = 0; j < study.experiment().link_length.size(); ++j) {
    if (!(study.experiment().joint_stiffness[j] > 0)) continue;
    all.joints.push_back(j);
    torques.effects.emplace_back("rest_angle", j + 1);
  }
  // An error of the rest angle by one radian is a torque of minus the joint's stiffness.
  Prediction nominal = predict(study, torques, std::vector<double>(all.joints.size(), 0.0), true);
  all.per_torque = std::move(nominal.sensitivity);
  for (std::size_t a = 0; a < all.joints.size(); ++a)
    for (Trace& trace : all.per_torque[a]) trace /= -study.experiment().joint_stiffness[all.joints[a]];
  all.base = base.candidate.effects.empty() ? study.nominal() : predict(study, base.candidate, base.parameters);
  return all;
}

/// A joint's deflection in a run as the base model has it.
Vector deflection(const Study& study, const Prediction& base, std::size_t run, std::size_t joint) {
  const auto column = base.runs[run].col(column_q + static_cast<Eigen::Index>(joint));
  return column.matrix().array() - study.experiment().runs[run].rest[joint];
}

LawSpan span_of(const Study& study, const Prediction& base, const std::vector<std::size_t>& joints) {
  LawSpan span;
  double low = 0, high = 0;
  for (std::size_t r = 0; r < base.runs.size(); ++r) {
    for (const std::size_t j : joints)
      for (const double d : deflection(study, base, r, j))
        if (std::isfinite(d)) low = std::min(low, d), high = std::max(high, d);
    const std::vector<Reading>& readings = study.experiment().runs[r].readings;
    span.duration = std::max(span.duration, readings.back().t - readings.front().t);
  }
  span.deflection = std::max(high, -low);
  span.stroke = (high - low) / 2;
  return span;
}

/// Adds to every channel, in traces, what one law's terms with these coefficients change; calls
/// `add(joint's part, run, terms)` for each joint and run.
template <class Add>
void for_each_part(const Study& study, const Response& rig, const JointTorqueLaw& law, Add add) {
  for (const std::size_t number : law.joints) {
    const std::size_t j = number - 1;
    const auto a = static_cast<std::size_t>(std::find(rig.joints.begin(), rig.joints.end(), j) - rig.joints.begin());
    const double share = study.experiment().joint_stiffness[j] / law.stiffness;
    for (std::size_t r = 0; r < study.experiment().runs.size(); ++r)
      add(a, r, share * law_terms(law.span, study.experiment().runs[r], deflection(study, rig.base, r, j)));
  }
}

/// Where the law may be: laws without coefficients yet.
using Placement = std::vector<JointTorqueLaw>;

JointTorqueLaw blank(const Study& study, const Response& rig, const std::vector<std::size_t>& joints) {
  JointTorqueLaw law;
  law.span = span_of(study, rig.base, joints);
  for (const std::size_t j : joints) {
    law.joints.push_back(j + 1);
    law.stiffness += study.experiment().joint_stiffness[j] / static_cast<double>(joints.size());
  }
  return law;
}

/// One joint; all of them with one law, in proportion to their stiffness; each its own.
std::vector<Placement> places(const Study& study, const Response& rig) {
  constexpr std::size_t most_own = 6;
  std::vector<Placement> all;
  for (const std::size_t j : rig.joints)
    if (JointTorqueLaw law = blank(study, rig, {j}); law.span.stroke > 0) all.push_back({std::move(law)});
  if (all.size() < 2) return all;
  all.push_back({blank(study, rig, rig.joints)});
  if (rig.joints.size() > most_own) return all;
  all.emplace_back();
  for (const std::size_t j : rig.joints) all.back().push_back(blank(study, rig, {j}));
  return all;
}

/// Sums of squares and products of the terms and of the residual, over the values of one fold.
struct Sums {
  Matrix terms;
  Vector with_residual;
  double residual = 0;

  void operator+=(const Sums& other) {
    terms += other.terms;
    with_residual += other.with_residual;
    residual += other.residual;
  }
  void operator-=(const Sums& other) {
    terms -= other.terms;
    with_residual -= other.with_residual;
    residual -= other.residual;
  }
  /// What coefficients leave of the residual.
  [[nodiscard]] double left(const Vector& c) const {
    return std::max(0.0, residual - 2 * c.dot(with_residual) + c.dot(terms * c));
  }
};

/// The fold of a reading: ten blocks of neighbours in every run, two to a fold.
std::size_t fold_of(std::size_t run, std::size_t reading, std::size_t readings) {
  return (10 * reading / readings + run) % folds;
}

std::vector<Sums> sums_of(const Study& study, const Response& rig, const Placement& place,
                          const std::vector<double>& residual, const NoiseModel& noise) {
  const auto width = static_cast<Eigen::Index>(place.size()) * law_terms_count;
  const Sums none{Matrix::Zero(width, width), Vector::Zero(width), 0};
  std::vector<Sums> by_fold(folds, none);
  Matrix slopes = Matrix::Zero(static_cast<Eigen::Index>(residual.size()), width);
  for (std::size_t b = 0; b < place.size(); ++b) {
    for_each_part(study, rig, place[b], [&](std::size_t a, std::size_t run, const Matrix& terms) {
      for (const Series& series : study.measurements().series()) {
        if (series.run != run) continue;
        const double unit = 1 / (series.sigma * noise.of(series.channel));
        const auto answer = rig.per_torque[a][run].col(series.channel.column());
        for (std::size_t i = 0; i < series.readings.size(); ++i) {
          const auto reading = static_cast<Eigen::Index>(series.readings[i]);
          slopes.row(static_cast<Eigen::Index>(series.first + i))
              .segment(static_cast<Eigen::Index>(b) * law_terms_count, law_terms_count) +=
              unit * answer(reading) * terms.row(reading);
        }
      }
    });
  }
  for (const Series& series : study.measurements().series()) {
    const std::size_t readings = study.experiment().runs[series.run].readings.size();
    // Neighbours in one fold are one slab of rows.
    std::size_t from = 0;
    while (from < series.readings.size()) {
      const std::size_t fold = fold_of(series.run, series.readings[from], readings);
      std::size_t to = from;
      while (to < series.readings.size() && fold_of(series.run, series.readings[to], readings) == fold) ++to;
      const auto rows = slopes.middleRows(static_cast<Eigen::Index>(series.first + from),
                                          static_cast<Eigen::Index>(to - from));
      const Vector part = Eigen::Map<const Vector>(residual.data() + series.first + from,
                                                   static_cast<Eigen::Index>(to - from)) /
                          noise.of(series.channel);
      by_fold[fold] += {rows.transpose() * rows, rows.transpose() * part, part.squaredNorm()};
      from = to;
    }
  }
  return by_fold;
}

/// Which terms a law may use and how smooth it is.
struct Shape {
  Eigen::Index knots;
  std::vector<Eigen::Index> sliders, arms;
  double smoothness;

  [[nodiscard]] Eigen::Index terms() const {
    return knots + static_cast<Eigen::Index>(sliders.size() + arms.size());
  }
};

std::vector<Shape> shapes() {
  std::vector<std::vector<Eigen::Index>> slider_sets{{}}, arm_sets{{}, {0}, {1}, {2}, {0, 1, 2}};
  for (Eigen::Index m = 0; m < slider_terms; ++m) slider_sets.push_back({m});
  slider_sets.push_back({0, 2, 4});
  slider_sets.push_back({0, 1, 2, 3, 4, 5});
  std::vector<Shape> all;
  for (const Eigen::Index knots : {3, 5, 9, 17, 33})
    for (const auto& sliders : slider_sets)
      for (const auto& arms : arm_sets)
        for (const double smoothness : {1e-6, 1e-4, 1e-2, 1.0}) all.push_back({knots, sliders, arms, smoothness});
  return all;
}

/// The finest terms as combinations of a shape's, for one law.
Matrix selection(const Shape& shape) {
  Matrix chosen = Matrix::Zero(law_terms_count, shape.terms());
  const double stride = static_cast<double>(finest_knots - 1) / static_cast<double>(shape.knots - 1);
  for (Eigen::Index fine = 0; fine < finest_knots; ++fine)
    for (Eigen::Index k = 0; k < shape.knots; ++k)
      chosen(fine, k) = std::max(0.0, 1 - std::abs(static_cast<double>(fine) / stride - static_cast<double>(k)));
  Eigen::Index column = shape.knots;
  for (const Eigen::Index m : shape.sliders) chosen(finest_knots + m, column++) = 1;
  for (const Eigen::Index m : shape.arms) chosen(finest_knots + slider_terms + m, column++) = 1;
  return chosen;
}

/// What is held against a law: curvature, and an even part that is no constant, so that a side that was never
/// bent answers as the other; sliders and arms of any size a little.
Matrix penalty(const Shape& shape) {
  constexpr double evenness = 1e-3, size = 1e-6;
  Matrix weight = size * Matrix::Identity(shape.terms(), shape.terms());
  for (Eigen::Index k = 1; k + 1 < shape.knots; ++k) {
    Vector bend = Vector::Zero(shape.terms());
    bend(k - 1) = bend(k + 1) = 1;
    bend(k) = -2;
    weight += shape.smoothness * bend * bend.transpose();
  }
  const Eigen::Index middle = shape.knots / 2;
  for (Eigen::Index k = 1; k <= middle; ++k) {
    Vector even = Vector::Zero(shape.terms());
    even(middle + k) = even(middle - k) = 1;
    even(middle) = -2;
    weight += evenness * even * even.transpose();
  }
  for (Eigen::Index m = shape.knots; m < shape.terms(); ++m) weight(m, m) += 0.1 * shape.smoothness;
  return weight;
}

/// Least squares in the coefficients of a shape; sliders and arms dissipate, so none is negative.
class ShapedFit {
 public:
  ShapedFit(const Shape& shape, std::size_t laws) : shape_(shape) {
    const auto count = static_cast<Eigen::Index>(laws);
    const Matrix one = selection(shape), weight = penalty(shape);
    chosen_ = Matrix::Zero(count * one.rows(), count * one.cols());
    penalty_ = Matrix::Zero(count * one.cols(), count * one.cols());
    for (Eigen::Index b = 0; b < count; ++b) {
      chosen_.block(b * one.rows(), b * one.cols(), one.rows(), one.cols()) = one;
      penalty_.block(b * one.cols(), b * one.cols(), one.cols(), one.cols()) = weight;
    }
  }

  [[nodiscard]] Sums reduced(const Sums& full) const {
    return {chosen_.transpose() * full.terms * chosen_, chosen_.transpose() * full.with_residual, full.residual};
  }

  [[nodiscard]] Vector finest(const Vector& coefficients) const { return chosen_ * coefficients; }

  /// \param scale  of the squares of a knot's term over all values: unit of the penalty
  [[nodiscard]] Vector solve(const Sums& sums, double scale) const {
    Matrix normal = sums.terms + scale * penalty_;
    Vector right = sums.with_residual;
    for (Eigen::Index round = 0; round <= static_cast<Eigen::Index>(shape_.sliders.size() + shape_.arms.size());
         ++round) {
      const Vector solution = normal.ldlt().solve(right);
      Eigen::Index worst = -1;
      for (Eigen::Index i = 0; i < solution.size(); ++i)
        if (i % shape_.terms() >= shape_.knots && solution(i) < 0 && (worst < 0 || solution(i) < solution(worst)))
          worst = i;
      if (worst < 0) return solution;
      normal.row(worst).setZero();
      normal.col(worst).setZero();
      normal(worst, worst) = 1;
      right(worst) = 0;
    }
    return normal.ldlt().solve(right);
  }

  [[nodiscard]] double scale(const Sums& all) const {
    double sum = 0;
    for (Eigen::Index k = 0; k < shape_.knots; ++k) sum += all.terms(k, k);
    return sum / static_cast<double>(shape_.knots);
  }

 private:
  Shape shape_;
  Matrix chosen_, penalty_;
};

/// A law on trial: what it leaves of each fold that its fit had not seen.
struct Trial {
  double left = 0;
  std::vector<double> by_fold;
  TorqueLaw law;
};

Trial try_shape(const Shape& shape, const Placement& place, const std::vector<Sums>& by_fold, const Sums& all) {
  const ShapedFit fit(shape, place.size());
  const Sums whole = fit.reduced(all);
  const double scale = fit.scale(whole);
  Trial trial;
  for (const Sums& part : by_fold) {
    const Sums fold = fit.reduced(part);
    Sums rest = whole;
    rest -= fold;
    trial.by_fold.push_back(fold.left(fit.solve(rest, scale)));
    trial.left += trial.by_fold.back();
  }
  trial.law.laws = place;
  trial.law.knots = shape.knots;
  const Vector coefficients = fit.finest(fit.solve(whole, scale));
  for (std::size_t b = 0; b < place.size(); ++b)
    trial.law.laws[b].coefficients =
        coefficients.segment(static_cast<Eigen::Index>(b) * law_terms_count, law_terms_count);
  return trial;
}

double square_sum(const std::vector<double>& by_fold) {
  return std::accumulate(by_fold.begin(), by_fold.end(), 0.0);
}

}  // namespace

std::optional<TorqueLaw> fit_torque_law(const Study& seen, const NoiseModel& noise,
                                        const std::vector<Instance>& bases) {
  std::vector<Instance> all_bases{{}};
  all_bases.insert(all_bases.end(), bases.begin(), bases.end());
  const std::vector<Shape> all_shapes = shapes();
  std::optional<Trial> best;
  std::vector<double> nominal;
  for (const Instance& base : all_bases) {
    const Response rig = response(seen, base);
    if (!rig.base.reached) continue;
    const std::vector<double> residual = without_outliers(seen.measurements(), seen.residual(rig.base));
    for (const Placement& place : places(seen, rig)) {
      const std::vector<Sums> by_fold = sums_of(seen, rig, place, residual, noise);
      Sums all = by_fold.front();
      for (std::size_t f = 1; f < folds; ++f) all += by_fold[f];
      if (nominal.empty())
        for (const Sums& part : by_fold) nominal.push_back(part.residual);
      for (const Shape& shape : all_shapes) {
        if (2 * shape.terms() * static_cast<Eigen::Index>(place.size()) >
            static_cast<Eigen::Index>(std::max<std::size_t>(residual.size(), 8)))
          continue;
        Trial trial = try_shape(shape, place, by_fold, all);
        if (best && !(trial.left < best->left)) continue;
        best = std::move(trial);
        best->law.base = base;
      }
    }
  }
  if (!best) return std::nullopt;
  best->law.cross_validated = std::sqrt(best->left / square_sum(nominal));
  constexpr double worth = 0.9;
  if (!(best->law.cross_validated < worth)) return std::nullopt;
  return best->law;
}

Prediction predict_with_law(const Study& study, const TorqueLaw& law) {
  const Response rig = response(study, law.base);
  Prediction with = rig.base;
  if (!with.reached) return with;
  for (const JointTorqueLaw& one : law.laws)
    for_each_part(study, rig, one, [&](std::size_t a, std::size_t run, const Matrix& terms) {
      const Eigen::ArrayXd torque = (terms * one.coefficients).array();
      with.runs[run] += rig.per_torque[a][run].colwise() * torque;
    });
  return with;
}

}  // namespace plumbline::diagnose
