#include "diagnose/inference/fitted_volume.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "diagnose/inference/prior.hpp"
#include "diagnose/inference/size_prior.hpp"
#include "diagnose/log_sum.hpp"

namespace plumbline::diagnose {
namespace {

/// A fit as Laplace's method sees it: what its parameters are in the prior, and what the readings say of
/// them.
class FittedVolume {
 public:
  FittedVolume(const Study& study, const Hypothesis& h) : h_(h), ranges_(study.ranges(h.candidate)) {
    for (const EffectAt& at : h.candidate.effects) {
      for (std::size_t i = 0; i < study.ranges(at).size(); ++i) place(effects_, ranges_[size_of_.size()]);
      ++effects_;
    }
    marginalise();
  }

  /// Logarithm of the share of the prior's volume that the readings leave, the sizes of effects summed out.
  [[nodiscard]] double log() const {
    std::vector<double> terms;
    for_sizes([&](const std::vector<double>&, double log_term) { terms.push_back(log_term); });
    return log_fixed_ + log_sum(terms);
  }

  /// Shares of this volume by the effects that are seen, a flag each.
  [[nodiscard]] std::map<std::vector<bool>, double> shares() const {
    std::map<std::vector<bool>, std::vector<double>> terms;
    std::vector<double> all;
    for_sizes([&](const std::vector<double>& size, double log_term) {
      terms[seen(size)].push_back(log_term), all.push_back(log_term);
    });
    std::map<std::vector<bool>, double> shares;
    for (const auto& [flags, own] : terms) shares[flags] = std::exp(log_sum(own) - log_sum(all));
    return shares;
  }

 private:
  /// Sorts a parameter: of a size that is summed out, or with a prior of its own; inside its bounds, or at
  /// one.
  void place(std::size_t effect, const ParameterRange& range) {
    const std::size_t p = size_of_.size();
    const auto k = static_cast<Eigen::Index>(p);
    size_of_.push_back(effect);
    has_size_.resize(effect + 1, false);
    const bool size = is_size(range);
    if (h_.at_bound[p]) {
      const double log_slope = std::log(std::abs(h_.look.gradient(k)));
      if (size)
        bounded_.push_back(p), has_size_[effect] = true;
      else
        log_fixed_ -= log_sum({0.0, log_slope - ParameterPrior(range).log_density(h_.parameters[p])});
      return;
    }
    if (!(h_.look.information(k, k) > 0)) return;  // the readings do not tell it
    if (size) {
      sized_.push_back(k), has_size_[effect] = true;
      return;
    }
    const ParameterPrior prior(range);
    fixed_.push_back(k), width_.push_back(prior.width());
    log_fixed_ +=
        prior.log_density(h_.parameters[p]) + std::log(width_.back() * std::sqrt(2 * std::numbers::pi));
  }

  /// Calls with all sizes of the effects, and the logarithm of their prior times what the readings leave.
  template <class Take>
  void for_sizes(const Take& take) const {
    std::vector<double> size(effects_, 0.0);
    const std::function<void(std::size_t, double)> from = [&](std::size_t effect, double log_prior) {
      if (effect == effects_) {
        take(size, log_prior + log_at(size));
      } else if (!has_size_[effect]) {
        from(effect + 1, log_prior);
      } else {
        for (const GridSize& one : size_grid()) {
          size[effect] = one.size;
          from(effect + 1, log_prior + one.log_prior);
        }
      }
    };
    from(0, 0);
  }

  /// The effects with which the readings are more probable than with next to nothing of them.
  [[nodiscard]] std::vector<bool> seen(const std::vector<double>& size) const {
    constexpr double next_to_nothing = 1e-3;
    std::vector<bool> flags(effects_, true);
    for (std::size_t effect = 0; effect < effects_; ++effect) {
      if (!has_size_[effect]) continue;
      std::vector<double> without = size;
      without[effect] *= next_to_nothing;
      flags[effect] = log_at(size) > log_at(without);
    }
    return flags;
  }

  /// What the readings say of sizes where the other parameters are summed out.
  void marginalise() {
    const MatrixXd& all = h_.look.information;
    information_ = all(sized_, sized_);
    at_ = VectorXd(static_cast<Eigen::Index>(sized_.size()));
    for (Eigen::Index i = 0; i < at_.size(); ++i)
      at_(i) = h_.parameters[static_cast<std::size_t>(sized_[static_cast<std::size_t>(i)])];
    if (fixed_.empty()) return;
    const VectorXd unit = Eigen::Map<const VectorXd>(width_.data(), static_cast<Eigen::Index>(width_.size()));
    const Eigen::LLT<MatrixXd> factor(
        MatrixXd(MatrixXd::Identity(unit.size(), unit.size()) +
                 unit.asDiagonal() * MatrixXd(all(fixed_, fixed_)) * unit.asDiagonal()));
    log_fixed_ -= MatrixXd(factor.matrixL()).diagonal().array().log().sum();
    const MatrixXd cross = unit.asDiagonal() * MatrixXd(all(fixed_, sized_));
    information_ -= cross.transpose() * factor.solve(cross);
  }

  /// Logarithm of the volume of the parameters with sizes, Gaussian about zero with these sizes of effects.
  [[nodiscard]] double log_at(const std::vector<double>& size) const {
    double sum = 0;
    for (const std::size_t p : bounded_) {
      const double width = size[size_of_[p]] * ranges_[p].scale;
      sum -= log_sum({0.0, std::log(std::abs(h_.look.gradient(static_cast<Eigen::Index>(p)))) -
                               log_normal(h_.parameters[p] / width) + std::log(width / sides(p))});
    }
    if (sized_.empty()) return sum;
    VectorXd width(at_.size());
    for (Eigen::Index i = 0; i < at_.size(); ++i)
      width(i) = size[size_of_[number(i)]] * ranges_[number(i)].scale;
    const Eigen::LLT<MatrixXd> factor(MatrixXd(MatrixXd::Identity(at_.size(), at_.size()) +
                                               width.asDiagonal() * information_ * width.asDiagonal()));
    const VectorXd mean = factor.solve(width.cwiseProduct(information_ * at_));  // in widths
    sum -= at_.cwiseQuotient(width).dot(mean) / 2 + MatrixXd(factor.matrixL()).diagonal().array().log().sum();
    const MatrixXd inverse = factor.solve(MatrixXd::Identity(at_.size(), at_.size()));
    for (Eigen::Index i = 0; i < at_.size(); ++i)
      if (sides(number(i)) > 1) sum += std::log(std::erfc(-mean(i) / std::sqrt(2 * inverse(i, i))));
    return sum;
  }

  [[nodiscard]] std::size_t number(Eigen::Index i) const {
    return static_cast<std::size_t>(sized_[static_cast<std::size_t>(i)]);
  }
  [[nodiscard]] double sides(std::size_t p) const { return ranges_[p].low < 0 ? 1 : 2; }
  static double log_normal(double z) { return -z * z / 2 - std::log(2 * std::numbers::pi) / 2; }
  static bool is_size(const ParameterRange& range) {
    return range.tolerance == 0 && (range.may_be_nothing() || range.coordinate == Coordinate::reciprocal);
  }

  const Hypothesis& h_;
  std::vector<ParameterRange> ranges_;
  std::size_t effects_ = 0;
  std::vector<std::size_t> size_of_;  ///< by parameter: its effect
  std::vector<char> has_size_;        ///< by effect
  std::vector<Eigen::Index> sized_, fixed_;
  std::vector<std::size_t> bounded_;
  std::vector<double> width_;  ///< of those with a prior of their own
  double log_fixed_ = 0;
  MatrixXd information_;
  VectorXd at_;
};

}  // namespace

double log_volume(const Study& study, const Hypothesis& hypothesis) {
  return FittedVolume(study, hypothesis).log();
}

std::vector<SeenEffects> seen_effects(const Study& study, const Hypothesis& hypothesis) {
  std::vector<SeenEffects> result;
  for (const auto& [flags, share] : FittedVolume(study, hypothesis).shares()) {
    Candidate seen;
    for (std::size_t i = 0; i < flags.size(); ++i)
      if (flags[i]) seen.effects.push_back(hypothesis.candidate.effects[i]);
    result.push_back({seen.effects.empty() ? hypothesis.candidate : seen, share});
  }
  return result;
}

}  // namespace plumbline::diagnose
