#pragma once
/// \file
/// From values to pixels, and the round numbers in between.

#include <string>
#include <vector>

namespace plumbline::page {

/// Maps a range of values to a range of pixels.
class Axis {
 public:
  /// A range of no extent is widened;
  /// \param signed_log  linear near zero, logarithmic beyond
  Axis(double low, double high, double first_pixel, double last_pixel, bool signed_log = false);

  [[nodiscard]] double pixel(double value) const;

  struct Tick {
    double pixel;
    std::string text;
  };
  /// Round values, about four of them.
  [[nodiscard]] std::vector<Tick> ticks() const;

 private:
  [[nodiscard]] double bent(double value) const;

  double low_, high_, first_, last_;
  bool signed_log_;
};

}  // namespace plumbline::page
