#include "diagnose/design/comparison.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "diagnose/beliefs.hpp"
#include "diagnose/inference/fit.hpp"
#include "diagnose/decision/rival.hpp"
#include "diagnose/inference/start.hpp"

namespace plumbline::diagnose {
namespace {

/// An effect near one set of its parameters: what is read, in standard deviations, and its derivatives.
struct Tangent {
  Eigen::VectorXd read;
  Eigen::MatrixXd slope;
};

Eigen::VectorXd in_sigmas(const Study& study, const std::vector<Trace>& traces) {
  const std::vector<double> values = study.measurements().in_sigmas(traces);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::vector<Tangent> tangents(const Study& study, const Instance& sizeable) {
  std::vector<std::vector<double>> places = starts(study, sizeable.candidate).from;
  places.insert(places.begin(), sizeable.parameters);
  std::vector<Tangent> all;
  for (const std::vector<double>& place : places) {
    const Prediction predicted = predict(study, sizeable.candidate, place, true);
    if (!predicted.reached) continue;
    Tangent one{in_sigmas(study, predicted.runs), {}};
    one.slope.resize(one.read.size(), static_cast<Eigen::Index>(predicted.sensitivity.size()));
    for (std::size_t p = 0; p < predicted.sensitivity.size(); ++p)
      one.slope.col(static_cast<Eigen::Index>(p)) = in_sigmas(study, predicted.sensitivity[p]);
    all.push_back(std::move(one));
  }
  return all;
}

/// The tangent by which the imitator comes nearest. \param truth  what is read
Imitation nearest(const Eigen::VectorXd& truth, const std::vector<Tangent>& imitator) {
  Imitation best;
  double least = std::numeric_limits<double>::infinity();
  for (const Tangent& one : imitator) {
    const Imitation rows{truth - one.read, -one.slope};
    const double left = separation(rows);
    if (left < least) {
      least = left;
      best = rows;
    }
  }
  return best;
}

Contrast by_run(const Study& study, const Imitation& all) {
  Contrast contrast;
  for (std::size_t r = 0; r < study.experiment().runs.size(); ++r) {
    std::vector<std::size_t> rows;
    for (const Series& series : study.measurements().series())
      for (std::size_t i = 0; series.run == r && i < series.readings.size(); ++i)
        rows.push_back(series.first + i);
    contrast.push_back(condensed({all.difference(rows), all.slope(rows, Eigen::all)}));
  }
  return contrast;
}

/// The same by a fit to what the truth gives without noise. Least squares, plainly: nothing there is an
/// outlier.
std::optional<Imitation> fitted(const Study& truth, const EffectAt& imitator) {
  FitSettings settings;
  settings.outlier_bound = std::numeric_limits<double>::max();
  const Fit found = fit(truth, {{imitator}}, settings);
  if (!found.converged) return std::nullopt;
  Fit exact;
  exact.whitened.assign(found.whitened.size(), 0.0);
  return imitation(exact, found);
}

}  // namespace

Comparison::Comparison(const Rehearsal& rehearsal, const std::function<void(double)>& progress)
    : rehearsal_(rehearsal) {
  // A tangent that leaves more than this share of the squared gap leads to no fit that leaves nothing.
  constexpr double may_come_near = 0.3;
  const Study study(rehearsal.bench);
  const std::size_t count = rehearsal.effects.size();
  std::vector<std::vector<Tangent>> tangent;
  for (const Instance& effect : rehearsal.effects) tangent.push_back(tangents(study, effect));
  const Eigen::VectorXd nominal = in_sigmas(study, study.nominal().runs);
  for (const std::vector<Tangent>& of : tangent) {
    const Eigen::VectorXd difference = of.front().read - nominal;
    gap_.push_back(by_run(study, {difference, Eigen::MatrixXd(difference.size(), 0)}));
  }
  beside_.resize(count * count);
  for (std::size_t truth = 0; truth < count; ++truth) {
    if (progress) progress(static_cast<double>(truth) / static_cast<double>(count));
    const Eigen::VectorXd& read = tangent[truth].front().read;
    const double whole = (read - nominal).squaredNorm();
    if (whole / 2 <= beliefs::told_apart) continue;  // unseen
    const Instance& own = rehearsal.effects[truth];
    const Study asked(measured_as(rehearsal.bench, predict(study, own.candidate, own.parameters)));
    for (std::size_t other = 0; other < count; ++other) {
      if (!competes(truth, other)) continue;
      Imitation rows = nearest(read, tangent[other]);
      if (separation(rows) < may_come_near * whole)
        if (const std::optional<Imitation> exact = fitted(asked, effect(other))) rows = *exact;
      beside_[truth * count + other] = by_run(study, rows);
    }
  }
}

bool Comparison::competes(std::size_t truth, std::size_t imitator) const {
  return truth != imitator && !covers(effect(imitator), effect(truth)) &&
         rehearsal_.effects[imitator].parameters.size() <=
             rehearsal_.effects[truth].parameters.size() + spare_parameters;
}

double Comparison::apart(std::size_t i, std::size_t j, const std::vector<std::size_t>& runs) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Contrast* one : {&beside(i, j), &beside(j, i)})
    if (!one->empty()) least = std::min(least, lead(*one, runs));
  return least;
}

std::vector<Contrast> Comparison::between(std::size_t i, std::size_t j) const {
  std::vector<Contrast> all;
  for (const Contrast* one : {&beside(i, j), &beside(j, i)})
    if (!one->empty()) all.push_back(*one);
  return all;
}

}  // namespace plumbline::diagnose
