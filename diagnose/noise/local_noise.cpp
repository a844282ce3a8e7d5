#include "diagnose/noise/local_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnose/noise/residual_differences.hpp"

namespace plumbline::diagnose {
namespace {

/// A step of a gap counts no more than the noise of a very rough place would.
constexpr double largest_square = 25;

std::array<double, channel_names> usual_squares(const Measurements& measurements,
                                                const std::vector<double>& residual) {
  std::array<double, channel_names> usual{};
  for (std::size_t c = 0; c < channel_names; ++c)
    usual[c] = robust_variance(second_differences(series_named(measurements, all_names[c]), residual, 1));
  return usual;
}

/// Squares of the second differences of a series about its values, but for the first and last one, over the
/// usual ones.
std::vector<double> squares_of(const Series& series, const std::vector<double>& residual, double usual) {
  std::vector<double> squares(series.readings.size(), 1.0);
  for (std::size_t i = 1; usual > 0 && i + 1 < squares.size(); ++i) {
    const double* const value = residual.data() + series.first + i;
    squares[i] = std::min(std::pow(value[-1] - 2 * value[0] + value[1], 2) / usual, largest_square);
  }
  return squares;
}

/// Over the channels that are read with a series, itself among them.
struct Together {
  std::vector<double> squares;  ///< their sum, by value
  double channels = 0;
};

Together read_with(const Series& series, const std::vector<Series>& all,
                   const std::vector<std::vector<double>>& squares) {
  Together sum{std::vector<double>(series.readings.size(), 0.0)};
  for (std::size_t other = 0; other < all.size(); ++other) {
    const Series& one = all[other];
    if (one.run != series.run || one.channel.sensor() != series.channel.sensor() ||
        one.readings != series.readings)
      continue;
    sum.channels += 1;
    for (std::size_t i = 0; i < sum.squares.size(); ++i) sum.squares[i] += squares[other][i];
  }
  return sum;
}

}  // namespace

std::vector<double> local_noise(const Measurements& measurements, const std::vector<double>& residual) {
  constexpr std::size_t around = 4;
  constexpr double drawn = 4;  // so many differences of the usual size are added
  const std::vector<Series>& all = measurements.series();
  const std::array<double, channel_names> usual = usual_squares(measurements, residual);
  std::vector<std::vector<double>> squares;
  for (const Series& series : all)
    squares.push_back(squares_of(series, residual, usual[static_cast<std::size_t>(series.channel.name)]));
  std::vector<double> local(measurements.size(), 1.0);
  for (const Series& series : all) {
    const Together here = read_with(series, all, squares);
    const std::size_t count = here.squares.size();
    for (std::size_t i = 0; i < count; ++i) {
      double sum = drawn, number = drawn;
      for (std::size_t k = std::max(i, around + 1) - around; k + 1 < std::min(count, i + around + 2); ++k)
        sum += here.squares[k], number += here.channels;
      local[series.first + i] = std::sqrt(std::max(1.0, sum / number));
    }
  }
  return local;
}

}  // namespace plumbline::diagnose
