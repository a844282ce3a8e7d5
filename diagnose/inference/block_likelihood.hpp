#pragma once
/// \file
/// The likelihood of the residuals of one channel,
///
///   residual = delta + noise,  delta ~ N(0, A^2 u^2 K(length)),  noise ~ N(0, s^2 R(correlation)),
///
/// on a grid of cells: size A and scale s, length and correlation. Whitened by the noise and rotated to the
/// principal axes of K, each cell costs as many operations as there are axes.

#include <vector>

#include "diagnose/discrepancy/kernel.hpp"
#include "diagnose/inference/hyperpriors.hpp"
#include "diagnose/log_sum.hpp"
#include "diagnose/noise/noise_shape.hpp"

namespace plumbline::diagnose {

/// Scales of the noise over the declared one, and the logarithms of their prior probabilities.
struct ScaleGrid {
  std::vector<double> scale, log_prior;
};

class BlockLikelihood {
 public:
  /// \param nominal  residual of the block by the nominal model, declared sigmas
  /// \param unit     u: its root mean square
  BlockLikelihood(const Measurements& measurements, const Block& block, const CommandStates& states,
                  const Hyperpriors& priors, const NoiseShape& shape, const VectorXd& nominal, double unit);

  [[nodiscard]] const ScaleGrid& scales() const { return scales_; }

  /// What the grid says of one residual and its derivatives.
  struct Look {
    std::vector<double> log_by_amplitude;  ///< log likelihood, all else summed out
    VectorXd log_by_scale;                 ///< the same by the scale of the noise, without a discrepancy
    /// By amplitude: variance of the discrepancy over that of the noise, one at most.
    std::vector<double> discrepancy;
    std::vector<std::vector<VectorXd>> log_cell;  ///< [correlation][length]: by amplitude and scale
    std::vector<MatrixXd> square;                 ///< [correlation]: whitened products
    std::vector<std::vector<MatrixXd>> rotated;   ///< [correlation][length]
  };
  /// \param columns  the residual, then its derivatives by parameters; all values of the block
  [[nodiscard]] Look look(const MatrixXd& columns) const;

  /// Adds gradient and information (Gauss and Newton's) of the log likelihood by the parameters.
  /// \param log_amplitude  log posterior of each amplitude, all blocks together
  void add_slopes(const Look& look, const std::vector<double>& log_amplitude, VectorXd& gradient,
                  MatrixXd& information) const;

  /// Posterior means.
  struct Split {
    VectorXd delta;  ///< of all values, declared sigmas
    double scale = 1, correlation = 0, length = 1;
  };
  [[nodiscard]] Split split(const Look& look, const std::vector<double>& log_amplitude) const;
  /// The same at the most probable cell alone.
  [[nodiscard]] Split most_probable(const Look& look, const std::vector<double>& log_amplitude) const;

  /// By value, the logarithm of the Bayes factor of a step that begins there over none, both with noise
  /// alone. Its height is Gaussian about zero, with a width of the half-Cauchy prior.
  /// \param end      by value, one past the last value that such a step reaches
  /// \param typical  scale of that prior, declared sigmas
  [[nodiscard]] VectorXd log_steps(const VectorXd& residual, const std::vector<Eigen::Index>& end,
                                   double typical) const;

  /// Leaves out correlations that are negligible at this residual.
  void prune(const VectorXd& residual);

 private:
  /// Noise of one correlation: row i of what is whitened is own(i) v(i) - before(i) v(i - 1).
  struct Whitening {
    double correlation, log_prior, log_det = 0;
    VectorXd own, before;
    MatrixXd periodic;  ///< orthonormal columns that are projected out
    MatrixXd span;      ///< orthonormal columns that hold the discrepancy
  };
  /// The discrepancy of one length, whitened by one correlation.
  struct Rotation {
    MatrixXd axes;      ///< of the span
    VectorXd variance;  ///< along them
    MatrixXd back;      ///< all values x axes
    MatrixXd inverse;   ///< cells x axes: 1 / (A^2 u^2 variance + s^2) - 1 / s^2
    VectorXd constant;  ///< by cell: what does not depend on the residual
  };

  void lay_grid(const Measurements& measurements, const Block& block, const VectorXd& nominal);
  [[nodiscard]] Whitening whitening(const Measurements& measurements, const Block& block,
                                    const NoiseShape& shape, std::size_t correlation) const;
  [[nodiscard]] Rotation rotation(const Whitening& noise, const MatrixXd& triangle, const MatrixXd& phi,
                                  const MatrixXd& covariance, double unit) const;
  [[nodiscard]] MatrixXd kept(const MatrixXd& columns) const { return columns(kept_, Eigen::all); }
  [[nodiscard]] MatrixXd whiten(const Whitening& noise, const MatrixXd& columns) const;
  /// Calls `visit(correlation, length, cell, log posterior)` for every cell.
  template <class Visit>
  void for_each_cell(const Look& look, const std::vector<double>& log_amplitude, Visit visit) const;
  [[nodiscard]] VectorXd shrunk(const Rotation& rotation, Eigen::Index cell) const;

  const Hyperpriors& priors_;
  double unit_;
  std::vector<Eigen::Index> kept_;  ///< values that are no outliers
  ScaleGrid scales_;
  VectorXd inverse_square_;  ///< by cell: 1 / s^2
  std::vector<Whitening> noise_;
  std::vector<std::vector<Rotation>> rotation_;  ///< [correlation][length]
};

}  // namespace plumbline::diagnose
