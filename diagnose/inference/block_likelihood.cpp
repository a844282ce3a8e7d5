#include "diagnose/inference/block_likelihood.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "diagnose/bench/median.hpp"
#include "diagnose/inference/size_prior.hpp"

namespace plumbline::diagnose {
namespace {

/// Triangular factor and orthonormal columns of a matrix.
struct Factors {
  MatrixXd orthonormal, triangle;
};

Factors factors_of(const MatrixXd& columns) {
  const Eigen::Index rank = std::min(columns.rows(), columns.cols());
  if (rank == 0) return {MatrixXd(columns.rows(), 0), MatrixXd(0, 0)};
  const Eigen::HouseholderQR<MatrixXd> qr(columns);
  return {qr.householderQ() * MatrixXd::Identity(columns.rows(), rank),
          MatrixXd(qr.matrixQR().topRows(rank)).triangularView<Eigen::Upper>()};
}

/// Products of tall columns with a few others; a product by columns spares the packing of the tall ones.
MatrixXd products(const MatrixXd& tall, const MatrixXd& few) {
  MatrixXd result(tall.cols(), few.cols());
  for (Eigen::Index c = 0; c < few.cols(); ++c) result.col(c).noalias() = tall.transpose() * few.col(c);
  return result;
}

/// Half of the noise by which neighbours differ.
double quiet_neighbours(const Measurements& measurements, const Block& block, const VectorXd& nominal,
                        const std::vector<Eigen::Index>& kept) {
  std::vector<double> steps;
  for (std::size_t j = 1; j < kept.size(); ++j) {
    const auto run = [&](std::size_t k) {
      return measurements.places()[static_cast<std::size_t>(block.first + kept[k])].run;
    };
    if (run(j) == run(j - 1)) steps.push_back(nominal(kept[j]) - nominal(kept[j - 1]));
  }
  return steps.empty() ? 1 : 0.5 * median_deviation(std::move(steps)) / std::numbers::sqrt2;
}

/// Whether some readings follow each other in time.
bool is_timed(const Measurements& measurements, const Block& block) {
  const auto first = measurements.places().begin() + block.first;
  return std::any_of(first, first + block.count,
                     [&](const ReadingPlace& place) { return measurements.has_clock(place.run); });
}

}  // namespace

BlockLikelihood::BlockLikelihood(const Measurements& measurements, const Block& block,
                                 const CommandStates& states, const Hyperpriors& priors,
                                 const NoiseShape& shape, const VectorXd& nominal, double unit)
    : priors_(priors), unit_(unit) {
  for (Eigen::Index i = 0; i < block.count; ++i)
    if (!shape.outlier[static_cast<std::size_t>(block.first + i)]) kept_.push_back(i);
  lay_grid(measurements, block, nominal);
  const bool flexible = priors.amplitude.size() > 1;
  const DiscrepancyBasis basis = flexible ? discrepancy_basis(states, measurements, block, priors.length)
                                          : DiscrepancyBasis{MatrixXd(block.count, 0), {MatrixXd(0, 0)}};
  // Without a clock noise is the same by whatever correlation.
  const bool timed = is_timed(measurements, block);
  for (std::size_t k = 0; k < (timed ? priors.correlation.size() : 1); ++k) {
    noise_.push_back(whitening(measurements, block, shape, k));
    if (!timed) noise_.back().log_prior = 0;
    Factors factors = factors_of(whiten(noise_.back(), kept(basis.phi)));
    noise_.back().span = std::move(factors.orthonormal);
    rotation_.emplace_back();
    for (const MatrixXd& covariance : basis.covariance)
      rotation_.back().push_back(rotation(noise_.back(), factors.triangle, basis.phi, covariance, unit));
  }
}

void BlockLikelihood::lay_grid(const Measurements& measurements, const Block& block,
                               const VectorXd& nominal) {
  constexpr double step = 1.25;
  constexpr int fewest = 10, most = 30;
  // From below the declared noise, and below what neighbours differ by, to the whole residual.
  const double low = std::clamp(quiet_neighbours(measurements, block, nominal, kept_), 0.02, 0.25),
               high = std::max(4.0, 1.3 * unit_);
  const int steps =
      std::clamp(static_cast<int>(std::ceil(std::log(high / low) / std::log(step))), fewest, most);
  for (int k = 0; k <= steps; ++k) {
    const double log_scale = std::log(low) + std::log(high / low) * k / steps;
    scales_.scale.push_back(std::exp(log_scale));
    scales_.log_prior.push_back(log_scale_prior(log_scale));
  }
  const double norm = log_sum(scales_.log_prior);
  for (double& one : scales_.log_prior) one -= norm;
  const std::size_t scales = scales_.scale.size();
  inverse_square_.resize(static_cast<Eigen::Index>(priors_.amplitude.size() * scales));
  for (Eigen::Index cell = 0; cell < inverse_square_.size(); ++cell)
    inverse_square_(cell) = std::pow(scales_.scale[static_cast<std::size_t>(cell) % scales], -2);
}

BlockLikelihood::Whitening BlockLikelihood::whitening(const Measurements& measurements, const Block& block,
                                                      const NoiseShape& shape,
                                                      std::size_t correlation) const {
  const auto n = static_cast<Eigen::Index>(kept_.size());
  Whitening noise{priors_.correlation[correlation],
                  priors_.log_correlation[correlation],
                  0,
                  VectorXd(n),
                  VectorXd::Zero(n),
                  {},
                  {}};
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Index i = block.first + kept_[static_cast<std::size_t>(j)];
    const ReadingPlace& here = measurements.places()[static_cast<std::size_t>(i)];
    const double sigma = shape.relative(i);
    double rho = 0, before = 0;
    if (j > 0) {
      const Eigen::Index last = block.first + kept_[static_cast<std::size_t>(j - 1)];
      const ReadingPlace& there = measurements.places()[static_cast<std::size_t>(last)];
      if (there.run == here.run && measurements.has_clock(here.run))
        rho = std::pow(noise.correlation, static_cast<double>(here.reading - there.reading));
      before = shape.relative(last);
    }
    const double innovation = std::sqrt(1 - rho * rho);
    noise.own(j) = 1 / (sigma * innovation);
    if (rho != 0) noise.before(j) = rho / (before * innovation);
    noise.log_det += 2 * std::log(sigma * innovation * measurements.sigma()(i));
  }
  if (shape.periodic.cols() > 0) {
    MatrixXd periodic = shape.periodic.middleRows(block.first, block.count);
    std::vector<Eigen::Index> own;
    for (Eigen::Index c = 0; c < periodic.cols(); ++c)
      if (periodic.col(c).squaredNorm() > 0) own.push_back(c);
    noise.periodic = factors_of(whiten(noise, kept(periodic(Eigen::all, own)))).orthonormal;
  }
  return noise;
}

BlockLikelihood::Rotation BlockLikelihood::rotation(const Whitening& noise, const MatrixXd& triangle,
                                                    const MatrixXd& phi, const MatrixXd& covariance,
                                                    double unit) const {
  Rotation result;
  result.axes.resize(noise.span.cols(), 0);
  result.back.resize(phi.rows(), 0);
  if (triangle.rows() > 0) {
    const MatrixXd root = triangle * covariance;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(MatrixXd(root * triangle.transpose()));
    std::vector<Eigen::Index> axes;
    for (Eigen::Index m = 0; m < eigen.eigenvalues().size(); ++m)
      if (eigen.eigenvalues()(m) > 1e-8 * eigen.eigenvalues().maxCoeff()) axes.push_back(m);
    result.variance = eigen.eigenvalues()(axes);
    result.axes = eigen.eigenvectors()(Eigen::all, axes);
    result.back = phi * (root.transpose() * result.axes * result.variance.cwiseInverse().asDiagonal());
  }
  const auto n = static_cast<double>(kept_.size()) - static_cast<double>(noise.periodic.cols());
  const auto axes = static_cast<double>(result.variance.size());
  result.inverse.resize(inverse_square_.size(), result.variance.size());
  result.constant.resize(inverse_square_.size());
  for (std::size_t a = 0; a < priors_.amplitude.size(); ++a)
    for (std::size_t s = 0; s < scales_.scale.size(); ++s) {
      const auto cell = static_cast<Eigen::Index>(a * scales_.scale.size() + s);
      const double square = scales_.scale[s] * scales_.scale[s], size = priors_.amplitude[a] * unit;
      const Eigen::ArrayXd d = size * size * result.variance.array() + square;
      result.inverse.row(cell) = (d.inverse() - 1 / square).matrix().transpose();
      result.constant(cell) = -0.5 * (d.log().sum() + (n - axes) * std::log(square) + noise.log_det +
                                      n * std::log(2 * std::numbers::pi)) +
                              scales_.log_prior[s] + noise.log_prior -
                              std::log(static_cast<double>(priors_.length.size()));
    }
  return result;
}

MatrixXd BlockLikelihood::whiten(const Whitening& noise, const MatrixXd& columns) const {
  MatrixXd result = noise.own.asDiagonal() * columns;
  const Eigen::Index rest = columns.rows() - 1;
  if (rest > 0) result.bottomRows(rest) -= noise.before.tail(rest).asDiagonal() * columns.topRows(rest);
  if (noise.periodic.cols() > 0) result -= noise.periodic * products(noise.periodic, result);
  return result;
}

BlockLikelihood::Look BlockLikelihood::look(const MatrixXd& columns) const {
  const MatrixXd values = kept(columns);
  const auto scales = static_cast<Eigen::Index>(scales_.scale.size());
  Look result;
  for (std::size_t k = 0; k < noise_.size(); ++k) {
    const MatrixXd white = whiten(noise_[k], values), spanned = products(noise_[k].span, white);
    result.square.emplace_back(white.transpose() * white);
    result.rotated.emplace_back();
    result.log_cell.emplace_back();
    for (const Rotation& one : rotation_[k]) {
      result.rotated.back().emplace_back(one.axes.transpose() * spanned);
      const VectorXd along = result.rotated.back().back().col(0).cwiseAbs2();
      result.log_cell.back().emplace_back(
          one.constant - 0.5 * (one.inverse * along + result.square.back()(0, 0) * inverse_square_));
    }
  }
  // By scale, at one size of the discrepancy.
  const auto by_scale = [&](std::size_t amplitude) {
    MatrixXd parts(static_cast<Eigen::Index>(noise_.size() * priors_.length.size()), scales);
    Eigen::Index next = 0;
    for (const auto& by_length : result.log_cell)
      for (const VectorXd& cells : by_length)
        parts.row(next++) = cells.segment(static_cast<Eigen::Index>(amplitude) * scales, scales).transpose();
    VectorXd sums(scales);
    for (Eigen::Index s = 0; s < scales; ++s) sums(s) = log_sum(VectorXd(parts.col(s)));
    return sums;
  };
  for (std::size_t a = 0; a < priors_.amplitude.size(); ++a) {
    const VectorXd parts = by_scale(a);
    if (a == 0) result.log_by_scale = parts;
    result.log_by_amplitude.push_back(log_sum(parts));
    const double quiet =
        (parts.array() - result.log_by_amplitude.back()).exp().matrix().dot(inverse_square_.head(scales));
    result.discrepancy.push_back(std::min(1.0, std::pow(priors_.amplitude[a] * unit_, 2) * quiet));
  }
  return result;
}

template <class Visit>
void BlockLikelihood::for_each_cell(const Look& look, const std::vector<double>& log_amplitude,
                                    Visit visit) const {
  for (std::size_t k = 0; k < noise_.size(); ++k)
    for (std::size_t l = 0; l < rotation_[k].size(); ++l)
      for (Eigen::Index cell = 0; cell < inverse_square_.size(); ++cell) {
        const std::size_t a = static_cast<std::size_t>(cell) / scales_.scale.size();
        visit(k, l, cell, look.log_cell[k][l](cell) - look.log_by_amplitude[a] + log_amplitude[a]);
      }
}

void BlockLikelihood::add_slopes(const Look& look, const std::vector<double>& log_amplitude,
                                 VectorXd& gradient, MatrixXd& information) const {
  const Eigen::Index count = gradient.size();
  std::vector<std::vector<VectorXd>> weight(noise_.size());
  for (std::size_t k = 0; k < noise_.size(); ++k)
    weight[k].assign(rotation_[k].size(), VectorXd::Zero(inverse_square_.size()));
  for_each_cell(look, log_amplitude, [&](std::size_t k, std::size_t l, Eigen::Index cell, double log_p) {
    weight[k][l](cell) = std::exp(log_p);
  });
  constexpr double negligible = 1e-9;
  for (std::size_t k = 0; k < noise_.size(); ++k)
    for (std::size_t l = 0; l < rotation_[k].size(); ++l) {
      if (weight[k][l].sum() < negligible) continue;
      const double white = weight[k][l].dot(inverse_square_);
      const VectorXd along = rotation_[k][l].inverse.transpose() * weight[k][l];
      const MatrixXd& rotated = look.rotated[k][l];
      const auto slopes = rotated.rightCols(count);
      gradient -= white * look.square[k].col(0).tail(count) +
                  slopes.transpose() * (along.asDiagonal() * rotated.col(0));
      information += white * look.square[k].bottomRightCorner(count, count) +
                     slopes.transpose() * along.asDiagonal() * slopes;
    }
}

/// By axis: A^2 u^2 variance / (A^2 u^2 variance + s^2).
VectorXd BlockLikelihood::shrunk(const Rotation& rotation, Eigen::Index cell) const {
  return -rotation.inverse.row(cell).transpose() / inverse_square_(cell);
}

BlockLikelihood::Split BlockLikelihood::split(const Look& look,
                                              const std::vector<double>& log_amplitude) const {
  Split result{VectorXd::Zero(rotation_.front().front().back.rows()), 0, 0, 0};
  std::vector<std::vector<VectorXd>> share(noise_.size());
  for (std::size_t k = 0; k < noise_.size(); ++k)
    for (const Rotation& one : rotation_[k]) share[k].emplace_back(VectorXd::Zero(one.variance.size()));
  double log_scale = 0;
  for_each_cell(look, log_amplitude, [&](std::size_t k, std::size_t l, Eigen::Index cell, double log_p) {
    const double p = std::exp(log_p);
    if (p < 1e-12) return;
    log_scale += p * std::log(scales_.scale[static_cast<std::size_t>(cell) % scales_.scale.size()]);
    result.correlation += p * noise_[k].correlation;
    result.length += p * priors_.length[l];
    share[k][l] += p * shrunk(rotation_[k][l], cell);
  });
  for (std::size_t k = 0; k < noise_.size(); ++k)
    for (std::size_t l = 0; l < rotation_[k].size(); ++l)
      result.delta += rotation_[k][l].back * share[k][l].cwiseProduct(look.rotated[k][l].col(0));
  result.scale = std::exp(log_scale);
  return result;
}

BlockLikelihood::Split BlockLikelihood::most_probable(const Look& look,
                                                      const std::vector<double>& log_amplitude) const {
  double most = -std::numeric_limits<double>::infinity();
  std::size_t best_k = 0, best_l = 0;
  Eigen::Index best = 0;
  for_each_cell(look, log_amplitude, [&](std::size_t k, std::size_t l, Eigen::Index cell, double log_p) {
    if (log_p > most) most = log_p, best_k = k, best_l = l, best = cell;
  });
  const Rotation& one = rotation_[best_k][best_l];
  return {one.back * shrunk(one, best).cwiseProduct(look.rotated[best_k][best_l].col(0)),
          scales_.scale[static_cast<std::size_t>(best) % scales_.scale.size()], noise_[best_k].correlation,
          priors_.length[best_l]};
}

namespace {

/// Widths of the heights of steps, from small beside the unit to what one at the end of a run has, with their
/// prior.
struct Widths {
  std::vector<double> precision, log_prior;
  double log_smaller_than_all;

  Widths(double unit, double typical)
      : log_smaller_than_all(log_smaller(0.04 * unit / std::sqrt(2) / typical)) {
    constexpr int widths = 8;
    for (int k = 0; k < widths; ++k) {
      const double width = 0.04 * unit * std::exp2(k);
      precision.push_back(1 / (width * width));
      log_prior.push_back(log_size_prior(width / typical));
    }
  }
  /// Log Bayes factor of a step over none.
  [[nodiscard]] double gain(double along, double information) const {
    std::vector<double> terms{log_smaller_than_all};
    for (std::size_t k = 0; k < precision.size(); ++k)
      terms.push_back(log_prior[k] + 0.5 * along * along / (information + precision[k]) -
                      0.5 * std::log1p(information / precision[k]));
    return log_sum(terms);
  }
};

}  // namespace

VectorXd BlockLikelihood::log_steps(const VectorXd& residual, const std::vector<Eigen::Index>& end,
                                    double typical) const {
  const auto number = [&](Eigen::Index value) {  // of the first value from there on that is kept
    return std::lower_bound(kept_.begin(), kept_.end(), value) - kept_.begin();
  };
  const Look here = look(residual);
  const Widths widths(unit_, typical);
  const double lengths = std::log(static_cast<double>(priors_.length.size()));
  const auto scales = static_cast<Eigen::Index>(scales_.scale.size()), values = residual.size();
  MatrixXd parts(static_cast<Eigen::Index>(noise_.size()) * scales, values);
  for (std::size_t k = 0; k < noise_.size(); ++k) {
    // Sums over all later values of what a step that has begun is whitened to.
    const VectorXd white = whiten(noise_[k], kept(residual)), step = noise_[k].own - noise_[k].before;
    VectorXd product = VectorXd::Zero(white.size() + 1), square = product;
    for (Eigen::Index i = white.size(); i-- > 0;) {
      product(i) = product(i + 1) + step(i) * white(i);
      square(i) = square(i + 1) + step(i) * step(i);
    }
    for (Eigen::Index v = 0; v < values; ++v) {
      const Eigen::Index from = number(v), to = number(end[static_cast<std::size_t>(v)]);
      double along = 0, length = 0;
      if (from < to) {
        along = noise_[k].own(from) * white(from) + product(from + 1) - product(to);
        length = std::pow(noise_[k].own(from), 2) + square(from + 1) - square(to);
      }
      for (Eigen::Index s = 0; s < scales; ++s) {
        const double precision = inverse_square_(s);
        parts(static_cast<Eigen::Index>(k) * scales + s, v) =
            here.log_cell[k].front()(s) + lengths - here.log_by_amplitude.front() +
            widths.gain(along * precision, length * precision);
      }
    }
  }
  VectorXd result(values);
  for (Eigen::Index v = 0; v < values; ++v) result(v) = log_sum(VectorXd(parts.col(v)));
  return result;
}

void BlockLikelihood::prune(const VectorXd& residual) {
  const double negligible = std::log(1e-3);
  const Look here = look(residual);
  VectorXd mass(static_cast<Eigen::Index>(noise_.size()));
  for (std::size_t k = 0; k < noise_.size(); ++k) {
    VectorXd parts(static_cast<Eigen::Index>(rotation_[k].size()));
    for (std::size_t l = 0; l < rotation_[k].size(); ++l)
      parts(static_cast<Eigen::Index>(l)) = log_sum(here.log_cell[k][l]);
    mass(static_cast<Eigen::Index>(k)) = log_sum(parts);
  }
  const double most = mass.maxCoeff();
  for (std::size_t k = noise_.size(); k-- > 0;) {
    if (mass(static_cast<Eigen::Index>(k)) > most + negligible) continue;
    noise_.erase(noise_.begin() + static_cast<std::ptrdiff_t>(k));
    rotation_.erase(rotation_.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

}  // namespace plumbline::diagnose
