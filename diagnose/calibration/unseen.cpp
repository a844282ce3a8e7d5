#include "diagnose/calibration/unseen.hpp"

#include <cmath>

#include "diagnose/inference/least_squares.hpp"

namespace plumbline::diagnose {
namespace {

constexpr std::size_t folds = 5;

/// Whole runs are held out where there are as many as folds, else readings.
std::size_t fold_of(const Measurements& measurements, std::size_t value) {
  const auto& place = measurements.places()[value];
  const std::size_t runs = measurements.places().back().run + 1;
  return (runs >= folds ? place.run : place.reading) % folds;
}

/// Sums of squares by sensor.
struct Sums {
  double places = 0, place_count = 0, turns = 0, turn_count = 0;

  [[nodiscard]] LeftOfPoses rms() const {
    constexpr double axes = 3;  // of a distance
    return {place_count > 0 ? std::sqrt(axes * places / place_count) : 0,
            turn_count > 0 ? std::sqrt(axes * turns / turn_count) : 0};
  }
};

/// \param coefficients  of all columns, from what a fold sees: its regression
template <class Coefficients>
LeftOfPoses tested(const UnseenTest& test, Coefficients coefficients) {
  const Measurements& measurements = test.measurements;
  Sums sums;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    std::vector<Eigen::Index> seen, held;
    for (std::size_t i = 0; i < measurements.size(); ++i)
      (fold_of(measurements, i) == fold ? held : seen).push_back(static_cast<Eigen::Index>(i));
    if (seen.size() <= static_cast<std::size_t>(test.frames.cols())) continue;
    const MatrixXd frames = test.frames(seen, Eigen::all), columns = test.effects.columns(seen, Eigen::all);
    const VectorXd values = test.values(seen);
    const VectorXd found = coefficients(GroupedRegression(frames, columns, test.effects.groups, values));
    const VectorXd placed = LeastSquares(frames).solve(VectorXd(values - columns * found));
    VectorXd left = VectorXd(test.values(held)) - test.effects.columns(held, Eigen::all) * found;
    if (test.frames.cols() > 0) left -= test.frames(held, Eigen::all) * placed;
    for (std::size_t h = 0; h < held.size(); ++h) {
      const double square = std::pow(left(static_cast<Eigen::Index>(h)) * measurements.sigma()(held[h]), 2);
      for (const Block& block : measurements.blocks()) {
        if (held[h] < block.first || held[h] >= block.first + block.count) continue;
        if (block.channel.name == Channel::Name::place) sums.places += square, sums.place_count += 1;
        if (block.channel.name == Channel::Name::turn) sums.turns += square, sums.turn_count += 1;
      }
    }
  }
  return sums.rms();
}

}  // namespace

LeftOfPoses UnseenTest::nominal() const {
  return tested(*this,
                [&](const GroupedRegression&) -> VectorXd { return VectorXd::Zero(effects.columns.cols()); });
}

LeftOfPoses UnseenTest::least_squares() const {
  constexpr double free = 10;
  return tested(*this, [&](const GroupedRegression& regression) {
    return regression.tied(effects.always(), free).mean;
  });
}

LeftOfPoses UnseenTest::corrected() const {
  return tested(*this, [&](const GroupedRegression& regression) {
    return regression.extended(effects.always(), effects.offered()).mean;
  });
}

}  // namespace plumbline::diagnose
