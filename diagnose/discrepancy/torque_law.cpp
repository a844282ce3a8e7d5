#include "diagnose/discrepancy/torque_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "diagnose/discrepancy/law_choice.hpp"
#include "diagnose/rig/run_rig.hpp"

namespace plumbline::diagnose {
namespace {

constexpr std::size_t folds = 5;

/// The values of a series.
auto values_of(const Series& series, const VectorXd& values) {
  return values.segment(static_cast<Eigen::Index>(series.first),
                        static_cast<Eigen::Index>(series.readings.size()));
}

/// A rig, what it gives, and how its channels answer to a torque at each elastic joint.
struct LawResponse {
  Rig rig;
  Prediction given;
  std::vector<std::size_t> joints;             ///< elastic, from 0
  std::vector<std::vector<Trace>> per_torque;  ///< [joint][run], by 1 N m
};

LawResponse response(const Study& study, Rig rig) {
  LawResponse all{std::move(rig), {}, {}, {}};
  std::vector<RigVariation> pushed;
  for (std::size_t j = 0; j < study.experiment().link_length.size(); ++j) {
    const double stiffness = study.experiment().joint_stiffness[j];
    if (!(stiffness > 0)) continue;
    all.joints.push_back(j);
    pushed.push_back({all.rig, variation_share * stiffness});
    pushed.back().rig.laws.push_back({j + 1, {{0, pushed.back().step}}});
  }
  all.given = simulate(study.experiment(), all.rig, pushed);
  all.per_torque = std::move(all.given.sensitivity);
  return all;
}

std::size_t place_of(const LawResponse& rig, std::size_t joint) {
  return static_cast<std::size_t>(std::find(rig.joints.begin(), rig.joints.end(), joint) -
                                  rig.joints.begin());
}

/// A joint's deflection along a run.
Eigen::VectorXd deflection(const Study& study, const Rig& rig, const Prediction& given, std::size_t run,
                           std::size_t joint) {
  const Run& own = study.experiment().runs[run];
  RunRig here(in_run(rig, own.number), own.rest);
  Eigen::VectorXd bent = given.runs[run].col(column_q + static_cast<Eigen::Index>(joint));
  for (Eigen::Index i = 0; i < bent.size(); ++i) {
    if (own.commands_joints()) here.turn_to(own.readings[static_cast<std::size_t>(i)].rest);
    bent(i) -= here.joint[joint].rest;
  }
  return bent;
}

LawSpan span_of(const Study& study, const LawResponse& rig, const std::vector<std::size_t>& joints) {
  LawSpan span;
  for (std::size_t r = 0; r < rig.given.runs.size(); ++r) {
    for (const std::size_t j : joints)
      for (const double d : deflection(study, rig.rig, rig.given, r, j))
        if (std::isfinite(d)) span.low = std::min(span.low, d), span.high = std::max(span.high, d);
    const Run& run = study.experiment().runs[r];
    if (!run.counts_readings())
      span.duration = std::max(span.duration, run.readings.back().t - run.readings.front().t);
  }
  return span;
}

/// Calls `add(place of the joint among the elastic ones, run, terms)` for each joint that has the law and
/// each run.
template <class Add>
void for_each_part(const Study& study, const LawResponse& rig, const JointTorqueLaw& law, Add add) {
  for (const std::size_t number : law.joints) {
    const std::size_t j = number - 1;
    const double share = study.experiment().joint_stiffness[j] / law.stiffness;
    for (std::size_t r = 0; r < study.experiment().runs.size(); ++r)
      add(place_of(rig, j), r,
          share *
              law_terms(law.span, study.experiment().runs[r], deflection(study, rig.rig, rig.given, r, j)));
  }
}

/// Where the law may be: laws without coefficients yet.
using Placement = std::vector<JointTorqueLaw>;

/// How many terms each law of a placement may have: where each joint has its own, none has a profile.
Eigen::Index terms_of(const Placement& place) {
  return place.size() > 1 ? plain_terms : law_terms_count;
}

JointTorqueLaw blank(const Study& study, const LawResponse& rig, const std::vector<std::size_t>& joints) {
  JointTorqueLaw law;
  law.span = span_of(study, rig, joints);
  for (const std::size_t j : joints) {
    law.joints.push_back(j + 1);
    law.stiffness += study.experiment().joint_stiffness[j] / static_cast<double>(joints.size());
  }
  return law;
}

/// One joint; all of them with one law, in proportion to their stiffness; each its own.
std::vector<Placement> placements(const Study& study, const LawResponse& rig) {
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

/// The two folds of a reading: ten blocks of neighbours in every run, two to a fold; the next run begins a
/// fold later in the first five folds and a fold earlier in the others, for which of its readings are left
/// out with which of this one's is chance. \param begins  the fold of the run's first block
std::array<std::size_t, 2> folds_of(std::size_t begins, std::size_t reading, std::size_t readings) {
  const std::size_t block = 10 * reading / readings;
  return {(block + begins) % folds, folds + (block + folds - begins % folds) % folds};
}

/// By run: in which fold it begins, each in another, so that what is left out of one is seen in the next. By
/// how much of the gap they carry, for the order in which they are listed says nothing.
std::vector<std::size_t> first_folds(const Study& study) {
  std::vector<double> carried(study.experiment().runs.size(), 0.0);
  const VectorXd residual = study.nominal_residual();
  for (const Series& series : study.measurements().series())
    carried[series.run] += values_of(series, residual).squaredNorm();
  std::vector<std::size_t> first;
  for (const double own : carried)
    first.push_back(static_cast<std::size_t>(
        std::count_if(carried.begin(), carried.end(), [&](double other) { return other > own; })));
  return first;
}

LawFolds sums_of(const Study& study, const LawResponse& rig, const Placement& place, const VectorXd& residual,
                 const NoiseEstimate& noise) {
  const Eigen::Index own = terms_of(place), width = static_cast<Eigen::Index>(place.size()) * own;
  const LawSums none{Eigen::MatrixXd::Zero(width, width), Eigen::VectorXd::Zero(width), 0};
  LawFolds result{std::vector<LawSums>(2 * folds, none), 2};
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(residual.size(), width);
  for (std::size_t b = 0; b < place.size(); ++b) {
    for_each_part(study, rig, place[b], [&](std::size_t a, std::size_t run, const Eigen::MatrixXd& terms) {
      for (const Series& series : study.measurements().series()) {
        if (series.run != run) continue;
        const auto answer = rig.per_torque[a][run].col(series.channel.column);
        for (std::size_t i = 0; i < series.readings.size(); ++i) {
          const auto reading = static_cast<Eigen::Index>(series.readings[i]),
                     row = static_cast<Eigen::Index>(series.first + i);
          slopes.row(row).segment(static_cast<Eigen::Index>(b) * own, own) +=
              answer(reading) / (study.measurements().sigma()(row) * noise.of(series.channel).scale) *
              terms.row(reading).head(own);
        }
      }
    });
  }
  const std::vector<std::size_t> first = first_folds(study);
  for (const Series& series : study.measurements().series()) {
    const std::size_t readings = study.experiment().runs[series.run].readings.size(),
                      begins = first[series.run];
    // Neighbours in one fold are one slab of rows.
    std::size_t from = 0;
    while (from < series.readings.size()) {
      const std::array<std::size_t, 2> both = folds_of(begins, series.readings[from], readings);
      std::size_t to = from;
      while (to < series.readings.size() && folds_of(begins, series.readings[to], readings) == both) ++to;
      const auto rows = slopes.middleRows(static_cast<Eigen::Index>(series.first + from),
                                          static_cast<Eigen::Index>(to - from));
      const Eigen::VectorXd part = residual.segment(static_cast<Eigen::Index>(series.first + from),
                                                    static_cast<Eigen::Index>(to - from)) /
                                   noise.of(series.channel).scale;
      const LawSums sums{rows.transpose() * rows, rows.transpose() * part, part.squaredNorm()};
      for (const std::size_t fold : both) result.parts[fold] += sums;
      from = to;
    }
  }
  return result;
}

/// What a law may leave of the rms and still be offered. The gain of a law that says nothing scatters by
/// about one over the root of the values, and it is the luckiest of many.
double worth_at_most(std::size_t values) {
  constexpr double usual = 0.9;
  return std::min(usual, std::sqrt(std::max(0.0, 1 - 2 / std::sqrt(static_cast<double>(values)))));
}

/// The base of a law with the law in it.
Rig rig_with_law(const Study& study, const TorqueLaw& law) {
  Rig rig = study.nominal_rig();
  for (FreeLaw& one : free_laws(study, law)) rig.laws.push_back(std::move(one));
  return rig;
}

/// The residual with nothing to explain at the outliers.
VectorXd without_outliers(const NoiseEstimate& noise, VectorXd residual) {
  for (Eigen::Index i = 0; i < residual.size(); ++i)
    if (noise.shape.outlier[static_cast<std::size_t>(i)]) residual(i) = 0;
  return residual;
}

/// Sum of squares of a residual, in the noise.
double squares(const Study& study, const NoiseEstimate& noise, const VectorXd& residual) {
  double sum = 0;
  for (const Series& series : study.measurements().series())
    sum += (values_of(series, residual) / noise.of(series.channel).scale).squaredNorm();
  return sum;
}

/// What laws of the places of `law` are to explain: what is left with it in the rig, and what it gives there.
VectorXd to_explain(const Study& study, const NoiseEstimate& noise, const LawResponse& with,
                    const TorqueLaw& law) {
  VectorXd residual = without_outliers(noise, study.residual(with.given));
  for (const JointTorqueLaw& one : law.laws)
    for_each_part(study, with, one, [&](std::size_t a, std::size_t run, const Eigen::MatrixXd& terms) {
      const Eigen::VectorXd torque = terms.leftCols(one.coefficients.size()) * one.coefficients;
      for (const Series& series : study.measurements().series()) {
        if (series.run != run) continue;
        const auto answer = with.per_torque[a][run].col(series.channel.column);
        for (std::size_t i = 0; i < series.readings.size(); ++i) {
          const auto reading = static_cast<Eigen::Index>(series.readings[i]),
                     row = static_cast<Eigen::Index>(series.first + i);
          residual(row) += answer(reading) * torque(reading) / study.measurements().sigma()(row);
        }
      }
    });
  return residual;
}

void take(const Eigen::VectorXd& coefficients, TorqueLaw& law) {
  const Eigen::Index own = terms_of(law.laws);
  for (std::size_t b = 0; b < law.laws.size(); ++b)
    law.laws[b].coefficients = coefficients.segment(static_cast<Eigen::Index>(b) * own, own);
}

/// The law on its way to another.
TorqueLaw between(const TorqueLaw& from, const TorqueLaw& to, double share) {
  TorqueLaw law = to;
  for (std::size_t b = 0; b < law.laws.size(); ++b)
    law.laws[b].coefficients = (1 - share) * from.laws[b].coefficients + share * to.laws[b].coefficients;
  return law;
}

/// A law that was fitted to how the base answers at the deflections that it has without the law, fitted again
/// to how the chain answers that has the law, at the deflections that it then has: Gauss and Newton's
/// iteration, by shorter steps where a whole one does not help.
TorqueLaw settled(const Study& seen, const NoiseEstimate& noise, TorqueLaw law) {
  constexpr int rounds = 6;
  constexpr double noticeable = 1e-2;
  double least = left_with(seen, noise, law);
  for (int halved = 0; !std::isfinite(least) && halved < 4; ++halved) {
    for (JointTorqueLaw& one : law.laws) one.coefficients /= 2;
    least = left_with(seen, noise, law);
  }
  for (int round = 0; round < rounds; ++round) {
    const LawResponse with = response(seen, rig_with_law(seen, law));
    if (!with.given.reached) break;
    TorqueLaw next = law;
    const ChosenLaw fitted = fit_law(
        law.shape, law.laws.size(), sums_of(seen, with, law.laws, to_explain(seen, noise, with, law), noise));
    take(fitted.coefficients, next);
    double left = std::numeric_limits<double>::infinity();
    for (const double share : {1.0, 0.5, 0.25, 0.1}) {
      const TorqueLaw trial = between(law, next, share);
      left = left_with(seen, noise, trial);
      if (!(left < least)) continue;
      law = trial;
      break;
    }
    if (!(left < (1 - noticeable) * least)) break;
    least = left;
  }
  return law;
}

/// A settled law, its shape chosen again by how the chain answers that has it: where the law is large, what
/// the base answers to it shows too little of what another shape would do. Laws of their own keep theirs.
TorqueLaw chosen_again(const Study& seen, const NoiseEstimate& noise, const TorqueLaw& law) {
  if (law.laws.size() > 1) return law;
  const LawResponse with = response(seen, rig_with_law(seen, law));
  if (!with.given.reached) return law;
  const LawFolds sums = sums_of(seen, with, law.laws, to_explain(seen, noise, with, law), noise);
  const ChosenLaw same = fit_law(law.shape, 1, sums), other = choose_law(sums, seen.measurements().size());
  if (!(other.left < same.left - noticed_gain)) return law;
  TorqueLaw next = law;
  next.shape = other.shape;
  next.cross_validated *= std::sqrt(other.left / same.left);
  take(other.coefficients, next);
  next = settled(seen, noise, std::move(next));
  return left_with(seen, noise, next) < left_with(seen, noise, law) ? next : law;
}

}  // namespace

double left_with(const Study& study, const NoiseEstimate& noise, const TorqueLaw& law) {
  const Prediction with = predict_with_law(study, law);
  if (!with.reached) return std::numeric_limits<double>::infinity();
  return squares(study, noise, without_outliers(noise, study.residual(with)));
}

std::optional<TorqueLaw> fit_torque_law(const Study& seen, const NoiseEstimate& noise) {
  const LawResponse rig = response(seen, seen.nominal_rig());
  if (!rig.given.reached) return std::nullopt;
  const VectorXd residual = without_outliers(noise, seen.residual(rig.given));
  const std::size_t values = seen.measurements().size();
  std::optional<TorqueLaw> best;
  LawShape shape;
  double left = std::numeric_limits<double>::infinity();
  for (const Placement& place : placements(seen, rig)) {
    const LawFolds sums = sums_of(seen, rig, place, residual, noise);
    // Laws of their own take the shape of the one law that all joints share, which was looked at just before.
    if (place.size() > 1) shape.profile = {};
    if (place.size() > 1 && !affordable(shape, place.size(), values)) continue;
    const ChosenLaw chosen = place.size() > 1 ? fit_law(shape, place.size(), sums) : choose_law(sums, values);
    shape = chosen.shape;
    // One joint alone is the least that can be said.
    constexpr double clearly = 0.8;
    const bool simple = place.size() == 1 && place.front().joints.size() == 1;
    if (best && !(chosen.left < (simple ? 1 : clearly) * left)) continue;
    left = chosen.left;
    best = TorqueLaw{place, chosen.shape, 1};
    take(chosen.coefficients, *best);
  }
  if (!best) return std::nullopt;
  const double nominal = squares(seen, noise, without_outliers(noise, seen.nominal_residual()));
  best->cross_validated = std::sqrt(left / nominal);
  if (!(best->cross_validated < worth_at_most(seen.measurements().size()))) return std::nullopt;
  return refitted(seen, noise, *best);
}

TorqueLaw refitted(const Study& study, const NoiseEstimate& noise, const TorqueLaw& law) {
  return chosen_again(study, noise, settled(study, noise, law));
}

std::vector<FreeLaw> free_laws(const Study& study, const TorqueLaw& law) {
  std::vector<FreeLaw> all;
  for (const JointTorqueLaw& one : law.laws)
    for (const std::size_t joint : one.joints)
      all.push_back(free_law(one.span, law.shape.knots, one.coefficients, joint,
                             study.experiment().joint_stiffness[joint - 1] / one.stiffness));
  return all;
}

Prediction predict_with_law(const Study& study, const TorqueLaw& law) {
  return simulate(study.experiment(), rig_with_law(study, law), {});
}

std::vector<LawTrace> law_traces(const Study& study, const TorqueLaw& law) {
  const LawResponse with = response(study, rig_with_law(study, law));
  const Rig& nominal = study.nominal_rig();
  std::vector<LawTrace> traces;
  for (const JointTorqueLaw& one : law.laws)
    for_each_part(study, with, one, [&](std::size_t a, std::size_t run, const Eigen::MatrixXd& terms) {
      const std::size_t joint = with.joints[a];
      const Run& own = study.experiment().runs[run];
      const JointLaw spring = RunRig(in_run(nominal, own.number), own.rest).joint[joint];
      const Eigen::VectorXd bent = deflection(study, nominal, with.given, run, joint);
      const Eigen::VectorXd carried =
          bent.unaryExpr([&](double d) { return spring.elastic(spring.rest + d).value; });
      traces.push_back(
          {joint + 1, run, bent, carried + terms.leftCols(one.coefficients.size()) * one.coefficients});
    });
  return traces;
}

bool covers(const Study& study, const TorqueLaw& law, const std::vector<std::vector<bool>>& heldout) {
  constexpr double margin = 0.1, most = 0.9;
  const Rig& nominal = study.nominal_rig();
  const Prediction& given = study.nominal();
  double inside = 0, all = 0;
  for (const JointTorqueLaw& one : law.laws)
    for (const std::size_t joint : one.joints)
      for (std::size_t r = 0; r < heldout.size(); ++r) {
        const Eigen::VectorXd bent = deflection(study, nominal, given, r, joint - 1);
        for (std::size_t i = 0; i < heldout[r].size(); ++i) {
          const double d = bent(static_cast<Eigen::Index>(i)), slack = margin * one.span.stroke();
          if (!heldout[r][i] || !std::isfinite(d)) continue;
          all += 1;
          inside += d >= one.span.low - slack && d <= one.span.high + slack ? 1 : 0;
        }
      }
  return inside >= most * all;
}

}  // namespace plumbline::diagnose
