#pragma once
/// \file
/// The likelihood of what a model leaves of the readings: discrepancy and noise, their sizes summed out.
///
///   residual = delta + noise,  delta ~ N(0, A^2 u^2 K(length)),  noise ~ N(0, s^2 R(correlation))
///
/// by block, with one A for all blocks in units u of the nominal residual's rms. Sums over A, s, length and
/// correlation are over grids, with their priors.

#include <vector>

#include "diagnose/next/discrepancy.hpp"

namespace plumbline::diagnose::next {

/// How the readings of a block scatter, beside scale and correlation, which are summed out.
struct NoiseShape {
  std::vector<VectorXd> relative;            ///< by block and value: sigma over the declared one
  std::vector<std::vector<bool>> outlier;  ///< by block and value
};

/// Grids and priors of what is summed out.
struct Hyperpriors {
  std::vector<double> amplitude, log_amplitude_prior;
  std::vector<double> length;
  std::vector<double> correlation, log_correlation_prior;
};
Hyperpriors usual_hyperpriors();

/// What the likelihood says at one residual.
struct Look {
  double log_likelihood = 0;
  VectorXd gradient;                      ///< by the parameters
  MatrixXd information;                   ///< Gauss and Newton's
  std::vector<double> log_by_amplitude;  ///< log of likelihood times prior of each amplitude
  [[nodiscard]] double probability(std::size_t amplitude) const;
};

/// Posterior means at one residual.
struct Split {
  std::vector<VectorXd> delta;  ///< by block, declared sigmas
  std::vector<double> scale, correlation, length;  ///< by block
  double amplitude = 0;
};

class Likelihood {
 public:
  Likelihood(const Data& data, const States& states, const Hyperpriors& priors, NoiseShape shape,
             const std::vector<VectorXd>& nominal_residual);

  [[nodiscard]] const Data& data() const { return data_; }
  [[nodiscard]] const NoiseShape& shape() const { return shape_; }
  [[nodiscard]] const Hyperpriors& priors() const { return priors_; }

  /// \param jacobian  of the residual by the parameters, by block; no columns: likelihood alone
  [[nodiscard]] Look look(const std::vector<VectorXd>& residual, const std::vector<MatrixXd>& jacobian) const;
  [[nodiscard]] Split split(const std::vector<VectorXd>& residual) const;

 private:
  struct Turned {  // one correlation and length
    MatrixXd rotate;   // modes x kept values (whitened)
    MatrixXd back;     // all values x modes
    VectorXd lambda;
    std::vector<MatrixXd> unused;
    MatrixXd inverse;  // cells x modes: 1 / d
    VectorXd constant; // by cell: all that does not depend on the residual
  };
  struct Whitening {
    VectorXd own, before;  // by kept value
    double log_det = 0;
  };
  struct Prepared {
    std::vector<Eigen::Index> kept;
    double unit = 1;
    std::vector<double> scale, log_scale_prior;
    std::vector<Whitening> whitening;  // by correlation
    std::vector<std::vector<Turned>> turned;  // [correlation][length]
    VectorXd inverse_square;  // by cell: 1 / s^2
  };
  struct BlockLook;
  void prepare(std::size_t block, double nominal_rms);
  [[nodiscard]] MatrixXd whiten(const Prepared& block, std::size_t correlation, const MatrixXd& columns) const;
  [[nodiscard]] BlockLook look_at(std::size_t b, const VectorXd& residual, const MatrixXd* jacobian) const;
  [[nodiscard]] double outliers_log_density(std::size_t b) const;

  const Data& data_;
  const States& states_;
  Hyperpriors priors_;
  NoiseShape shape_;
  std::vector<Prepared> prepared_;
};

double log_sum(const VectorXd& v);

}  // namespace plumbline::diagnose::next
