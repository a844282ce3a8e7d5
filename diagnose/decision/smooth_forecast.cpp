#include "diagnose/decision/smooth_forecast.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "diagnose/discrepancy/kernel.hpp"

namespace plumbline::diagnose {
namespace {

/// A matrix R with R R' = a covariance.
MatrixXd root_of(const MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(covariance);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
}

/// A function Phi w, w standard normal times a size, fitted to values in the noise sigma.
struct SmoothFit {
  double log_evidence = -std::numeric_limits<double>::infinity();
  VectorXd everywhere;

  void offer(const MatrixXd& phi, const std::vector<Eigen::Index>& seen, const VectorXd& values,
             const VectorXd& sigma, double size) {
    const MatrixXd white = size * sigma.cwiseInverse().asDiagonal() * MatrixXd(phi(seen, Eigen::all));
    const VectorXd y = values.cwiseQuotient(sigma);
    const Eigen::LLT<MatrixXd> factor(
        MatrixXd(MatrixXd::Identity(phi.cols(), phi.cols()) + white.transpose() * white));
    const VectorXd along = white.transpose() * y, w = factor.solve(along);
    const double log_det = 2 * MatrixXd(factor.matrixL()).diagonal().array().log().sum();
    const double evidence = -0.5 * (y.squaredNorm() - along.dot(w) + log_det);
    if (evidence <= log_evidence) return;
    log_evidence = evidence;
    everywhere = size * phi * w;
  }
};

/// What is left of a model's residual beside a smooth function of the readings that are seen.
VectorXd left_by_smooth(const Study& study, const CommandStates& states, const NoiseEstimate& noise,
                        const HeldOut& part, VectorXd left) {
  const Measurements& measurements = study.measurements();
  const Hyperpriors priors = full_model();
  const VectorXd sigma = noise.sigma(measurements);
  for (const Block& block : measurements.blocks()) {
    std::vector<Eigen::Index> seen;
    for (Eigen::Index i = 0; i < block.count; ++i) {
      const auto row = static_cast<std::size_t>(block.first + i);
      const ReadingPlace& at = measurements.places()[row];
      if (!part.reading[at.run][at.reading] && !noise.shape.outlier[row]) seen.push_back(i);
    }
    if (seen.empty()) continue;
    const VectorXd values = VectorXd(left.segment(block.first, block.count))(seen);
    const double unit = std::sqrt(values.squaredNorm() / static_cast<double>(seen.size()));
    const DiscrepancyBasis basis = discrepancy_basis(states, measurements, block, priors.length);
    SmoothFit fit;
    for (const MatrixXd& covariance : basis.covariance)
      for (const double size : priors.amplitude)
        fit.offer(basis.phi * root_of(covariance), seen, values,
                  VectorXd(sigma.segment(block.first, block.count))(seen), size * unit);
    left.segment(block.first, block.count) -= fit.everywhere;
  }
  return left;
}

}  // namespace

std::optional<Shrink> gain_over_smooth(const Study& study, const Findings& findings,
                                       const NoiseEstimate& noise, const Hypothesis& hypothesis) {
  const CommandStates states(study.experiment());
  const auto beside_smooth = [&](const LeftUnseen& model) {
    return [&, model](const Study& seen, const NoiseEstimate& noise_seen, const HeldOut& part) {
      std::optional<VectorXd> left = model(seen, noise_seen, part);
      if (left) left = left_by_smooth(study, states, noise, part, *std::move(left));
      return left;
    };
  };
  const auto nominal = [&](const Study&, const NoiseEstimate&, const HeldOut&) {
    return std::optional(study.nominal_residual());
  };
  return cross_validated(study, noise, beside_smooth(left_by(study, findings, hypothesis)),
                         beside_smooth(nominal));
}

}  // namespace plumbline::diagnose
