#pragma once
/// \file
/// A parameter of an effect: its coordinate, typical size and bounds.

#include <string_view>

namespace plumbline::diagnose {

/// The coordinate in which a parameter is fitted: its value, its logarithm (time constants), its reciprocal
/// (rigidities, so that zero is the nominal model), or the logarithm of one plus it (errors of what is
/// positive and may be wrong by orders of magnitude, so that zero is the nominal model too).
enum class Coordinate { plain, logarithm, reciprocal, growth };

/// Conversions between the fitted coordinate and the catalogue's units.
double catalogue_value(Coordinate coordinate, double fitted);
double fitted_value(Coordinate coordinate, double catalogue);

/// A parameter of an effect, in one experiment. `scale`, `low` and `high` are in the fitted coordinate.
struct ParameterRange {
  std::string_view name;
  std::string_view unit;  ///< "N m", or "ratio" for one
  Coordinate coordinate;
  double scale;      ///< typical size of the effect on a bench; the difference step is a share of it
  double low, high;  ///< physical bounds
  /// Standard deviation of a Gaussian prior about zero, for a manufacturing tolerance; 0 for other
  /// parameters.
  double tolerance = 0;
  /// Whether it is as probable everywhere between its bounds; then no value of its own is the nominal model.
  bool anywhere = false;

  /// Whether zero is the nominal model.
  [[nodiscard]] bool may_be_nothing() const {
    return coordinate == Coordinate::growth || (coordinate == Coordinate::plain && low <= 0 && !anywhere);
  }
  /// Whether the parameter is a threshold, such as the angle of a stop: bounded away from zero.
  [[nodiscard]] bool is_onset() const { return coordinate == Coordinate::plain && low > 0 && !anywhere; }
  /// The same between other bounds, where the law itself has them.
  [[nodiscard]] ParameterRange within(double least, double most) const {
    ParameterRange other = *this;
    other.low = least, other.high = most;
    return other;
  }
  /// The same where it cannot be negative.
  [[nodiscard]] ParameterRange positive() const { return within(0, high); }
};

}  // namespace plumbline::diagnose
