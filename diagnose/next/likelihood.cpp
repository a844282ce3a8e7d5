#include "diagnose/next/likelihood.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace plumbline::diagnose::next {
namespace {
double env(const char* name, double otherwise) {
  const char* s = std::getenv(name);
  return s ? std::atof(s) : otherwise;
}

constexpr double outlier_share = 0.02, outlier_width = 10;

/// Heavy-tailed about the declared scale.
double log_scale_prior(double log_scale) {
  static const double spread = env("SCALE", 0.25), nu = env("NU", 2);
  return -(nu + 1) / 2 * std::log1p(std::pow(log_scale / spread, 2) / nu);
}

}  // namespace

double log_sum(const VectorXd& v) {
  const double most = v.maxCoeff();
  if (!std::isfinite(most)) return most;
  return most + std::log((v.array() - most).exp().sum());
}

Hyperpriors usual_hyperpriors() {
  Hyperpriors p;
  const double exact = env("P0", 0.5);
  p.amplitude = {0, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.64, 1.28};
  const auto count = static_cast<double>(p.amplitude.size() - 1);
  for (const double a : p.amplitude)
    p.log_amplitude_prior.push_back(a == 0 ? std::log(exact) : std::log((1 - exact) / count));
  p.length = {0.15, 0.4, 1.0};
  p.correlation = {0, 0.35, 0.65, 0.85};
  double sum = 0;
  for (const double rho : p.correlation) {
    p.log_correlation_prior.push_back(-0.5 * std::pow(rho / env("PHI", 0.3), 2));
    sum += std::exp(p.log_correlation_prior.back());
  }
  for (double& one : p.log_correlation_prior) one -= std::log(sum);
  return p;
}

double Look::probability(std::size_t amplitude) const {
  return std::exp(log_by_amplitude[amplitude] - log_likelihood);
}

struct Likelihood::BlockLook {
  std::vector<double> log_by_amplitude;
  // by amplitude: weights of the cells are kept as log values, [correlation][length] -> cells
  std::vector<std::vector<VectorXd>> log_cell;
  std::vector<MatrixXd> square;                // [correlation]: W'W
  std::vector<std::vector<MatrixXd>> turned;   // [correlation][length]: modes x (1 + p)
};

Likelihood::Likelihood(const Data& data, const States& states, const Hyperpriors& priors, NoiseShape shape,
                       const std::vector<VectorXd>& nominal_residual)
    : data_(data), states_(states), priors_(priors), shape_(std::move(shape)) {
  for (std::size_t b = 0; b < data.blocks().size(); ++b) {
    const VectorXd& r = nominal_residual[b];
    double sum = 0, count = 0;
    for (Eigen::Index i = 0; i < r.size(); ++i)
      if (!shape_.outlier[b][static_cast<std::size_t>(i)]) sum += r(i) * r(i), count += 1;
    prepare(b, std::sqrt(sum / std::max(1.0, count)));
  }
}

void Likelihood::prepare(std::size_t b, double nominal_rms) {
  const Block& block = data_.blocks()[b];
  prepared_.emplace_back();
  Prepared& p = prepared_.back();
  p.unit = std::max(nominal_rms, 1e-3);
  for (Eigen::Index i = 0; i < block.size(); ++i)
    if (!shape_.outlier[b][static_cast<std::size_t>(i)]) p.kept.push_back(i);
  const auto n = static_cast<Eigen::Index>(p.kept.size());
  // scales: from well below the declared noise to the whole residual
  const double low = 0.25, high = std::max(4.0, 1.3 * p.unit), step = std::log(1.25);
  const int steps = std::min(24, std::max(10, static_cast<int>(std::ceil(std::log(high / low) / step))));
  VectorXd prior(steps + 1);
  for (int k = 0; k <= steps; ++k) {
    const double log_s = std::log(low) + std::log(high / low) * k / steps;
    p.scale.push_back(std::exp(log_s));
    prior(k) = log_scale_prior(log_s);
  }
  const double norm = log_sum(prior);
  for (int k = 0; k <= steps; ++k) p.log_scale_prior.push_back(prior(k) - norm);
  const auto cells = static_cast<Eigen::Index>(priors_.amplitude.size() * p.scale.size());
  p.inverse_square.resize(cells);
  for (std::size_t a = 0; a < priors_.amplitude.size(); ++a)
    for (std::size_t s = 0; s < p.scale.size(); ++s)
      p.inverse_square(static_cast<Eigen::Index>(a * p.scale.size() + s)) = 1 / (p.scale[s] * p.scale[s]);
  std::vector<MatrixXd> phi;
  static const double most = env("MOST", 48);
  for (const double length : priors_.length)
    phi.push_back(basis(Kernel(states_, length), block, static_cast<Eigen::Index>(most), 1e-3));
  for (std::size_t k = 0; k < priors_.correlation.size(); ++k) {
    Whitening w{VectorXd(n), VectorXd::Zero(n), 0};
    Eigen::Index before = -1;
    for (Eigen::Index j = 0; j < n; ++j) {
      const Eigen::Index i = p.kept[static_cast<std::size_t>(j)];
      const double sigma = shape_.relative[b](i);
      const bool follows = before >= 0 && block.run[static_cast<std::size_t>(before)] == block.run[static_cast<std::size_t>(i)];
      const double rho = follows ? std::pow(priors_.correlation[k], static_cast<double>(block.reading[static_cast<std::size_t>(i)] - block.reading[static_cast<std::size_t>(before)])) : 0;
      const double root = std::sqrt(1 - rho * rho);
      w.own(j) = 1 / (sigma * root);
      if (follows) w.before(j) = rho / (shape_.relative[b](before) * root);
      w.log_det += 2 * std::log(sigma * root * block.sigma(i));
      before = i;
    }
    p.whitening.push_back(std::move(w));
    p.turned.emplace_back();
    for (std::size_t l = 0; l < priors_.length.size(); ++l) {
      MatrixXd kept(n, phi[l].cols());
      for (Eigen::Index j = 0; j < n; ++j) kept.row(j) = phi[l].row(p.kept[static_cast<std::size_t>(j)]);
      const MatrixXd white = whiten(p, k, kept);
      const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(MatrixXd(white.transpose() * white));
      std::vector<Eigen::Index> modes;
      for (Eigen::Index m = 0; m < eigen.eigenvalues().size(); ++m)
        if (eigen.eigenvalues()(m) > 1e-9 * eigen.eigenvalues().maxCoeff()) modes.push_back(m);
      Turned t;
      t.lambda = eigen.eigenvalues()(modes);
      const MatrixXd v = eigen.eigenvectors()(Eigen::all, modes) * t.lambda.cwiseSqrt().cwiseInverse().asDiagonal();
      t.rotate = v.transpose() * white.transpose();
      t.back = phi[l] * v;
      t.inverse.resize(cells, t.lambda.size());
      t.constant.resize(cells);
      for (std::size_t a = 0; a < priors_.amplitude.size(); ++a)
        for (std::size_t s = 0; s < p.scale.size(); ++s) {
          const auto cell = static_cast<Eigen::Index>(a * p.scale.size() + s);
          const double s2 = p.scale[s] * p.scale[s];
          const Eigen::ArrayXd d = std::pow(priors_.amplitude[a] * p.unit, 2) * t.lambda.array() + s2;
          t.inverse.row(cell) = (d.inverse() - 1 / s2).matrix().transpose();
          t.constant(cell) = -0.5 * (d.log().sum() + static_cast<double>(n - t.lambda.size()) * std::log(s2) +
                                     p.whitening[k].log_det + static_cast<double>(n) * std::log(2 * std::numbers::pi)) +
                             p.log_scale_prior[s] + priors_.log_correlation_prior[k] -
                             std::log(static_cast<double>(priors_.length.size()));
        }
      p.turned.back().push_back(std::move(t));
    }
  }
}

MatrixXd Likelihood::whiten(const Prepared& block, std::size_t correlation, const MatrixXd& columns) const {
  const Whitening& w = block.whitening[correlation];
  MatrixXd result = w.own.asDiagonal() * columns;
  if (columns.rows() > 1)
    result.bottomRows(columns.rows() - 1) -=
        w.before.tail(columns.rows() - 1).asDiagonal() * columns.topRows(columns.rows() - 1);
  return result;
}

Likelihood::BlockLook Likelihood::look_at(std::size_t b, const VectorXd& residual, const MatrixXd* jacobian) const {
  const Prepared& p = prepared_[b];
  const auto n = static_cast<Eigen::Index>(p.kept.size());
  const Eigen::Index parameters = jacobian ? jacobian->cols() : 0;
  MatrixXd both(n, 1 + parameters);
  for (Eigen::Index j = 0; j < n; ++j) {
    both(j, 0) = residual(p.kept[static_cast<std::size_t>(j)]);
    if (jacobian) both.row(j).tail(parameters) = jacobian->row(p.kept[static_cast<std::size_t>(j)]);
  }
  BlockLook look;
  const auto scales = static_cast<Eigen::Index>(p.scale.size());
  const std::size_t amplitudes = priors_.amplitude.size();
  for (std::size_t k = 0; k < priors_.correlation.size(); ++k) {
    const MatrixXd white = whiten(p, k, both);
    look.square.push_back(white.transpose() * white);
    look.turned.emplace_back();
    look.log_cell.emplace_back();
    for (const Turned& t : p.turned[k]) {
      look.turned.back().push_back(t.rotate * white);
      const VectorXd a2 = look.turned.back().back().col(0).cwiseAbs2();
      look.log_cell.back().push_back(t.constant - 0.5 * (t.inverse * a2 + look.square.back()(0, 0) * p.inverse_square));
    }
  }
  for (std::size_t a = 0; a < amplitudes; ++a) {
    VectorXd parts(static_cast<Eigen::Index>(priors_.correlation.size() * priors_.length.size()));
    Eigen::Index next = 0;
    for (const auto& by_length : look.log_cell)
      for (const VectorXd& cells : by_length)
        parts(next++) = log_sum(cells.segment(static_cast<Eigen::Index>(a) * scales, scales));
    look.log_by_amplitude.push_back(log_sum(parts));
  }
  return look;
}

/// Outliers are dropped from the block and pay their share: as wide as a tenth of them would be.
double Likelihood::outliers_log_density(std::size_t b) const {
  double sum = 0;
  const Block& block = data_.blocks()[b];
  for (std::size_t i = 0; i < shape_.outlier[b].size(); ++i)
    sum += shape_.outlier[b][i] ? std::log(outlier_share / outlier_width / std::sqrt(2 * std::numbers::pi)) -
                                      std::log(block.sigma(static_cast<Eigen::Index>(i)) * shape_.relative[b](static_cast<Eigen::Index>(i)))
                                : std::log(1 - outlier_share);
  return sum;
}

Look Likelihood::look(const std::vector<VectorXd>& residual, const std::vector<MatrixXd>& jacobian) const {
  std::vector<BlockLook> blocks;
  Look result;
  result.log_by_amplitude = priors_.log_amplitude_prior;
  for (std::size_t b = 0; b < prepared_.size(); ++b) {
    blocks.push_back(look_at(b, residual[b], jacobian.empty() ? nullptr : &jacobian[b]));
    for (std::size_t a = 0; a < result.log_by_amplitude.size(); ++a)
      result.log_by_amplitude[a] += blocks.back().log_by_amplitude[a] + outliers_log_density(b);
  }
  result.log_likelihood = log_sum(Eigen::Map<const VectorXd>(
      result.log_by_amplitude.data(), static_cast<Eigen::Index>(result.log_by_amplitude.size())));
  if (jacobian.empty() || jacobian.front().cols() == 0) return result;
  const Eigen::Index count = jacobian.front().cols();
  result.gradient = VectorXd::Zero(count);
  result.information = MatrixXd::Zero(count, count);
  for (std::size_t b = 0; b < prepared_.size(); ++b) {
    const Prepared& p = prepared_[b];
    const auto scales = static_cast<Eigen::Index>(p.scale.size());
    for (std::size_t k = 0; k < priors_.correlation.size(); ++k)
      for (std::size_t l = 0; l < priors_.length.size(); ++l) {
        VectorXd weight(blocks[b].log_cell[k][l].size());
        for (std::size_t a = 0; a < result.log_by_amplitude.size(); ++a) {
          const double log_p = result.log_by_amplitude[a] - result.log_likelihood - blocks[b].log_by_amplitude[a];
          weight.segment(static_cast<Eigen::Index>(a) * scales, scales) =
              (blocks[b].log_cell[k][l].segment(static_cast<Eigen::Index>(a) * scales, scales).array() + log_p).exp();
        }
        const double all = weight.sum();
        if (all < 1e-9) continue;
        const double plain = weight.dot(p.inverse_square);
        const VectorXd turned_weight = p.turned[k][l].inverse.transpose() * weight;
        const MatrixXd& t = blocks[b].turned[k][l];
        const MatrixXd j = t.rightCols(count);
        const MatrixXd& square = blocks[b].square[k];
        result.gradient -= plain * square.col(0).tail(count) + j.transpose() * (turned_weight.asDiagonal() * t.col(0));
        result.information += plain * square.bottomRightCorner(count, count) + j.transpose() * turned_weight.asDiagonal() * j;
      }
  }
  return result;
}

Split Likelihood::split(const std::vector<VectorXd>& residual) const {
  Split result;
  std::vector<BlockLook> blocks;
  VectorXd by_amplitude = Eigen::Map<const VectorXd>(priors_.log_amplitude_prior.data(), static_cast<Eigen::Index>(priors_.log_amplitude_prior.size()));
  for (std::size_t b = 0; b < prepared_.size(); ++b) {
    blocks.push_back(look_at(b, residual[b], nullptr));
    for (Eigen::Index a = 0; a < by_amplitude.size(); ++a) by_amplitude(a) += blocks.back().log_by_amplitude[static_cast<std::size_t>(a)];
  }
  const double all = log_sum(by_amplitude);
  for (Eigen::Index a = 0; a < by_amplitude.size(); ++a)
    result.amplitude += std::exp(by_amplitude(a) - all) * priors_.amplitude[static_cast<std::size_t>(a)];
  for (std::size_t b = 0; b < prepared_.size(); ++b) {
    const Prepared& p = prepared_[b];
    const std::size_t scales = p.scale.size();
    VectorXd delta = VectorXd::Zero(data_.blocks()[b].size());
    double log_scale = 0, correlation = 0, length = 0;
    for (std::size_t k = 0; k < priors_.correlation.size(); ++k)
      for (std::size_t l = 0; l < priors_.length.size(); ++l) {
        const Turned& t = p.turned[k][l];
        VectorXd shrink = VectorXd::Zero(t.lambda.size());
        double weight = 0;
        for (std::size_t a = 0; a < priors_.amplitude.size(); ++a)
          for (std::size_t s = 0; s < scales; ++s) {
            const auto cell = static_cast<Eigen::Index>(a * scales + s);
            const double w = std::exp(blocks[b].log_cell[k][l](cell) - blocks[b].log_by_amplitude[a] +
                                      by_amplitude(static_cast<Eigen::Index>(a)) - all);
            weight += w;
            log_scale += w * std::log(p.scale[s]);
            // A^2 u^2 lambda / d = 1 - s^2 / d
            shrink -= w * p.scale[s] * p.scale[s] * t.inverse.row(cell).transpose();
          }
        correlation += weight * priors_.correlation[k];
        length += weight * priors_.length[l];
        delta += t.back * (shrink.asDiagonal() * blocks[b].turned[k][l].col(0));
      }
    result.delta.push_back(std::move(delta));
    result.scale.push_back(std::exp(log_scale));
    result.correlation.push_back(correlation);
    result.length.push_back(length);
  }
  return result;
}

}  // namespace plumbline::diagnose::next
