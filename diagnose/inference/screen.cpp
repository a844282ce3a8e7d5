#include "diagnose/inference/screen.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "diagnose/inference/least_squares.hpp"
#include "diagnose/inference/start.hpp"

namespace plumbline::diagnose {
namespace {

/// Parameters of an effect at nothing of it, and the parameters in which it then grows: each by a small step,
/// or all together by one as large as the effect may be where little of it acts otherwise than much (which
/// joints stick or hang in their play at a reversal).
struct Probe {
  EffectAt effect;
  std::vector<double> at;
  std::vector<std::size_t> growing;
  std::vector<double> to;  ///< where the large step leads; empty: small ones
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
  const bool alike = !how.large_step && how.growing.empty();  // nothing of the start is left
  std::vector<Probe> result;
  for (std::size_t s = 0; s < std::min(alike ? 1 : how.guesses, known.points.size()); ++s) {
    std::vector<double> from = known.points[s];
    const std::vector<double> to = how.large_step ? from : std::vector<double>();
    for (const std::size_t p : growing) from[p] = 0;
    result.push_back({at, from, growing, to});
  }
  return result;
}

bool rides_along(const Probe& probe) {
  return probe.to.empty();
}

/// Whitened derivatives of the prediction, with the rows of outliers weighing no more than at the bound,
/// and beneath them a row for each of the fit's own parameters that a tolerance holds: what a newcomer takes
/// off these counts for it.
class Weighing {
 public:
  Weighing(const Study& study, const Fit& fitted, const FitSettings& settings)
      : measurements_(study.measurements()), settings_(settings) {
    const std::vector<ParameterRange> ranges = study.ranges(fitted.candidate);
    const auto is_held = [](const ParameterRange& range) { return range.tolerance > 0; };
    const auto values = static_cast<Eigen::Index>(measurements_.size());
    const Eigen::Index held = std::count_if(ranges.begin(), ranges.end(), is_held);
    residual_.setZero(values + held);
    Eigen::MatrixXd own = Eigen::MatrixXd::Zero(values + held, fitted.jacobian.cols());
    own.topRows(values) = fitted.jacobian;
    // Beside a large gap nothing is an outlier that is not far out of the gap too.
    const double size =
        std::sqrt(fitted.cost / static_cast<double>(std::max<std::size_t>(1, measurements_.size())));
    const double bound = settings.outlier_bound * std::max(1.0, 3 * size);
    for (std::size_t i = 0; i < measurements_.size(); ++i) {
      const double z = fitted.whitened[i];
      const auto row = static_cast<Eigen::Index>(i);
      // Huber's weight: an outlier pulls as hard as one at the bound, and no harder.
      weight_.push_back(std::min(1.0, std::sqrt(bound / std::abs(z))));
      residual_(row) = weight_.back() * z;
      own.row(row) *= weight_.back();
    }
    Eigen::Index row = values;
    for (std::size_t p = 0; p < ranges.size(); ++p) {
      if (!(ranges[p].tolerance > 0)) continue;
      residual_(row) = fitted.parameters[p] / ranges[p].tolerance;
      own(row++, static_cast<Eigen::Index>(p)) = 1 / ranges[p].tolerance;
    }
    own_ = LeastSquares(own);
    basis_ = own_.orthonormal();
    residual_ = beyond_own(residual_);
  }

  [[nodiscard]] const Eigen::VectorXd& residual() const { return residual_; }

  [[nodiscard]] Eigen::VectorXd column(const std::vector<Trace>& sensitivity) const {
    const std::vector<double> white =
        whiten(measurements_, measurements_.in_sigmas(sensitivity), settings_.noise);
    Eigen::VectorXd result = Eigen::VectorXd::Zero(residual_.size());
    for (std::size_t i = 0; i < white.size(); ++i)
      result(static_cast<Eigen::Index>(i)) = weight_[i] * white[i];
    return result;
  }

  /// What the fit's own parameters cannot follow of a change.
  [[nodiscard]] Eigen::VectorXd beyond_own(const Eigen::VectorXd& change) const {
    if (basis_.cols() == 0) return change;
    return change - basis_ * (basis_.transpose() * change);
  }

  /// By how much the fit's own parameters move, in coordinates, to make up for a change of the prediction.
  [[nodiscard]] Eigen::VectorXd made_up(const Eigen::VectorXd& change) const { return own_.solve(change); }

 private:
  const Measurements& measurements_;
  const FitSettings& settings_;
  std::vector<double> weight_;
  Eigen::VectorXd residual_;
  LeastSquares own_{{}};
  Eigen::MatrixXd basis_;
};

/// Best step within bounds along the columns, one after the other where a bound is met, and the cost it
/// saves.
/// \returns the share of what was left that is left after it
double best_step(const Weighing& weighing, const std::vector<Eigen::VectorXd>& columns,
                 const std::vector<ParameterRange>& ranges, const Probe& probe, std::vector<double>& start) {
  start = probe.at;
  Eigen::VectorXd left = weighing.residual();
  const double before = left.squaredNorm();
  for (int sweep = 0; sweep < (columns.size() > 1 ? 20 : 1); ++sweep) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const std::size_t p = probe.growing[c];
      const double square = columns[c].squaredNorm();
      if (!(square * ranges[p].scale * ranges[p].scale > 1e-6)) continue;  // never exercised
      const double prior = ranges[p].tolerance > 0 ? std::pow(ranges[p].tolerance, -2) : 0;
      const double wanted = (start[p] * square + columns[c].dot(left)) / (square + prior);
      const double step = std::clamp(wanted, ranges[p].low, ranges[p].high) - start[p];
      start[p] += step;
      left -= step * columns[c];
    }
  }
  return before > 0 ? left.squaredNorm() / before : 1;
}

/// The same for the large step of a probe, of which any share within bounds may be taken.
double best_share(const Weighing& weighing, const Eigen::VectorXd& column,
                  const std::vector<ParameterRange>& ranges, const Probe& probe, std::vector<double>& start) {
  start = probe.at;
  const Eigen::VectorXd& left = weighing.residual();
  double prior = 0, most = std::numeric_limits<double>::infinity();
  for (const std::size_t p : probe.growing) {
    const double way = probe.to[p] - probe.at[p];
    if (ranges[p].tolerance > 0) prior += std::pow(way / ranges[p].tolerance, 2);
    if (way > 0) most = std::min(most, (ranges[p].high - probe.at[p]) / way);
  }
  const double square = column.squaredNorm(), before = left.squaredNorm();
  if (!(square > 1e-6) || !(before > 0)) return 1;
  const double share = std::clamp(column.dot(left) / (square + prior), 0.0, most);
  for (const std::size_t p : probe.growing)
    start[p] = std::max(ranges[p].low, start[p] + share * (probe.to[p] - probe.at[p]));
  return (left - share * column).squaredNorm() / before;
}

/// One fit, and all that might act beside it.
class Screen {
 public:
  Screen(const Study& study, const Fit& fitted)
      : study_(study), fitted_(fitted), rig_(rig_with(study, fitted.candidate, fitted.parameters)) {
    const std::vector<EffectAt>& own = fitted.candidate.effects;
    for (const EffectAt& at : possible_effects(study)) {
      if (std::find(own.begin(), own.end(), at) != own.end()) continue;
      for (Probe& probe : probes(study, at)) probes_.push_back(std::move(probe));
    }
    simulate_main();
  }

  [[nodiscard]] const std::vector<Probe>& all() const { return probes_; }

  /// Derivatives of the prediction by the growing parameters of a probe, or what its large step changes; none
  /// where the rig cannot follow.
  [[nodiscard]] std::vector<Eigen::VectorXd> columns(std::size_t probe, const Weighing& weighing) const {
    std::vector<Eigen::VectorXd> result;
    if (rides_along(probes_[probe])) {
      for (std::size_t c = 0; c < probes_[probe].growing.size(); ++c)
        result.push_back(weighing.column(main_.sensitivity[first_[probe] + c]));
    } else if (const Prediction far = change(probes_[probe]); far.reached) {
      result.push_back(weighing.column(far.runs));
    }
    return result;
  }

 private:
  [[nodiscard]] Rig with(const Probe& probe, const std::vector<double>& values) const {
    Candidate candidate = fitted_.candidate;
    candidate.effects.push_back(probe.effect);
    std::vector<double> parameters = fitted_.parameters;
    parameters.insert(parameters.end(), values.begin(), values.end());
    return rig_with(study_, candidate, parameters);
  }

  void simulate_main() {
    std::vector<RigVariation> beside;
    for (const Probe& probe : probes_) {
      first_.push_back(beside.size());
      if (!rides_along(probe)) continue;
      const std::vector<ParameterRange> ranges = study_.ranges(probe.effect);
      for (const std::size_t p : probe.growing) {
        const double step = variation_share * ranges[p].scale;
        std::vector<double> values = probe.at;
        values[p] += step;
        beside.push_back({with(probe, values), step});
      }
    }
    main_ = simulate(study_.experiment(), rig_, beside);
  }

  [[nodiscard]] Prediction change(const Probe& probe) const {
    Prediction far = simulate(study_.experiment(), with(probe, probe.to), {});
    for (std::size_t r = 0; far.reached && r < far.runs.size(); ++r) far.runs[r] -= main_.runs[r];
    return far;
  }

  const Study& study_;
  const Fit& fitted_;
  Rig rig_;
  std::vector<Probe> probes_;
  std::vector<std::size_t> first_;  ///< by probe: its first variation beside the main rig
  Prediction main_;
};

/// What a probe changes when it goes from nothing to `start`.
Eigen::VectorXd change_of(const Probe& probe, const std::vector<Eigen::VectorXd>& columns,
                          const std::vector<double>& start) {
  Eigen::VectorXd change = Eigen::VectorXd::Zero(columns.front().size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const std::size_t p = probe.growing[c];
    const double way = rides_along(probe) ? 1 : probe.to[p] - probe.at[p];
    if (way != 0) change += (start[p] - probe.at[p]) / way * columns[c];
  }
  return change;
}

/// The fit's own parameters within their bounds, moved.
std::vector<double> moved(const Study& study, const Fit& fitted, const Eigen::VectorXd& by) {
  const std::vector<ParameterRange> ranges = study.ranges(fitted.candidate);
  std::vector<double> parameters = fitted.parameters;
  for (std::size_t p = 0; p < ranges.size(); ++p)
    parameters[p] =
        std::clamp(parameters[p] + by(static_cast<Eigen::Index>(p)), ranges[p].low, ranges[p].high);
  return parameters;
}

std::vector<double> joined(std::vector<double> first, const std::vector<double>& last) {
  first.insert(first.end(), last.begin(), last.end());
  return first;
}

/// What one probe promises. \param columns  none where the rig cannot follow it
Prospect prospect_of(const Study& study, const Fit& fitted, const Weighing& weighing, const Probe& probe,
                     const std::vector<Eigen::VectorXd>& columns) {
  std::vector<Eigen::VectorXd> beyond;
  beyond.reserve(columns.size());
  for (const Eigen::VectorXd& column : columns) beyond.push_back(weighing.beyond_own(column));
  const std::vector<ParameterRange> ranges = study.ranges(probe.effect);
  const bool small_steps = rides_along(probe) || columns.empty();
  std::vector<double> start;
  const double left = small_steps ? best_step(weighing, beyond, ranges, probe, start)
                                  : best_share(weighing, beyond.front(), ranges, probe, start);
  Prospect prospect{probe.effect, {joined(fitted.parameters, start)}, fitted.cost * left};
  if (small_steps) prospect.from.push_back(joined(fitted.parameters, probe.at));
  // A part of a large step may be nothing at all: no reading reaches where a cell saturates farther up.
  std::vector<std::vector<double>> ways{start};
  if (!small_steps) ways.push_back(probe.to);
  for (std::size_t w = 0; w < ways.size() && !columns.empty(); ++w) {
    const Eigen::VectorXd by = weighing.made_up(change_of(probe, columns, ways[w]));
    prospect.from.push_back(joined(moved(study, fitted, by), ways[w]));
  }
  return prospect;
}

}  // namespace

std::vector<Prospect> screen(const Study& study, const Fit& fitted, const FitSettings& settings) {
  const Screen side(study, fitted);
  const Weighing weighing(study, fitted, settings);
  std::vector<Prospect> prospects;
  for (std::size_t i = 0; i < side.all().size(); ++i) {
    Prospect prospect = prospect_of(study, fitted, weighing, side.all()[i], side.columns(i, weighing));
    if (prospects.empty() || prospects.back().effect != prospect.effect) {
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
