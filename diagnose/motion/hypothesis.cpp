#include "diagnose/motion/hypothesis.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/priors.hpp"

namespace plumbline::motion {
namespace {

using diagnose::ParameterPrior;
using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Steps of a fit at one size of the discrepancy, and the gain in log likelihood below which it ends.
constexpr int most_steps = 15;
constexpr double least_gain = 0.05;

/// A fit on its way.
struct Point {
  Start at;
  std::vector<SegmentMeans> left;
  Slope slope;
  double log_posterior = -std::numeric_limits<double>::infinity();
};

class Fit {
 public:
  Fit(const Study& study, const Likelihood& likelihood, const std::vector<Parameter>& parameters)
      : study_(study), likelihood_(likelihood), parameters_(parameters) {}

  /// \param every  of the segments is looked at
  [[nodiscard]] Point at(Start start, const Cell& cell, std::size_t every = 1) const {
    Point point{std::move(start), {}, {}};
    point.left = study_.left(parameters_, point.at.values, point.at.begins, every);
    weigh(point, cell);
    return point;
  }
  void weigh(Point& point, const Cell& cell) const {
    const bool finite = std::all_of(point.left.begin(), point.left.end(), [](const SegmentMeans& one) {
      return one.residual.allFinite() && one.slopes.allFinite() && one.initial.allFinite();
    });
    if (!finite) return;
    point.slope = likelihood_.slope(point.left, cell);
    point.log_posterior = point.slope.log_likelihood;
    for (std::size_t p = study_.unknowns(); p < parameters_.size(); ++p) {
      const auto k = static_cast<Index>(p);
      const ParameterPrior prior(parameters_[p].range);
      point.log_posterior += prior.log_density(point.at.values[p]);
      point.slope.gradient(k) -= prior.curvature(point.at.values[p]) * point.at.values[p];
      point.slope.information(k, k) += prior.curvature(point.at.values[p]);
    }
    if (!std::isfinite(point.log_posterior)) point.log_posterior = -std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] bool is_held(const Point& point, std::size_t p) const {
    const diagnose::ParameterRange& range = parameters_[p].range;
    const double slope = point.slope.gradient(static_cast<Index>(p));
    return (point.at.values[p] <= range.low && slope < 0) || (point.at.values[p] >= range.high && slope > 0);
  }
  /// Uphill until a step gains little.
  [[nodiscard]] Point best_from(Point point, const Cell& cell) const {
    double damping = 1e-3;
    for (int step = 0; step < most_steps; ++step) {
      std::vector<Index> free;
      for (std::size_t p = 0; p < parameters_.size(); ++p)
        if (!is_held(point, p)) free.push_back(static_cast<Index>(p));
      double gain = 0;
      for (int attempt = 0; attempt < 6 && gain == 0; ++attempt) {
        Point next = at(moved(point, free, damping), cell);
        if (next.log_posterior > point.log_posterior) {
          gain = next.log_posterior - point.log_posterior;
          point = std::move(next);
          damping = std::max(1e-9, damping / 10);
        } else {
          damping = std::max(0.3, 10 * damping);
        }
      }
      if (gain < least_gain) break;
    }
    return point;
  }

 private:
  /// Each begin moves to the most probable one beside the new values, by as much of the way as they do.
  [[nodiscard]] Start moved(const Point& point, const std::vector<Index>& free, double damping) const {
    MatrixXd curvature = point.slope.information(free, free);
    for (std::size_t f = 0; f < free.size(); ++f) {
      const auto k = static_cast<Index>(f);
      const double scale = parameters_[static_cast<std::size_t>(free[f])].range.scale;
      curvature(k, k) += damping * std::max(curvature(k, k), 1 / (scale * scale));
    }
    const VectorXd step = curvature.ldlt().solve(VectorXd(point.slope.gradient(free)));
    Start next = point.at;
    VectorXd by = VectorXd::Zero(static_cast<Index>(parameters_.size()));
    for (std::size_t f = 0; f < free.size(); ++f) {
      const auto p = static_cast<std::size_t>(free[f]);
      const diagnose::ParameterRange& range = parameters_[p].range;
      const double wanted = step(static_cast<Index>(f));
      next.values[p] =
          std::clamp(next.values[p] + (std::isfinite(wanted) ? wanted : 0), range.low, range.high);
      by(free[f]) = next.values[p] - point.at.values[p];
    }
    for (std::size_t s = 0; s < next.begins.size(); ++s)
      next.begins[s] +=
          (point.slope.begin[s] - next.begins[s]) / (1 + damping) + point.slope.begin_slopes[s] * by;
    return next;
  }

  const Study& study_;
  const Likelihood& likelihood_;
  const std::vector<Parameter>& parameters_;
};

/// Whether the logs would show a parameter of the rows at its typical size, the unknown numbers fitted beside
/// it.
bool shows_at_typical_size(const Study& study, const Hypothesis& h, const Slope& slope) {
  const auto unknowns = static_cast<Index>(study.unknowns());
  MatrixXd unknown = slope.information.topLeftCorner(unknowns, unknowns);
  unknown.diagonal().array() += std::numeric_limits<double>::min();  // some that no log shows
  const auto factor = unknown.ldlt();
  for (std::size_t p = study.unknowns(); p < h.parameters.size(); ++p) {
    const auto k = static_cast<Index>(p);
    const VectorXd across = slope.information.col(k).head(unknowns);
    const double precision = slope.information(k, k) - across.dot(factor.solve(across)),
                 typical = h.parameters[p].range.scale;
    if (precision * typical * typical > 1) return true;
  }
  return study.unknowns() == h.parameters.size();
}

/// The prior's volume that the rows' parameters keep, the unknown numbers integrated out.
double log_volume(const Study& study, const Hypothesis& h, const Slope& slope) {
  double log_volume = 0;
  std::vector<Index> rows, unknown;
  std::vector<double> width;
  for (std::size_t p = 0; p < h.parameters.size(); ++p) {
    const auto k = static_cast<Index>(p);
    if (p < study.unknowns()) {
      if (!h.at_bound[p] && slope.information(k, k) > 0) unknown.push_back(k);
      continue;
    }
    const ParameterPrior prior(h.parameters[p].range);
    const double log_density = prior.log_density(h.values[p]);
    if (h.at_bound[p]) {
      log_volume -= std::log1p(std::abs(slope.gradient(k)) / std::exp(log_density));
    } else if (slope.information(k, k) > 0) {
      rows.push_back(k), width.push_back(prior.width());
      log_volume += log_density + std::log(prior.width()) + std::log(2 * std::numbers::pi) / 2;
    }
  }
  if (rows.empty()) return log_volume;
  MatrixXd precision = slope.information(rows, rows);
  if (!unknown.empty()) {
    const MatrixXd across = slope.information(unknown, rows);
    precision -= across.transpose() * MatrixXd(slope.information(unknown, unknown)).ldlt().solve(across);
  }
  const VectorXd unit = Eigen::Map<const VectorXd>(width.data(), static_cast<Index>(width.size()));
  precision = (unit.asDiagonal() * precision * unit.asDiagonal()).eval();
  for (const double one : VectorXd(Eigen::SelfAdjointEigenSolver<MatrixXd>(precision).eigenvalues()))
    log_volume -= std::log1p(std::max(0.0, one)) / 2;
  return log_volume;
}

/// Numbers that the logs cannot tell apart are as uncertain as their typical sizes allow.
MatrixXd covariance_of(const Hypothesis& h, const MatrixXd& information) {
  std::vector<Index> inside;
  for (std::size_t p = 0; p < h.parameters.size(); ++p)
    if (!h.at_bound[p]) inside.push_back(static_cast<Index>(p));
  MatrixXd covariance = MatrixXd::Zero(information.rows(), information.cols());
  const auto n = static_cast<Index>(inside.size());
  VectorXd unit(n);
  for (Index f = 0; f < n; ++f)
    unit(f) = h.parameters[static_cast<std::size_t>(inside[static_cast<std::size_t>(f)])].range.scale;
  const MatrixXd scaled = MatrixXd::Identity(n, n) +
                          unit.asDiagonal() * MatrixXd(information(inside, inside)) * unit.asDiagonal();
  covariance(inside, inside) =
      unit.asDiagonal() * scaled.ldlt().solve(MatrixXd::Identity(n, n)) * unit.asDiagonal();
  return covariance;
}

/// Logarithm of the prior probability of these rows among all.
double log_prior_of(const Study& study, const Candidate& candidate) {
  using diagnose::priors::causes, diagnose::priors::refinement;
  if (candidate.rows.empty()) return 0;
  double all = 0;
  for (const Row& row : study.rows()) all += row.refines ? refinement : 1;
  double log_p = std::log(causes[std::min(candidate.rows.size(), causes.size()) - 1]);
  for (std::size_t i = 0; i < candidate.rows.size(); ++i)
    log_p += std::log((candidate.rows[i]->refines ? refinement : 1) / all * static_cast<double>(i + 1));
  return log_p;
}

}  // namespace

double forecast(const Study& study, const Likelihood& likelihood, const Candidate& candidate,
                const Start& start, const Cell& cell) {
  const std::vector<Parameter> parameters = study.parameters(candidate);
  constexpr std::size_t segments_suffice = 48;  // to rank what is fitted to all of them
  const std::size_t every = (study.segments().size() + segments_suffice - 1) / segments_suffice;
  const Point point = Fit(study, likelihood, parameters).at(start, cell, every);
  if (!std::isfinite(point.log_posterior)) return point.log_posterior;
  return point.log_posterior +
         point.slope.gradient.dot(point.slope.information.ldlt().solve(point.slope.gradient)) / 2;
}

Quantities sizes_of(const std::vector<SegmentMeans>& left) {
  Quantities size{}, count{};
  for (const SegmentMeans& one : left)
    for (std::size_t i = 0; i < one.quantity.size(); ++i) {
      size[one.quantity[i]] += std::pow(one.residual(static_cast<Index>(i)), 2);
      ++count[one.quantity[i]];
    }
  for (std::size_t q = 0; q < quantity_count; ++q) size[q] = std::sqrt(size[q] / std::max(1.0, count[q]));
  return size;
}

Hypothesis fitted(const Study& study, const Likelihood& likelihood, Candidate candidate, Start start) {
  Hypothesis h;
  h.parameters = study.parameters(candidate);
  h.log_prior = log_prior_of(study, candidate);
  h.candidate = std::move(candidate);
  const Fit fit(study, likelihood, h.parameters);
  Point point = fit.at(std::move(start), Cell{likelihood.unit(), 0.5});
  Cell cell = likelihood.look(point.left).best;
  for (int round = 0; round < 2; ++round) {
    fit.weigh(point, cell);
    point = fit.best_from(std::move(point), cell);
    h.look = likelihood.look(point.left);
    if (h.look.best.amplitude == cell.amplitude && h.look.best.correlation == cell.correlation) break;
    cell = h.look.best;
  }
  fit.weigh(point, h.look.best);
  for (std::size_t p = 0; p < h.parameters.size(); ++p) {
    const diagnose::ParameterRange& range = h.parameters[p].range;
    const double margin = 1e-6 * range.scale;
    h.at_bound.push_back(point.at.values[p] <= range.low + margin ||
                         point.at.values[p] >= range.high - margin);
  }
  h.values = point.at.values;
  h.begins = point.at.begins;
  h.covariance = covariance_of(h, point.slope.information);
  const Slope slope = likelihood.slope(point.left, h.look.best);
  h.shows = shows_at_typical_size(study, h, slope);
  h.log_volume = log_volume(study, h, slope);
  return h;
}

}  // namespace plumbline::motion
