#include "diagnose/inference/prior.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

double places_of(const Study& study, const EffectAt& at) {
  if (at.joint == 0) return 1;
  double places = 0;
  for (const EffectAt& one : possible_effects(study))
    places += one.effect->at_joint && one.effect->id == at.effect->id;
  return std::max(1.0, places);
}

}  // namespace

double log_prior(const Study& study, const Candidate& candidate) {
  const bool tolerances = candidate.has_all_tolerances();
  const std::size_t others = candidate.count() - (tolerances ? 1 : 0);
  double log_p = std::log(share_of_count(std::max<std::size_t>(others, tolerances ? 1 : 0)));
  double all = 0;
  for (const Effect* one : study.effects()) all += commonness(*one);
  for (std::size_t i = 0; i < others; ++i) log_p += std::log(static_cast<double>(i + 1));  // in any order
  if (tolerances && others == 0) log_p -= std::log(all);
  if (others > 0) log_p += std::log(tolerances ? priors::tolerances_show : 1 - priors::tolerances_show);
  for (const EffectAt& at : candidate.effects) {
    if (candidate.has_as_tolerance(at)) continue;
    if (at.effect->outside) {
      // any joint, any size
      log_p += std::log(priors::outside / (2 * static_cast<double>(study.scales().link_length.size())));
      continue;
    }
    log_p += std::log(commonness(*at.effect) * share_of_order(*at.effect) / (all * places_of(study, at)));
  }
  return log_p;
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
