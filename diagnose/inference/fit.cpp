#include "diagnose/inference/fit.hpp"
#include "diagnose/noise/outliers.hpp"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::diagnose {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// What the priors of tolerances charge: the squares of parameters in units of their tolerances.
double penalty(const std::vector<ParameterRange>& ranges, const std::vector<double>& parameters) {
  double sum = 0;
  for (std::size_t p = 0; p < ranges.size(); ++p)
    if (ranges[p].tolerance > 0) sum += std::pow(parameters[p] / ranges[p].tolerance, 2);
  return sum;
}

/// A candidate's residuals and their Jacobian at the parameters of the last call.
class Problem {
 public:
  Problem(const Study& study, const Candidate& candidate, const FitSettings& settings)
      : study_(study), candidate_(candidate), settings_(settings), ranges_(study.ranges(candidate)) {}

  [[nodiscard]] const std::vector<ParameterRange>& ranges() const { return ranges_; }
  [[nodiscard]] bool reached() const { return reached_; }
  [[nodiscard]] const std::vector<double>& residual() const { return residual_; }
  [[nodiscard]] const Eigen::VectorXd& white() const { return white_; }
  [[nodiscard]] const RowMatrix& jacobian() const { return jacobian_; }

  /// The cost alone; infinite where the rig cannot follow the experiment.
  [[nodiscard]] double look(const std::vector<double>& parameters) const {
    const Prediction predicted = predict(study_, candidate_, parameters);
    if (!predicted.reached) return std::numeric_limits<double>::infinity();
    const std::vector<double> white =
        whiten(study_.measurements(), study_.residual(predicted), settings_.noise);
    double sum = penalty(ranges_, parameters);
    for (const double z : white) sum += huber(z, settings_.outlier_bound);
    return sum;
  }

  /// \returns false where the rig cannot follow the experiment
  bool evaluate(const std::vector<double>& parameters) {
    if (known_ && parameters == at_) return reached_;
    at_ = parameters;
    known_ = true;
    const Prediction predicted = predict(study_, candidate_, parameters, true);
    reached_ = predicted.reached;
    if (!reached_) return false;
    residual_ = study_.residual(predicted);
    white_ = column(whiten(study_.measurements(), residual_, settings_.noise));
    jacobian_.resize(white_.size(), static_cast<Eigen::Index>(ranges_.size()));
    for (std::size_t p = 0; p < ranges_.size(); ++p) {
      const std::vector<double> change = study_.measurements().in_sigmas(predicted.sensitivity[p]);
      jacobian_.col(static_cast<Eigen::Index>(p)) =
          -column(whiten(study_.measurements(), change, settings_.noise));
    }
    reached_ = white_.allFinite() && jacobian_.allFinite();
    return reached_;
  }

  [[nodiscard]] double cost() const {
    double sum = penalty(ranges_, at_);
    for (const double z : white_) sum += huber(z, settings_.outlier_bound);
    return sum;
  }

 private:
  static Eigen::VectorXd column(const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  }

  const Study& study_;
  const Candidate& candidate_;
  const FitSettings& settings_;
  std::vector<ParameterRange> ranges_;
  std::vector<double> at_;
  bool known_ = false, reached_ = false;
  std::vector<double> residual_;
  Eigen::VectorXd white_;
  RowMatrix jacobian_;
};

/// The problem as Ceres sees it: parameters in units of their scales, residuals whose squares are the losses,
/// and behind them one a free parameter for its prior. Parameters that are held fixed are not among its
/// unknowns.
class Scaled final : public ceres::CostFunction {
 public:
  Scaled(Problem& problem, std::vector<double> base, std::vector<std::size_t> free, double bound, int values)
      : problem_(problem), base_(std::move(base)), free_(std::move(free)), bound_(bound) {
    set_num_residuals(values + static_cast<int>(free_.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(free_.size()));
  }

  [[nodiscard]] std::vector<double> parameters(const double* scaled) const {
    std::vector<double> all = base_;
    for (std::size_t f = 0; f < free_.size(); ++f)
      all[free_[f]] = scaled[f] * problem_.ranges()[free_[f]].scale;
    return all;
  }

  bool Evaluate(double const* const* scaled, double* residuals, double** jacobians) const override {
    if (!problem_.evaluate(parameters(scaled[0]))) return false;
    const Eigen::VectorXd& white = problem_.white();
    const auto columns = static_cast<Eigen::Index>(free_.size());
    for (Eigen::Index i = 0; i < white.size(); ++i) {
      const double z = white(i);
      const double root = std::sqrt(huber(z, bound_));
      residuals[i] = std::copysign(root, z);
      if (jacobians == nullptr || jacobians[0] == nullptr) continue;
      const double slope = std::abs(z) <= bound_ ? 1 : bound_ / root;
      for (Eigen::Index f = 0; f < columns; ++f) {
        const std::size_t p = free_[static_cast<std::size_t>(f)];
        jacobians[0][i * columns + f] =
            slope * problem_.jacobian()(i, static_cast<Eigen::Index>(p)) * problem_.ranges()[p].scale;
      }
    }
    const bool sloped = jacobians != nullptr && jacobians[0] != nullptr;
    add_priors(scaled[0], residuals + white.size(), sloped ? jacobians[0] + white.size() * columns : nullptr);
    if (sloped) hold_at_bounds(scaled[0], residuals, jacobians[0]);
    return true;
  }

 private:
  /// Takes the slopes of parameters away that stand at a bound and would go beyond it: the others then go
  /// their way as if these were fixed.
  void hold_at_bounds(const double* scaled, const double* residuals, double* jacobian) const {
    const auto columns = static_cast<Eigen::Index>(free_.size());
    Eigen::Map<RowMatrix> slopes(jacobian, num_residuals(), columns);
    const Eigen::VectorXd uphill =
        slopes.transpose() * Eigen::Map<const Eigen::VectorXd>(residuals, num_residuals());
    for (Eigen::Index f = 0; f < columns; ++f) {
      const ParameterRange& range = problem_.ranges()[free_[static_cast<std::size_t>(f)]];
      if ((scaled[f] <= range.low / range.scale && uphill(f) > 0) ||
          (scaled[f] >= range.high / range.scale && uphill(f) < 0))
        slopes.col(f).setZero();
    }
  }

  void add_priors(const double* scaled, double* residuals, double* jacobian) const {
    for (std::size_t f = 0; f < free_.size(); ++f) {
      const ParameterRange& range = problem_.ranges()[free_[f]];
      const double per_scale = range.tolerance > 0 ? range.scale / range.tolerance : 0;
      residuals[f] = per_scale * scaled[f];
      for (std::size_t g = 0; jacobian != nullptr && g < free_.size(); ++g)
        jacobian[f * free_.size() + g] = f == g ? per_scale : 0;
    }
  }

  Problem& problem_;
  std::vector<double> base_;
  std::vector<std::size_t> free_;
  double bound_;
};

/// Minimises over the free parameters, the others held at their start. \returns whether a minimum was found
bool minimise(Problem& problem, const std::vector<std::size_t>& free, double outlier_bound, int values,
              std::vector<double>& parameters) {
  if (!problem.evaluate(parameters) || free.empty()) return problem.reached();
  std::vector<double> scaled;
  scaled.reserve(free.size());
  for (const std::size_t p : free) scaled.push_back(parameters[p] / problem.ranges()[p].scale);
  auto* cost = new Scaled(problem, parameters, free, outlier_bound, values);  // Ceres takes it over
  ceres::Problem least_squares;
  least_squares.AddResidualBlock(cost, nullptr, scaled.data());
  for (std::size_t f = 0; f < free.size(); ++f) {
    const ParameterRange& range = problem.ranges()[free[f]];
    least_squares.SetParameterLowerBound(scaled.data(), static_cast<int>(f), range.low / range.scale);
    least_squares.SetParameterUpperBound(scaled.data(), static_cast<int>(f), range.high / range.scale);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  // What fails stands in the summary; Ceres's warnings, silent or not, would go to standard error. Set once,
  // for all threads.
  [[maybe_unused]] static const auto level = FLAGS_minloglevel = google::GLOG_FATAL;
  // Steps are cut at the bounds; a search along them as well would look twice at each place.
  options.max_num_line_search_step_size_iterations = 0;
  options.max_num_iterations = 50;  // of them some are refused
  options.function_tolerance = 1e-5;
  options.parameter_tolerance = 1e-7;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &least_squares, &summary);
  parameters = cost->parameters(scaled.data());
  return summary.IsSolutionUsable() && problem.evaluate(parameters);
}

std::vector<std::size_t> all_but(std::size_t count, std::size_t left_out) {
  std::vector<std::size_t> result;
  for (std::size_t p = 0; p < count; ++p)
    if (p != left_out) result.push_back(p);
  return result;
}

/// What a fit leaves, the covariance of the parameters inside their bounds, and what is known of each.
void judge(const Problem& problem, const FitSettings& settings, Fit& fitted) {
  fitted.noise = settings.noise;
  fitted.cost = problem.cost();
  fitted.residual = problem.residual();
  fitted.whitened.assign(problem.white().begin(), problem.white().end());
  fitted.jacobian = problem.jacobian();
  const std::vector<ParameterRange>& ranges = problem.ranges();
  const auto count = static_cast<Eigen::Index>(ranges.size());
  RowMatrix weighted = problem.jacobian();
  for (Eigen::Index i = 0; i < weighted.rows(); ++i)
    if (std::abs(problem.white()(i)) > settings.outlier_bound) weighted.row(i).setZero();
  fitted.information = weighted.transpose() * weighted;
  fitted.covariance = Eigen::MatrixXd::Zero(count, count);
  fitted.at_bound.assign(ranges.size(), false);
  std::vector<Eigen::Index> inside;
  for (std::size_t p = 0; p < ranges.size(); ++p) {
    const double margin = 1e-6 * ranges[p].scale;
    fitted.at_bound[p] =
        fitted.parameters[p] <= ranges[p].low + margin || fitted.parameters[p] >= ranges[p].high - margin;
    if (!fitted.at_bound[p]) inside.push_back(static_cast<Eigen::Index>(p));
  }
  if (inside.empty()) return;
  Eigen::MatrixXd precision = fitted.information(inside, inside);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const double tolerance = ranges[static_cast<std::size_t>(inside[i])].tolerance;
    if (tolerance > 0) precision.diagonal()(static_cast<Eigen::Index>(i)) += std::pow(tolerance, -2);
  }
  const Eigen::VectorXd scale = precision.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  const Eigen::MatrixXd unit = scale.asDiagonal() * precision * scale.asDiagonal();
  const Eigen::MatrixXd inverse = unit.completeOrthogonalDecomposition().pseudoInverse();
  fitted.covariance(inside, inside) = scale.asDiagonal() * inverse * scale.asDiagonal();
}

std::vector<std::vector<double>> best_first(const Problem& problem, std::vector<std::vector<double>> from) {
  if (from.size() == 1) return from;
  std::vector<std::pair<double, std::vector<double>>> order;
  for (std::vector<double>& start : from)
    if (const double cost = problem.look(start); std::isfinite(cost))
      order.emplace_back(cost, std::move(start));
  std::sort(order.begin(), order.end());
  from.clear();
  for (auto& [cost, start] : order) from.push_back(std::move(start));
  return from;
}

}  // namespace

double huber(double residual, double bound) {
  const double size = std::abs(residual);
  return size <= bound ? size * size : bound * (2 * size - bound);
}

Fit fit_from(const Study& study, const Candidate& candidate, const FitSettings& settings,
             const std::vector<double>& start) {
  Problem problem(study, candidate, settings);
  Fit fitted;
  fitted.candidate = candidate;
  fitted.parameters = start;
  fitted.converged = minimise(problem, all_but(start.size(), start.size()), settings.outlier_bound,
                              static_cast<int>(study.measurements().size()), fitted.parameters);
  if (fitted.converged) judge(problem, settings, fitted);
  return fitted;
}

Fit in_noise(const Study& study, const Fit& fitted, const NoiseModel& noise) {
  FitSettings settings;
  settings.noise = noise;
  Problem problem(study, fitted.candidate, settings);
  Fit result = fitted;
  if (problem.evaluate(fitted.parameters)) judge(problem, settings, result);
  return result;
}

Fit fit(const Study& study, const Candidate& candidate, const FitSettings& settings,
        const InitialGuesses& known) {
  const Problem problem(study, candidate, settings);
  Fit best;
  best.candidate = candidate;
  std::vector<std::vector<double>> order = best_first(problem, known.points);
  if (order.size() > known.refined) order.resize(known.refined);
  for (const std::vector<double>& start : order) {
    Fit one = fit_from(study, candidate, settings, start);
    if (one.converged && (!best.converged || one.cost < best.cost)) best = std::move(one);
  }
  return best;
}

Fit fit(const Study& study, const Candidate& candidate, const FitSettings& settings) {
  return fit(study, candidate, settings, initial_guesses(study, candidate));
}

Profile profile(const Study& study, const Fit& fitted, std::size_t parameter, const FitSettings& settings,
                double rise) {
  Problem problem(study, fitted.candidate, settings);
  const ParameterRange range = problem.ranges().at(parameter);
  const std::vector<std::size_t> others = all_but(fitted.parameters.size(), parameter);
  // The fit's own cost may be one in other noise.
  const double least = problem.evaluate(fitted.parameters) ? problem.cost() : fitted.cost;
  const auto excess = [&](double value, std::vector<double>& warm) {
    warm[parameter] = value;
    const bool found = minimise(problem, others, settings.outlier_bound,
                                static_cast<int>(study.measurements().size()), warm);
    return found ? problem.cost() - least - rise : rise * 1e3;
  };
  const auto j = static_cast<Eigen::Index>(parameter);
  const double sigma = std::sqrt(fitted.covariance(j, j));
  const double first = sigma > 0 && std::isfinite(sigma) ? std::sqrt(rise) * sigma : 0.1 * range.scale;
  // Regula falsi on the root of the excess, which is nearly a parabola with its vertex at the fit.
  const auto cross = [&](double direction) {
    const double limit = direction > 0 ? range.high : range.low;
    std::vector<double> warm = fitted.parameters;
    double inner = fitted.parameters[parameter], outer = inner, reach = first;
    double inner_excess = -rise, outer_excess = -rise;
    for (int i = 0; i < 40 && outer_excess < 0; ++i) {
      inner = outer;
      inner_excess = outer_excess;
      outer = direction > 0 ? std::min(limit, outer + reach) : std::max(limit, outer - reach);
      outer_excess = excess(outer, warm);
      if (outer == limit && outer_excess < 0) return limit;
      reach *= 1.6;
    }
    for (int i = 0; i < 30 && std::abs(outer - inner) > 0.01 * first; ++i) {
      // Square roots make the parabola a line.
      const double a = std::sqrt(std::max(0.0, inner_excess + rise)), b = std::sqrt(outer_excess + rise);
      const double share = std::clamp((std::sqrt(rise) - a) / (b - a), 0.05, 0.95);
      const double middle = inner + share * (outer - inner);
      const double value = excess(middle, warm);
      if (std::abs(value) < 0.01 * rise) return middle;
      (value < 0 ? inner : outer) = middle;
      (value < 0 ? inner_excess : outer_excess) = value;
    }
    return (inner + outer) / 2;
  };
  const double a = catalogue_value(range.coordinate, cross(-1));
  const double b = catalogue_value(range.coordinate, cross(1));
  return {std::min(a, b), std::max(a, b)};
}

double degrees_of_freedom(const Measurements& measurements, const Fit& fit) {
  const auto values = static_cast<double>(measurements.size());
  const double taken = fit.parameters.empty() ? 0 : (fit.covariance * fit.information).trace();
  return std::max(1.0, values - taken);
}

double chi2_per_dof(const Measurements& measurements, const Fit& fit, const NoiseModel& noise) {
  double sum = 0;
  for (const double z : whiten(measurements, without_outliers(measurements, fit.residual), noise))
    sum += huber(z, FitSettings().outlier_bound);
  return sum / degrees_of_freedom(measurements, fit);
}

}  // namespace plumbline::diagnose
