#include "diagnose/report/noise_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace plumbline::diagnose {
namespace {

std::string two_digits(double value) {
  return value < 0.1 ? fmt::format("{:.2g}", value) : fmt::format("{:.2f}", value);
}

/// "Fx 2.00, q 0.45 to 0.62": a value of each channel, of all joint angles together.
std::string by_name(const NoiseEstimate& noise, double ChannelNoise::*value) {
  std::map<std::string, std::pair<double, double>> ranges;
  for (const ChannelNoise& one : noise.channels) {
    const auto [place, is_first] =
        ranges.try_emplace(std::string(kind_of(one.channel.name).label), one.*value, one.*value);
    if (is_first) continue;
    auto& [low, high] = place->second;
    low = std::min(low, one.*value), high = std::max(high, one.*value);
  }
  std::string text;
  for (const auto& [name, range] : ranges) {
    const std::string low = two_digits(range.first), high = two_digits(range.second);
    text += (text.empty() ? "" : ", ") + name + " " + low + (low == high ? "" : " to " + high);
  }
  return text;
}

/// One line for the channels of a run that share a sinusoid.
std::string interference(const std::vector<ChannelInterference>& sinusoids) {
  std::string text;
  for (auto first = sinusoids.begin(); first != sinusoids.end();) {
    const auto end = std::find_if(first, sinusoids.end(), [&](const ChannelInterference& one) {
      return one.run != first->run || one.period != first->period;
    });
    std::vector<std::string> channels;
    double largest = 0;
    for (auto one = first; one != end; ++one)
      channels.push_back(one->channel.label()), largest = std::max(largest, one->rms);
    text += fmt::format(
        "  periodic interference in {} of {}: period {:.2g} readings, {}{:.1f} declared sigmas rms; counted "
        "as noise\n",
        fmt::join(channels, ", "), first->run, first->period, channels.size() > 1 ? "up to " : "", largest);
    first = end;
  }
  return text;
}

std::string departures(const GapAnswer& answer, const NoiseShape& shape) {
  std::string text;
  for (const auto& [name, ratio] : shape.proportional)
    text += fmt::format("  the noise of {} grows with the reading, by {:.2g} % of it\n", kind_of(name).label,
                        100 * ratio);
  for (const NoisierReadings& one : answer.noisier)
    text += one.whole_run
                ? fmt::format("  the {} noise of run {} is {:.1f} times that of the other runs\n",
                              label(one.sensor), one.run, one.factor)
                : fmt::format("  the {} noise of readings {}-{} of {} is {:.1f} times that of the others\n",
                              label(one.sensor), one.from, one.to, one.run, one.factor);
  if (shape.quantised) text += "  a coarse display: equal readings in a row share one rounding error\n";
  return text + interference(answer.interference);
}

/// The largest ones, a line each, and the number of the others.
std::string outlier_lines(const std::vector<Outlier>& all) {
  constexpr std::size_t few = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(few, all.size()); ++i)
    text += fmt::format("  outlier: {} at reading {} of {}, {:+.3g} standard deviations{}\n",
                        all[i].channel.label(), all[i].reading, all[i].run, all[i].deviation,
                        all[i].at_end ? "; at the end of its run, where an event would look the same" : "");
  if (all.size() > few)
    text += fmt::format("  {} smaller outliers (--json: gap.outliers)\n", all.size() - few);
  return text;
}

}  // namespace

std::string noise_scales(const NoiseEstimate& noise) {
  return by_name(noise, &ChannelNoise::scale);
}

std::string outliers_in_words(const std::vector<Outlier>& outliers) {
  if (outliers.empty()) return "";
  const Outlier& largest = outliers.front();
  const std::string where =
      fmt::format("{} at reading {} of {}", largest.channel.label(), largest.reading, largest.run);
  const double off = std::abs(largest.deviation);
  if (outliers.size() == 1)
    return fmt::format("1 value has no weight: an outlier, {:.3g} standard deviations off, {}", off, where);
  return fmt::format(
      "{} values have no weight: outliers, up to {:.3g} standard deviations off, the largest {}",
      outliers.size(), off, where);
}

std::string noise_as_text(const Diagnosis& diagnosis) {
  // Readings without a clock have none.
  const std::vector<ChannelNoise>& channels = diagnosis.noise.channels;
  const bool timed = std::any_of(channels.begin(), channels.end(),
                                 [](const ChannelNoise& one) { return one.correlation != 0; });
  return fmt::format("  noise over declared: {}", noise_scales(diagnosis.noise)) +
         (timed ? fmt::format("; autocorrelation of successive readings: {}",
                              by_name(diagnosis.noise, &ChannelNoise::correlation))
                : "") +
         "\n" + departures(diagnosis.gap, diagnosis.noise.shape) + outlier_lines(diagnosis.gap.outliers);
}

}  // namespace plumbline::diagnose
