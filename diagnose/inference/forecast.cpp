#include "diagnose/inference/forecast.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "diagnose/inference/start.hpp"

namespace plumbline::diagnose {
namespace {

/// Parameters of an effect at nothing of it, and the parameters in which it then grows: each by a small step,
/// or all together by a finite one.
struct Probe {
  EffectAt effect;
  std::vector<double> at;
  std::vector<std::size_t> growing;
  std::vector<double> to;  ///< where the finite step leads; empty: small steps
  [[nodiscard]] bool is_small() const { return to.empty(); }
};

std::vector<Probe> probes(const Study& study, const EffectAt& at) {
  const Perturbation& how = at.effect->perturbation;
  const InitialGuesses known = initial_guesses(study, at);
  const std::size_t count = known.points.front().size();
  std::vector<std::size_t> growing = how.growing;
  if (growing.empty()) {
    growing.resize(count);
    std::iota(growing.begin(), growing.end(), std::size_t{0});
  }
  const bool alike = !how.large_step && how.growing.empty();  // nothing of the guess is left
  std::vector<Probe> result;
  for (std::size_t s = 0; s < std::min(alike ? 1 : how.guesses, known.points.size()); ++s) {
    std::vector<double> from = known.points[s];
    const std::vector<double> to = how.large_step ? from : std::vector<double>();
    for (const std::size_t p : growing) from[p] = 0;
    const bool again = std::any_of(result.begin(), result.end(),
                                   [&](const Probe& one) { return one.at == from && one.to == to; });
    if (!again) result.push_back({at, from, growing, to});
  }
  return result;
}

/// What the hypothesis leaves, and what its own parameters can follow; beneath the values a row for each of
/// its parameters that has a Gaussian prior.
class Remainder {
 public:
  Remainder(const Study& study, const VectorXd& weight, const Hypothesis& h) : weight_(weight) {
    const std::vector<ParameterRange> ranges = study.ranges(h.candidate);
    const VectorXd values = weight.cwiseProduct(h.residual);
    const auto count = static_cast<Eigen::Index>(ranges.size());
    Eigen::Index held = 0;
    for (const ParameterRange& range : ranges) held += range.tolerance > 0;
    residual_ = VectorXd::Zero(values.size() + held);
    residual_.head(values.size()) = values;
    MatrixXd own = MatrixXd::Zero(residual_.size(), count);
    if (count > 0) own.topRows(values.size()) = weight.asDiagonal() * h.jacobian;
    Eigen::Index row = values.size();
    for (Eigen::Index p = 0; p < count; ++p) {
      const double tolerance = ranges[static_cast<std::size_t>(p)].tolerance;
      if (!(tolerance > 0)) continue;
      residual_(row) = h.parameters[static_cast<std::size_t>(p)] / tolerance;
      own(row++, p) = 1 / tolerance;
    }
    scale_ = own.colwise().norm().transpose().cwiseMax(1e-300);
    if (count > 0) {
      own = own * scale_.cwiseInverse().asDiagonal();
      own_.compute(own);
      basis_ = own_.householderQ() * MatrixXd::Identity(own.rows(), own_.rank());
    }
    residual_ = beyond_own(residual_);
  }

  [[nodiscard]] const VectorXd& residual() const { return residual_; }
  /// Derivative of the residual, from the change of the prediction.
  [[nodiscard]] VectorXd column(const VectorXd& change) const {
    VectorXd result = VectorXd::Zero(residual_.size());
    result.head(change.size()) = -weight_.cwiseProduct(change);
    return result;
  }
  [[nodiscard]] VectorXd beyond_own(const VectorXd& change) const {
    return basis_.cols() == 0 ? change : VectorXd(change - basis_ * (basis_.transpose() * change));
  }
  /// By how much the own parameters move, to make up for a change of the residual.
  [[nodiscard]] VectorXd made_up(const VectorXd& change) const {
    if (basis_.cols() == 0) return VectorXd::Zero(scale_.size());
    return -VectorXd(own_.solve(change)).cwiseQuotient(scale_);
  }

 private:
  const VectorXd& weight_;
  VectorXd residual_, scale_;
  Eigen::ColPivHouseholderQR<MatrixXd> own_;
  MatrixXd basis_;
};

/// Best step within bounds along the columns. \returns what is left of the sum of squares
double best_step(const VectorXd& residual, const std::vector<VectorXd>& columns,
                 const std::vector<ParameterRange>& ranges, const Probe& probe, std::vector<double>& start) {
  start = probe.at;
  VectorXd left = residual;
  double charge = 0;
  for (int sweep = 0; sweep < (columns.size() > 1 ? 20 : 1); ++sweep)
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const std::size_t p = probe.growing[c];
      const double square = columns[c].squaredNorm();
      if (!(square * ranges[p].scale * ranges[p].scale > 1e-6)) continue;  // not excited
      const double prior = ranges[p].tolerance > 0 ? std::pow(ranges[p].tolerance, -2) : 0;
      const double wanted = (start[p] * square - columns[c].dot(left)) / (square + prior);
      const double step = std::clamp(wanted, ranges[p].low, ranges[p].high) - start[p];
      start[p] += step;
      left += step * columns[c];
    }
  for (const std::size_t p : probe.growing)
    if (ranges[p].tolerance > 0) charge += std::pow(start[p] / ranges[p].tolerance, 2);
  return left.squaredNorm() + charge;
}

/// The same for the finite step of a probe, of which any share within bounds may be taken.
double best_share(const VectorXd& residual, const VectorXd& column, const std::vector<ParameterRange>& ranges,
                  const Probe& probe, std::vector<double>& start) {
  start = probe.at;
  double prior = 0, most = std::numeric_limits<double>::infinity();
  for (const std::size_t p : probe.growing) {
    const double way = probe.to[p] - probe.at[p];
    if (ranges[p].tolerance > 0) prior += std::pow(way / ranges[p].tolerance, 2);
    if (way > 0) most = std::min(most, (ranges[p].high - probe.at[p]) / way);
  }
  const double square = column.squaredNorm();
  if (!(square > 1e-6)) return residual.squaredNorm();
  const double share = std::clamp(-column.dot(residual) / (square + prior), 0.0, most);
  for (const std::size_t p : probe.growing)
    start[p] = std::max(ranges[p].low, start[p] + share * (probe.to[p] - probe.at[p]));
  return (residual + share * column).squaredNorm() + prior * share * share;
}

std::vector<double> joined(std::vector<double> first, const std::vector<double>& last) {
  first.insert(first.end(), last.begin(), last.end());
  return first;
}

/// The own parameters within their bounds, moved.
std::vector<double> moved(const std::vector<ParameterRange>& ranges, const Hypothesis& h,
                          const VectorXd& by) {
  std::vector<double> parameters = h.parameters;
  for (std::size_t p = 0; p < ranges.size(); ++p)
    parameters[p] =
        std::clamp(parameters[p] + by(static_cast<Eigen::Index>(p)), ranges[p].low, ranges[p].high);
  return parameters;
}

/// What a probe changes of the residual when it goes from nothing to `start`.
VectorXd change_of(const Probe& probe, const std::vector<VectorXd>& columns,
                   const std::vector<double>& start) {
  VectorXd change = VectorXd::Zero(columns.front().size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const std::size_t p = probe.growing[c];
    const double way = probe.is_small() ? 1 : probe.to[p] - probe.at[p];
    if (way != 0) change += (start[p] - probe.at[p]) / way * columns[c];
  }
  return change;
}

Prospect prospect_of(const Study& study, const Remainder& remainder, const Hypothesis& h, const Probe& probe,
                     const std::vector<VectorXd>& columns) {
  const std::vector<ParameterRange> ranges = study.ranges(probe.effect), own = study.ranges(h.candidate);
  std::vector<VectorXd> beyond;
  for (const VectorXd& column : columns) beyond.push_back(remainder.beyond_own(column));
  std::vector<double> start;
  const bool small = probe.is_small();
  const double cost = columns.empty() ? remainder.residual().squaredNorm()
                      : small         ? best_step(remainder.residual(), beyond, ranges, probe, start)
                              : best_share(remainder.residual(), beyond.front(), ranges, probe, start);
  if (columns.empty()) start = probe.at;
  Prospect prospect{probe.effect, {{joined(h.parameters, start)}, 1}, cost};
  if (small) prospect.starts.points.push_back(joined(h.parameters, probe.at));
  // A part of a finite step may be nothing at all: no reading reaches where a cell saturates farther up.
  std::vector<std::vector<double>> ends{start};
  if (!small) ends.push_back(probe.to);
  for (std::size_t e = 0; e < ends.size() && !columns.empty(); ++e)
    prospect.starts.points.push_back(
        joined(moved(own, h, remainder.made_up(change_of(probe, columns, ends[e]))), ends[e]));
  return prospect;
}

}  // namespace

std::vector<Prospect> forecast(const Study& study, const VectorXd& weight,
                               const std::vector<EffectAt>& possible, const Hypothesis& h) {
  std::vector<Probe> all;
  for (const EffectAt& at : possible)
    if (!h.candidate.has(at))
      for (Probe& probe : probes(study, at)) all.push_back(std::move(probe));
  const auto rig = [&](const Probe& probe, const std::vector<double>& values) {
    Candidate candidate = h.candidate;
    candidate.effects.push_back(probe.effect);
    return rig_with(study, candidate, joined(h.parameters, values));
  };
  std::vector<RigVariation> beside;
  std::vector<std::size_t> first;
  for (const Probe& probe : all) {
    first.push_back(beside.size());
    if (!probe.is_small()) continue;
    const std::vector<ParameterRange> ranges = study.ranges(probe.effect);
    for (const std::size_t p : probe.growing) {
      std::vector<double> values = probe.at;
      const double step = variation_share * ranges[p].scale;
      values[p] += step;
      beside.push_back({rig(probe, values), step});
    }
  }
  const Prediction here = simulate(study.experiment(), rig_with(study, h.candidate, h.parameters), beside);
  const Remainder remainder(study, weight, h);
  std::vector<Prospect> prospects;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Probe& probe = all[i];
    std::vector<VectorXd> columns;
    if (probe.is_small()) {
      for (std::size_t c = 0; c < probe.growing.size(); ++c)
        columns.push_back(remainder.column(study.in_sigmas(here.sensitivity[first[i] + c])));
    } else {
      Prediction far = simulate(study.experiment(), rig(probe, probe.to), {});
      for (std::size_t r = 0; far.reached && r < far.runs.size(); ++r) far.runs[r] -= here.runs[r];
      if (far.reached) columns.push_back(remainder.column(study.in_sigmas(far.runs)));
    }
    std::erase_if(columns, [](const VectorXd& c) { return !c.allFinite(); });
    if (probe.is_small() && columns.size() < probe.growing.size()) columns.clear();
    Prospect prospect = prospect_of(study, remainder, h, probe, columns);
    if (prospects.empty() || !(prospects.back().effect == prospect.effect)) {
      prospects.push_back(std::move(prospect));
    } else if (prospect.cost < prospects.back().cost) {
      prospects.back() = std::move(prospect);
    }
  }
  std::sort(prospects.begin(), prospects.end(),
            [](const Prospect& a, const Prospect& b) { return a.cost < b.cost; });
  return prospects;
}

}  // namespace plumbline::diagnose
