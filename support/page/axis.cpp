#include "support/page/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::page {
namespace {

/// The power of ten times 1, 2 or 5 that divides the extent into about four.
double round_step(double extent) {
  const double rough = extent / 4;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double lead = rough / power;
  return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

std::string with_minus(std::string text) {
  if (text[0] == '-') text.replace(0, 1, "−");
  return text;
}

}  // namespace

Axis::Axis(double low, double high, double first_pixel, double last_pixel, bool signed_log)
    : low_(low), high_(high), first_(first_pixel), last_(last_pixel), signed_log_(signed_log) {
  const double least = 1e-9 * std::max({std::abs(low), std::abs(high), 1e-12});
  if (high_ - low_ < least)
    low_ -= std::max(least, std::abs(low) / 2), high_ += std::max(least, std::abs(low) / 2);
}

double Axis::bent(double value) const {
  return signed_log_ ? std::asinh(value / 2) : value;
}

double Axis::pixel(double value) const {
  return first_ + (bent(value) - bent(low_)) / (bent(high_) - bent(low_)) * (last_ - first_);
}

std::vector<Axis::Tick> Axis::ticks() const {
  std::vector<Tick> result;
  if (signed_log_) {
    // Thirds of decades up to a hundred, decades beyond.
    const double largest = std::max(std::abs(low_), std::abs(high_));
    for (const double size : {0.0, 3.0, 10.0, 30.0, 100.0, 1e3, 1e4, 1e5, 1e6}) {
      if (largest > 300 && (size == 3 || size == 30)) continue;
      for (const double sign : {-1.0, 1.0}) {
        const double value = sign * size;
        if (value < low_ || value > high_ || (size == 0 && sign < 0)) continue;
        result.push_back({pixel(value), with_minus(fmt::format("{:g}", value + 0.0))});
      }
    }
    return result;
  }
  const double step = round_step(high_ - low_);
  for (double k = std::ceil(low_ / step - 1e-9); k * step <= high_ + 1e-9 * step; ++k)
    result.push_back({pixel(k * step), with_minus(fmt::format("{:.6g}", k == 0 ? 0.0 : k * step))});
  return result;
}

}  // namespace plumbline::page
