#include "diagnose/next/prior.hpp"

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

/// Shares of gaps with so many causes.
double share_of_count(std::size_t causes) {
  static const double three = env("THREE", 0.01);
  static const double shares[] = {1.0, 0.75, 0.20, three};
  return shares[std::min<std::size_t>(causes, 3)] * (causes > 3 ? 1e-3 : 1);
}
/// An effect with a plainer one as a special case is so much rarer; one more element, too.
constexpr double refinement = 0.1, one_more_element = 0.5;

double commonness(const Effect& effect) {
  return effect.nested.empty() ? 1 : refinement;
}

double share_of_order(const Effect& effect) {
  if (!effect.orders) return 1;
  double own = 0, all = 0, common = 1;
  for (const Effect* row : effect.orders()) {
    if (row == &effect) own = common;
    all += common;
    common *= one_more_element;
  }
  return own / all;
}

double places_of(const Study& study, const EffectAt& at) {
  if (at.joint == 0) return 1;
  double places = 0;
  for (const EffectAt& one : possible_effects(study)) places += one.effect->at_joint && one.effect->id == at.effect->id;
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
  static const double beside = env("TOL", 0.2);
  if (others > 0) log_p += std::log(tolerances ? beside : 1 - beside);
  for (const EffectAt& at : candidate.effects) {
    if (candidate.has_as_tolerance(at)) continue;
    if (at.effect->outside) {
      static const double outside = env("OUT", 0.1);
      log_p += std::log(outside / (2 * static_cast<double>(study.scales().link_length.size())));
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
  } else if (range.may_be_nothing() || range.coordinate == Coordinate::reciprocal) {
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

}  // namespace plumbline::diagnose::next
