#include "diagnose/design/comparison.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "diagnose/design/separation.hpp"
#include "diagnose/inference/start.hpp"
#include "diagnose/inference/white_noise_fit.hpp"

namespace plumbline::diagnose {
namespace {

/// The predicted readings of an effect at given parameters, in standard deviations, and their derivatives.
struct Tangent {
  VectorXd read;
  MatrixXd slope;
};

std::vector<Tangent> tangents(const Study& study, const Instance& typical) {
  std::vector<std::vector<double>> places = initial_guesses(study, typical.candidate).points;
  places.insert(places.begin(), typical.parameters);
  const Measurements& measurements = study.measurements();
  std::vector<Tangent> all;
  for (const std::vector<double>& place : places) {
    const Prediction predicted = predict(study, typical.candidate, place, true);
    if (!predicted.reached) continue;
    Tangent one{measurements.in_sigmas(predicted.runs), {}};
    one.slope.resize(one.read.size(), static_cast<Eigen::Index>(predicted.sensitivity.size()));
    for (std::size_t p = 0; p < predicted.sensitivity.size(); ++p)
      one.slope.col(static_cast<Eigen::Index>(p)) = measurements.in_sigmas(predicted.sensitivity[p]);
    all.push_back(std::move(one));
  }
  return all;
}

/// The closest reproduction, to first order.
/// \param truth  true readings
LinearisedAlternative nearest(const VectorXd& truth, const std::vector<Tangent>& alternative) {
  LinearisedAlternative best;
  double least = std::numeric_limits<double>::infinity();
  for (const Tangent& one : alternative) {
    const LinearisedAlternative rows{truth - one.read, -one.slope};
    const double left = separation(rows);
    if (left < least) {
      least = left;
      best = rows;
    }
  }
  return best;
}

Contrast by_run(const Study& study, const LinearisedAlternative& all) {
  Contrast contrast;
  for (std::size_t r = 0; r < study.experiment().runs.size(); ++r) {
    std::vector<std::size_t> rows;
    for (const Series& series : study.measurements().series())
      for (std::size_t i = 0; series.run == r && i < series.readings.size(); ++i)
        rows.push_back(series.first + i);
    contrast.push_back(reduced({all.difference(rows), all.slope(rows, Eigen::all)}));
  }
  return contrast;
}

/// The same by a fit to the noise-free readings of the truth.
std::optional<LinearisedAlternative> fitted(const Study& truth, const EffectAt& alternative) {
  const Hypothesis found = fit_in_white_noise(truth, {{alternative}});
  if (!found.converged) return std::nullopt;
  return LinearisedAlternative{found.residual, free_jacobian(found)};
}

}  // namespace

Comparison::Comparison(const DesignSpace& space, const std::function<void(double)>& progress)
    : space_(space) {
  // A tangent that leaves more than this fraction of the squared gap does not lead to an exact reproduction.
  constexpr double may_come_near = 0.3;
  const Study study(space.bench);
  const std::size_t count = space.effects.size();
  std::vector<std::vector<Tangent>> tangent;
  for (const Instance& effect : space.effects) tangent.push_back(tangents(study, effect));
  const VectorXd nominal = study.measurements().in_sigmas(study.nominal().runs);
  for (const std::vector<Tangent>& of : tangent) {
    const VectorXd difference = of.front().read - nominal;
    gap_.push_back(by_run(study, {difference, MatrixXd(difference.size(), 0)}));
  }
  contrast_.resize(count * count);
  for (std::size_t truth = 0; truth < count; ++truth) {
    if (progress) progress(static_cast<double>(truth) / static_cast<double>(count));
    const VectorXd& read = tangent[truth].front().read;
    const double whole = (read - nominal).squaredNorm();
    if (whole / 2 <= told_apart) continue;  // undetectable
    const Instance& own = space.effects[truth];
    const Study asked(measured_as(space.bench, predict(study, own.candidate, own.parameters)));
    for (std::size_t other = 0; other < count; ++other) {
      if (!competes(truth, other)) continue;
      LinearisedAlternative rows = nearest(read, tangent[other]);
      if (separation(rows) < may_come_near * whole)
        if (const std::optional<LinearisedAlternative> exact = fitted(asked, effect(other))) rows = *exact;
      contrast_[truth * count + other] = by_run(study, rows);
    }
  }
}

bool Comparison::competes(std::size_t truth, std::size_t alternative) const {
  const std::vector<std::string_view>& nested = effect(alternative).effect->nested;
  return truth != alternative &&
         std::find(nested.begin(), nested.end(), effect(truth).effect->id) == nested.end() &&
         space_.effects[alternative].parameters.size() <= space_.effects[truth].parameters.size() + 1;
}

double Comparison::distinguishability(std::size_t i, std::size_t j,
                                      const std::vector<std::size_t>& runs) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Contrast* one : {&contrast(i, j), &contrast(j, i)})
    if (!one->empty()) least = std::min(least, expected_log_likelihood_ratio(*one, runs));
  return least;
}

std::vector<Contrast> Comparison::between(std::size_t i, std::size_t j) const {
  std::vector<Contrast> all;
  for (const Contrast* one : {&contrast(i, j), &contrast(j, i)})
    if (!one->empty()) all.push_back(*one);
  return all;
}

}  // namespace plumbline::diagnose
