#include "diagnose/answers/torque_law.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::diagnose {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr std::size_t folds = 5;

/// The base model and how its channels answer to a torque at each elastic joint.
struct Response {
  Prediction base;
  std::vector<std::size_t> joints;             ///< elastic, from 0
  std::vector<std::vector<Trace>> per_torque;  ///< [joint][run], by 1 N m
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
  all.base =
      base.candidate.effects.empty() ? study.nominal() : predict(study, base.candidate, base.parameters);
  return all;
}

std::size_t place_of(const Response& rig, std::size_t joint) {
  return static_cast<std::size_t>(std::find(rig.joints.begin(), rig.joints.end(), joint) -
                                  rig.joints.begin());
}

/// A joint's deflection in a run as the base model has it.
Vector deflection(const Study& study, const Prediction& base, std::size_t run, std::size_t joint) {
  const auto column = base.runs[run].col(column_q + static_cast<Eigen::Index>(joint));
  return column.matrix().array() - study.experiment().runs[run].rest[joint];
}

LawSpan span_of(const Study& study, const Prediction& base, const std::vector<std::size_t>& joints) {
  LawSpan span;
  for (std::size_t r = 0; r < base.runs.size(); ++r) {
    for (const std::size_t j : joints)
      for (const double d : deflection(study, base, r, j))
        if (std::isfinite(d)) span.low = std::min(span.low, d), span.high = std::max(span.high, d);
    const std::vector<Reading>& readings = study.experiment().runs[r].readings;
    span.duration = std::max(span.duration, readings.back().t - readings.front().t);
  }
  return span;
}

/// Calls `add(place of the joint among the elastic ones, run, terms)` for each joint that has the law and
/// each run.
template <class Add>
void for_each_part(const Study& study, const Response& rig, const JointTorqueLaw& law, Add add) {
  for (const std::size_t number : law.joints) {
    const std::size_t j = number - 1;
    const double share = study.experiment().joint_stiffness[j] / law.stiffness;
    for (std::size_t r = 0; r < study.experiment().runs.size(); ++r)
      add(place_of(rig, j), r,
          share * law_terms(law.span, study.experiment().runs[r], deflection(study, rig.base, r, j)));
  }
}

/// Where the law may be: laws without coefficients yet.
using Placement = std::vector<JointTorqueLaw>;

JointTorqueLaw blank(const Study& study, const Response& rig, const std::vector<std::size_t>& joints) {
  JointTorqueLaw law;
  law.span = span_of(study, rig.base, joints);
  double readings = 0;
  for (const std::size_t j : joints) {
    law.joints.push_back(j + 1);
    law.stiffness += study.experiment().joint_stiffness[j] / static_cast<double>(joints.size());
    for (const Trace& trace : rig.per_torque[place_of(rig, j)])
      for (const double turn : trace.col(column_q + static_cast<Eigen::Index>(j)))
        if (std::isfinite(turn)) law.yield += turn, readings += 1;
  }
  law.yield /= std::max(1.0, readings);
  return law;
}

/// One joint; all of them with one law, in proportion to their stiffness; each its own.
std::vector<Placement> placements(const Study& study, const Response& rig) {
  constexpr std::size_t most_own = 6;
  std::vector<Placement> all;
  for (const std::size_t j : rig.joints)
    if (JointTorqueLaw law = blank(study, rig, {j}); law.span.stroke() > 0) all.push_back({std::move(law)});
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

/// Which terms a law may use.
struct Shape {
  Eigen::Index knots;
  std::vector<Eigen::Index> sliders, arms;

  [[nodiscard]] Eigen::Index terms() const {
    return knots + static_cast<Eigen::Index>(sliders.size() + arms.size());
  }
};

/// What is held against curvature, over the squares of a knot's term.
constexpr double smoothnesses[] = {1e-6, 1e-4, 1e-2, 1.0};

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

std::vector<Shape> neighbours(const Shape& shape) {
  static const Choices sliders = slider_choices(), arms{{}, {0}, {1}, {2}, {0, 1, 2}};
  std::vector<Shape> all;
  for (const Eigen::Index knots : {3, 5, 9, 17, 33}) all.push_back({knots, shape.sliders, shape.arms});
  for (const auto& chosen : sliders) all.push_back({shape.knots, chosen, shape.arms});
  for (const auto& chosen : arms) all.push_back({shape.knots, shape.sliders, chosen});
  return all;
}

/// The finest terms as combinations of a shape's, for one law.
Matrix selection(const Shape& shape) {
  Matrix chosen = Matrix::Zero(law_terms_count, shape.terms());
  const double stride = static_cast<double>(finest_knots - 1) / static_cast<double>(shape.knots - 1);
  for (Eigen::Index fine = 0; fine < finest_knots; ++fine)
    for (Eigen::Index k = 0; k < shape.knots; ++k)
      chosen(fine, k) =
          std::max(0.0, 1 - std::abs(static_cast<double>(fine) / stride - static_cast<double>(k)));
  Eigen::Index column = shape.knots;
  for (const Eigen::Index m : shape.sliders) chosen(finest_knots + m, column++) = 1;
  for (const Eigen::Index m : shape.arms) chosen(finest_knots + slider_terms + m, column++) = 1;
  return chosen;
}

/// What is held against a law: curvature, and an even part that is no constant, so that a side that was never
/// bent answers as the other; sliders and arms of any size a little.
Matrix penalty(const Shape& shape, double smoothness) {
  constexpr double evenness = 1e-3, size = 1e-6;
  Matrix weight = size * Matrix::Identity(shape.terms(), shape.terms());
  for (Eigen::Index k = 1; k + 1 < shape.knots; ++k) {
    Vector bend = Vector::Zero(shape.terms());
    bend(k - 1) = bend(k + 1) = 1;
    bend(k) = -2;
    weight += smoothness * bend * bend.transpose();
  }
  const Eigen::Index middle = shape.knots / 2;
  for (Eigen::Index k = 1; k <= middle; ++k) {
    Vector even = Vector::Zero(shape.terms());
    even(middle + k) = even(middle - k) = 1;
    even(middle) = -2;
    weight += evenness * even * even.transpose();
  }
  for (Eigen::Index m = shape.knots; m < shape.terms(); ++m) weight(m, m) += 0.1 * smoothness;
  return weight;
}

/// The same for each of several laws, along the diagonal.
Matrix repeated(const Matrix& one, std::size_t laws) {
  const auto count = static_cast<Eigen::Index>(laws);
  Matrix all = Matrix::Zero(count * one.rows(), count * one.cols());
  for (Eigen::Index b = 0; b < count; ++b)
    all.block(b * one.rows(), b * one.cols(), one.rows(), one.cols()) = one;
  return all;
}

Sums reduced(const Matrix& chosen, const Sums& full) {
  return {chosen.transpose() * full.terms * chosen, chosen.transpose() * full.with_residual, full.residual};
}

/// Least squares in the coefficients of a shape; sliders and arms dissipate, so none is negative.
Vector solve(const Shape& shape, const Sums& sums, const Matrix& held_against) {
  Matrix normal = sums.terms + held_against;
  Vector right = sums.with_residual;
  while (true) {
    const Vector solution = normal.ldlt().solve(right);
    Eigen::Index worst = -1;
    for (Eigen::Index i = 0; i < solution.size(); ++i)
      if (i % shape.terms() >= shape.knots && solution(i) < 0 && (worst < 0 || solution(i) < solution(worst)))
        worst = i;
    if (worst < 0) return solution;
    normal.row(worst).setZero();
    normal.col(worst).setZero();
    normal(worst, worst) = 1;
    right(worst) = 0;
  }
}

/// The mean square of a knot's term.
double knot_scale(const Shape& shape, const Sums& all) {
  return all.terms.diagonal().head(shape.knots).mean();
}

/// A law on trial: what it leaves of each fold that its fit had not seen.
struct Trial {
  double left = 0;
  TorqueLaw law;
};

/// The best of a shape, over how smooth it is.
Trial try_shape(const Shape& shape, const Placement& place, const std::vector<Sums>& by_fold,
                const Sums& all) {
  const Matrix chosen = repeated(selection(shape), place.size());
  const Sums whole = reduced(chosen, all);
  std::vector<Sums> parts;
  for (const Sums& part : by_fold) parts.push_back(reduced(chosen, part));
  Trial best;
  for (const double smoothness : smoothnesses) {
    const Matrix held_against = knot_scale(shape, whole) * repeated(penalty(shape, smoothness), place.size());
    double left = 0;
    for (const Sums& part : parts) {
      Sums rest = whole;
      rest -= part;
      left += part.left(solve(shape, rest, held_against));
    }
    if (!best.law.laws.empty() && !(left < best.left)) continue;
    best.left = left;
    best.law.laws = place;
    best.law.knots = shape.knots;
    const Vector coefficients = chosen * solve(shape, whole, held_against);
    for (std::size_t b = 0; b < place.size(); ++b)
      best.law.laws[b].coefficients =
          coefficients.segment(static_cast<Eigen::Index>(b) * law_terms_count, law_terms_count);
  }
  return best;
}

/// Fewer than two values a term tell nothing.
bool affordable(const Shape& shape, const Placement& place, std::size_t values) {
  return 2 * static_cast<std::size_t>(shape.terms()) * place.size() <= std::max<std::size_t>(values, 8);
}

/// The best law at a place: from a straight one, changed in one part at a time while that helps.
Trial best_at(const Placement& place, const std::vector<Sums>& by_fold, const Sums& all, std::size_t values) {
  constexpr int rounds = 6;
  Shape shape{3, {}, {}};
  Trial best = try_shape(shape, place, by_fold, all);
  for (int round = 0; round < rounds; ++round) {
    const double before = best.left;
    for (const Shape& other : neighbours(shape)) {
      if (!affordable(other, place, values)) continue;
      Trial trial = try_shape(other, place, by_fold, all);
      if (!(trial.left < best.left)) continue;
      best = std::move(trial);
      shape = other;
    }
    if (!(best.left < before)) break;
  }
  return best;
}

/// What a law may leave of the rms and still be offered. The gain of a law that says nothing scatters by
/// about one over the root of the values, and it is the luckiest of many.
double worth_at_most(std::size_t values) {
  constexpr double usual = 0.9;
  return std::min(usual, std::sqrt(std::max(0.0, 1 - 2 / std::sqrt(static_cast<double>(values)))));
}

}  // namespace

std::optional<TorqueLaw> fit_torque_law(const Study& seen, const NoiseModel& noise,
                                        const std::vector<Instance>& bases) {
  std::vector<Instance> all_bases{{}};
  all_bases.insert(all_bases.end(), bases.begin(), bases.end());
  std::optional<Trial> best;
  double nominal = 0, alone = std::numeric_limits<double>::infinity();
  for (const Instance& base : all_bases) {
    const Response rig = response(seen, base);
    if (!rig.base.reached) continue;
    const std::vector<double> residual = without_outliers(seen.measurements(), seen.residual(rig.base));
    for (const Placement& place : placements(seen, rig)) {
      const std::vector<Sums> by_fold = sums_of(seen, rig, place, residual, noise);
      Sums all = by_fold.front();
      for (std::size_t f = 1; f < folds; ++f) all += by_fold[f];
      if (nominal == 0) nominal = all.residual;
      alone = std::min(alone, all.residual);
      Trial trial = best_at(place, by_fold, all, residual.size());
      if (best && !(trial.left < best->left)) continue;
      best = std::move(trial);
      best->law.base = base;
    }
  }
  if (!best) return std::nullopt;
  best->law.cross_validated = std::sqrt(best->left / nominal);
  best->law.without_law = std::sqrt(alone / nominal);
  if (!(best->law.cross_validated < worth_at_most(seen.measurements().size()) * best->law.without_law))
    return std::nullopt;
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

std::vector<LawTrace> law_traces(const Study& study, const TorqueLaw& law) {
  const Response rig = response(study, law.base);
  const Prediction with = predict_with_law(study, law);
  std::vector<LawTrace> traces;
  for (const JointTorqueLaw& one : law.laws)
    for_each_part(study, rig, one, [&](std::size_t a, std::size_t run, const Matrix& terms) {
      const std::size_t joint = rig.joints[a];
      const Vector bent = deflection(study, with, run, joint);
      traces.push_back({joint + 1, run, bent,
                        study.experiment().joint_stiffness[joint] * bent + terms * one.coefficients});
    });
  return traces;
}

bool covers(const Study& study, const TorqueLaw& law, const HeldOut& heldout) {
  constexpr double margin = 0.1, most = 0.9;
  const Response rig = response(study, law.base);
  double inside = 0, all = 0;
  for (const JointTorqueLaw& one : law.laws)
    for (const std::size_t joint : one.joints)
      for (std::size_t r = 0; r < heldout.reading.size(); ++r) {
        const Vector bent = deflection(study, rig.base, r, joint - 1);
        for (std::size_t i = 0; i < heldout.reading[r].size(); ++i) {
          const double d = bent(static_cast<Eigen::Index>(i)), slack = margin * one.span.stroke();
          if (!heldout.reading[r][i] || !std::isfinite(d)) continue;
          all += 1;
          inside += d >= one.span.low - slack && d <= one.span.high + slack ? 1 : 0;
        }
      }
  return inside >= most * all;
}

}  // namespace plumbline::diagnose
