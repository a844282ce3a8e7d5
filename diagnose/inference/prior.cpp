#include "diagnose/inference/prior.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "diagnose/log_sum.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

/// Share of gaps with so many causes; more than three are not looked for.
double share_of_count(std::size_t causes) {
  return causes == 0 ? 1 : priors::causes[std::min<std::size_t>(causes, priors::causes.size()) - 1];
}

double commonness(const Effect& effect) {
  return effect.nested.empty() ? 1 : priors::refinement;
}

double share_of_order(const Effect& effect) {
  if (!effect.orders) return 1;
  double own = 0, all = 0, common = 1;
  for (const Effect* row : effect.orders()) {
    if (row == &effect) own = common;
    all += common;
    common *= priors::one_more_element;
  }
  return own / all;
}

/// A number that is stated of the device or of a sensor, and may be a little wrong either way, on every
/// bench.
bool is_stated_number(const Study& study, const EffectAt& at) {
  const std::vector<ParameterRange> ranges = study.ranges(at);
  return ranges.size() == 1 && ranges.front().may_be_nothing() && ranges.front().low < 0;
}

/// What may act on a bench.
struct Possible {
  std::vector<EffectAt> effects;  ///< with those of time where there is no clock
  double all = 0;                 ///< rows, by how common they are
  double stated_numbers = 0;      ///< effects that are

  explicit Possible(const Study& study) : effects(possible_effects(study)) {
    const std::vector<EffectAt> untimed = untimed_effects(study);
    effects.insert(effects.end(), untimed.begin(), untimed.end());
    const Effect* last = nullptr;
    for (const EffectAt& at : effects) {
      if (at.effect != last) all += commonness(*at.effect);
      last = at.effect;
      stated_numbers += is_stated_number(study, at);
    }
  }
  [[nodiscard]] double places(const EffectAt& at) const {
    if (at.joint == 0) return 1;
    return static_cast<double>(
        std::max<std::ptrdiff_t>(1, std::count_if(effects.begin(), effects.end(), [&](const EffectAt& one) {
                                   return one.effect->at_joint && one.effect->id == at.effect->id;
                                 })));
  }
  /// Logarithm of the probability that an effect is the cause, where it is one of the catalogue.
  [[nodiscard]] double log_share(const EffectAt& at) const {
    return std::log(commonness(*at.effect) * share_of_order(*at.effect) / (all * places(at)));
  }
};

/// Log prior of effects of the catalogue that act together: independently drawn ones, or one of them and
/// numbers that are wrong beside it.
double log_prior_of(const Study& study, const Possible& possible, const std::vector<EffectAt>& effects) {
  double together = std::log(share_of_count(effects.size()));
  std::vector<double> terms;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    together += possible.log_share(effects[i]) + std::log(static_cast<double>(i + 1));  // in any order
    double beside = std::log(share_of_count(1)) + possible.log_share(effects[i]);
    for (std::size_t k = 0; k < effects.size(); ++k)
      if (k != i)
        beside += is_stated_number(study, effects[k])
                      ? std::log(priors::wrong_beside / std::max(1.0, possible.stated_numbers))
                      : -std::numeric_limits<double>::infinity();
    if (effects.size() > 1) terms.push_back(beside);
  }
  terms.push_back(together);
  return log_sum(terms);
}

}  // namespace

double log_prior(const Study& study, const Candidate& candidate) {
  const Possible possible(study);
  const bool tolerances = candidate.has_all_tolerances();
  std::vector<EffectAt> listed;
  double log_p = 0;
  for (const EffectAt& at : candidate.effects) {
    if (candidate.has_as_tolerance(at)) continue;
    if (at.effect->outside)  // any joint, any of two sizes
      log_p += std::log(priors::outside / (2 * static_cast<double>(study.scales().link_length.size())));
    else
      listed.push_back(at);
  }
  if (tolerances && candidate.count() == 1) return std::log(share_of_count(1) / possible.all);
  log_p += std::log(tolerances ? priors::tolerances_show : 1 - priors::tolerances_show);
  return listed.empty() ? log_p : log_p + log_prior_of(study, possible, listed);
}

bool affordable(const Study& study, const Candidate& candidate) {
  constexpr std::size_t most = 60;
  std::size_t free = 0, held = 0;
  for (const ParameterRange& range : study.ranges(candidate)) ++(range.tolerance > 0 ? held : free);
  return 3 * (free + std::min<std::size_t>(held, 1)) <= study.measurements().size() && free + held <= most;
}

double untested_share(const Study& study) {
  double share = 0;
  for (const EffectAt& at : possible_effects(study))
    if (const Candidate alone{{at}}; !affordable(study, alone)) share += std::exp(log_prior(study, alone));
  return share;
}

ParameterPrior::ParameterPrior(const ParameterRange& range) {
  const double sides = range.low < 0 ? 1 : 2;
  if (range.tolerance > 0) {
    shape_ = Shape::gaussian;
    scale_ = range.tolerance;
    largest_ = sides / (scale_ * std::sqrt(2 * std::numbers::pi));
  } else if (range.may_be_nothing() || range.is_onset() || range.coordinate == Coordinate::reciprocal) {
    shape_ = Shape::cauchy;
    scale_ = range.scale;
    largest_ = sides / (std::numbers::pi * scale_);
  } else {
    shape_ = Shape::uniform;
    scale_ = range.high - range.low;
    largest_ = 1 / scale_;
  }
}

double ParameterPrior::log_density(double value) const {
  const double square = std::pow(value / scale_, 2);
  if (shape_ == Shape::gaussian) return std::log(largest_) - square / 2;
  return std::log(largest_) - (shape_ == Shape::cauchy ? std::log1p(square) : 0);
}

double ParameterPrior::curvature(double value) const {
  if (shape_ == Shape::gaussian) return 1 / (scale_ * scale_);
  return shape_ == Shape::cauchy ? 2 / (scale_ * scale_ + value * value) : 0;
}

double ParameterPrior::width() const {
  return 1 / (largest_ * std::sqrt(2 * std::numbers::pi));
}

}  // namespace plumbline::diagnose
