#include "diagnose/answers/torque_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/answers/law_choice.hpp"
#include "diagnose/model/run_rig.hpp"

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

/// The fold of a reading: ten blocks of neighbours in every run, two to a fold.
std::size_t fold_of(std::size_t run, std::size_t reading, std::size_t readings) {
  return (10 * reading / readings + run) % folds;
}

std::vector<LawSums> sums_of(const Study& study, const Response& rig, const Placement& place,
                             const std::vector<double>& residual, const NoiseModel& noise) {
  const auto width = static_cast<Eigen::Index>(place.size()) * law_terms_count;
  const LawSums none{Matrix::Zero(width, width), Vector::Zero(width), 0};
  std::vector<LawSums> by_fold(folds, none);
  Matrix slopes = Matrix::Zero(static_cast<Eigen::Index>(residual.size()), width);
  for (std::size_t b = 0; b < place.size(); ++b) {
    for_each_part(study, rig, place[b], [&](std::size_t a, std::size_t run, const Matrix& terms) {
      for (const Series& series : study.measurements().series()) {
        if (series.run != run) continue;
        const double unit = 1 / (series.sigma * noise.of(series.channel));
        const auto answer = rig.per_torque[a][run].col(column_of(series.channel));
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
  std::optional<TorqueLaw> best;
  double nominal = 0, left = 0, alone = std::numeric_limits<double>::infinity();
  for (const Instance& base : all_bases) {
    const Response rig = response(seen, base);
    if (!rig.base.reached) continue;
    const std::vector<double> residual = without_outliers(seen.measurements(), seen.residual(rig.base));
    LawShape shape;
    for (const Placement& place : placements(seen, rig)) {
      const std::vector<LawSums> by_fold = sums_of(seen, rig, place, residual, noise);
      double before = 0;
      for (const LawSums& part : by_fold) before += part.residual;
      if (nominal == 0) nominal = before;
      alone = std::min(alone, before);
      // Laws of their own take the shape of the one law that all joints share, which was looked at just
      // before.
      if (place.size() > 1 && !affordable(shape, place.size(), residual.size())) continue;
      const ChosenLaw chosen =
          place.size() > 1 ? fit_law(shape, place.size(), by_fold) : choose_law(by_fold, residual.size());
      shape = chosen.shape;
      // One joint alone, on the nominal model, is the least that can be said.
      constexpr double clearly = 0.8;
      const bool simple =
          base.candidate.effects.empty() && place.size() == 1 && place.front().joints.size() == 1;
      if (best && !(chosen.left < (simple ? 1 : clearly) * left)) continue;
      left = chosen.left;
      best = TorqueLaw{base, place, chosen.shape.knots, 1, 1};
      for (std::size_t b = 0; b < place.size(); ++b)
        best->laws[b].coefficients =
            chosen.coefficients.segment(static_cast<Eigen::Index>(b) * law_terms_count, law_terms_count);
    }
  }
  if (!best) return std::nullopt;
  best->cross_validated = std::sqrt(left / nominal);
  best->without_law = std::sqrt(alone / nominal);
  const double worth = worth_at_most(seen.measurements().size()) * best->without_law;
  return best->cross_validated < worth ? best : std::nullopt;
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
  const Rig base = rig_with(study, law.base.candidate, law.base.parameters);
  std::vector<LawTrace> traces;
  for (const JointTorqueLaw& one : law.laws)
    for_each_part(study, rig, one, [&](std::size_t a, std::size_t run, const Matrix& terms) {
      const std::size_t joint = rig.joints[a];
      const Run& own = study.experiment().runs[run];
      const RunRig joints(in_run(base, own.number), own.rest);
      const Vector bent = deflection(study, with, run, joint);
      const Vector spring =
          bent.unaryExpr([&](double d) { return joints.joint[joint].elastic(own.rest[joint] + d).value; });
      traces.push_back({joint + 1, run, bent, spring + terms * one.coefficients});
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
