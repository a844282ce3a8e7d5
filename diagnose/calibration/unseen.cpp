#include "diagnose/calibration/unseen.hpp"

#include <algorithm>
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

/// Number of components that are read together; zero for what shows no pose.
double components(Channel::Name name) {
  if (name == Channel::Name::place || name == Channel::Name::turn) return 3;
  const auto kind = std::ranges::find(arm_sensor_kinds(), name, &ArmSensorKind::reads);
  return kind == arm_sensor_kinds().end() ? 0 : static_cast<double>(kind->numbers);
}

/// Sums of squares by kind of channel.
struct Sums {
  std::array<double, channel_names> squares{}, count{};

  void add(Channel::Name name, double square) {
    squares.at(static_cast<std::size_t>(name)) += square, count.at(static_cast<std::size_t>(name)) += 1;
  }
  [[nodiscard]] LeftOfPoses rms() const {
    LeftOfPoses all{};
    for (const ChannelKind& kind : channel_kinds)
      if (const auto k = static_cast<std::size_t>(kind.name); count.at(k) > 0)
        all.at(k) = std::sqrt(components(kind.name) * squares.at(k) / count.at(k));
    return all;
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
      for (const Block& block : measurements.blocks())
        if (held[h] >= block.first && held[h] < block.first + block.count)
          sums.add(block.channel.name, square);
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
