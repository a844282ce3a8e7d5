#include "diagnose/report/noise_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace plumbline::diagnose {
namespace {

using Name = Channel::Name;

/// "0.12", or by sensor where these differ: "0.85 (force), 0.02 (angle)".
std::string autocorrelations(const NoiseModel& noise, const std::map<Channel, double>& measured) {
  std::map<Sensor, std::string> by_sensor;
  for (const auto& [channel, rms] : measured)
    by_sensor[channel.sensor()] = fmt::format("{:.2f}", noise.correlation_of(channel));
  const std::string& first = by_sensor.begin()->second;
  if (std::all_of(by_sensor.begin(), by_sensor.end(), [&](const auto& one) { return one.second == first; }))
    return first;
  std::string text;
  for (const auto& [sensor, value] : by_sensor)
    text += (text.empty() ? "" : ", ") + value + " (" + label(sensor) + ")";
  return text;
}

/// "3.0", "0.033".
std::string times(double scale) {
  return scale < 1 ? fmt::format("{:.2g}", scale) : fmt::format("{:.1f}", scale);
}

/// The noise scales; a sentence for each that is far from one.
std::string scales(const NoiseModel& noise, const std::map<Channel, double>& measured) {
  std::vector<std::string> all;
  std::string remarks;
  for (const Name name : {Name::x, Name::y, Name::Fx, Name::Fy, Name::q}) {
    const auto carries = [&](const auto& one) { return one.first.name == name; };
    if (std::none_of(measured.begin(), measured.end(), carries)) continue;
    const double scale = noise.of({name});
    all.push_back(fmt::format(fmt::runtime(scale < 0.1 ? "{} {:.2g}" : "{} {:.2f}"), label(name), scale));
    if (scale > 1.5 || scale < 1 / 1.5)
      remarks += fmt::format("  the noise of {} is {} times the declared one\n", label(name), times(scale));
  }
  return fmt::format("  noise over declared: {}; autocorrelation of successive readings {}\n{}",
                     fmt::join(all, ", "), autocorrelations(noise, measured), remarks);
}

/// One line for the channels of a run that share a sinusoid.
std::string interference(const std::vector<HummingChannel>& sinusoids) {
  std::string text;
  for (auto first = sinusoids.begin(); first != sinusoids.end();) {
    const auto end = std::find_if(first, sinusoids.end(), [&](const HummingChannel& one) {
      return one.run != first->run || std::abs(one.period - first->period) > 0.05 * first->period;
    });
    std::vector<std::string> channels;
    double largest = 0;
    for (auto one = first; one != end; ++one)
      channels.push_back(one->channel.label()), largest = std::max(largest, one->rms);
    text += fmt::format(
        "  periodic interference in {} of {}: period {:.2g} readings, {}{:.1f} declared sigmas rms; counted "
        "as "
        "noise\n",
        fmt::join(channels, ", "), first->run, first->period, channels.size() > 1 ? "up to " : "", largest);
    first = end;
  }
  return text;
}

std::string departures(const GapAnswer& answer) {
  std::string text;
  for (const auto& [name, share] : answer.proportional)
    text += fmt::format("  the noise of {} grows with the reading, by {:.2g} % of it\n", label(name),
                        100 * share);
  for (const auto& [channel, factor] : answer.uneven)
    text += fmt::format("  the noise of {} is {:.1f} times that of the other joint angles\n", channel.label(),
                        factor);
  for (const RougherRun& one : answer.rougher)
    text += fmt::format("  the {} noise of run {} is {:.1f} times that of the other runs\n",
                        label(one.sensor), one.run, one.times);
  for (const RougherStretch& one : answer.rougher_stretches)
    text += fmt::format("  the {} noise of readings {}-{} of {} is {:.1f} times that of the others\n",
                        label(one.sensor), one.from, one.to, one.run, one.times);
  return text;
}

}  // namespace

std::string noise_as_text(const Diagnosis& diagnosis) {
  const GapAnswer& answer = diagnosis.gap;
  std::string text = scales(diagnosis.noise, answer.rms);
  if (diagnosis.may_hide_ripple())
    text +=
        "  noise this large may hide a ripple of the device finer than the readings: measure in smaller "
        "steps\n";
  return text + departures(answer) + interference(answer.hum);
}

}  // namespace plumbline::diagnose
