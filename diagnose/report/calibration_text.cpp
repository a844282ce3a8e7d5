#include "diagnose/report/calibration_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "diagnose/bench/roll_pitch_yaw.hpp"
#include "diagnose/report/view.hpp"

namespace plumbline::diagnose {
namespace {

using Json = nlohmann::ordered_json;

/// "0.14 mm"; of several kinds of channels "0.14 mm, 0.2 mrad"
std::string left(const LeftOfPoses& one) {
  std::vector<std::string> words;
  for (const ChannelKind& kind : channel_kinds)
    if (const double rms = one.of(kind.name); rms > 0)
      words.push_back(kind.sensor == Sensor::pixel ? fmt::format("{:.3g} px", rms)
                                                   : fmt::format("{:.3g} m{}", 1e3 * rms, unit(kind.sensor)));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// "zeros of 10 mrad", "gear ratios of 0.02 %"
std::string size_in_words(const LearnedSize& one) {
  const bool ratio = one.unit == "ratio", small = one.unit == "rad" || one.unit == "m";
  return fmt::format("{} of {:.2g} {}{}", one.effect.effect->everywhere,
                     (ratio   ? 100
                      : small ? 1e3
                              : 1) *
                         one.size,
                     small ? "m" : "", ratio ? "%" : one.unit);
}

std::string vector_in_words(const Vector3<double>& one, double factor, const char* unit) {
  const Vector3<double> v = factor * one;
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) {}", v.x(), v.y(), v.z(), unit);
}

/// Half the width of a 95 % interval over the standard deviation.
constexpr double bounds = 1.96;

/// Nothing where no reading shows it.
std::string frame_in_words(const SolvedFrame& one) {
  static constexpr std::array kinds{"base of the arm for the", "point", "sensor"};
  std::vector<std::string> words;
  if (!one.shift.isZero(0))
    words.push_back(fmt::format("{} ± {}", vector_in_words(one.at.translation(), 1e3, "mm"),
                                vector_in_words(one.shift, bounds * 1e3, "mm")));
  if (!one.turn.isZero(0))
    words.push_back(fmt::format("turned by {} ± {}",
                                vector_in_words(roll_pitch_yaw(one.at.linear()), 1, "rad (roll, pitch, yaw)"),
                                vector_in_words(one.turn, bounds * 1e3, "mrad")));
  if (one.focal_length > 0)
    words.push_back(
        fmt::format("focal length {:.6g} ± {:.2g} px", one.focal_length, bounds * one.focal_length_sd));
  if (words.empty()) return "";
  return fmt::format("  {} {}: {}\n", kinds.at(static_cast<std::size_t>(one.of)), one.name,
                     fmt::join(words, ", "));
}

Json left_as_json(const LeftOfPoses& one) {
  Json result = Json::object();
  for (const ChannelKind& kind : channel_kinds)
    if (const double rms = one.of(kind.name); rms > 0) result[std::string(kind.noise_key)] = rms;
  return result;
}

Json numbers(const Vector3<double>& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace

std::string tolerances_in_words(const Calibration& of) {
  std::vector<std::string> words;
  for (const LearnedSize& one : of.sizes) words.push_back(size_in_words(one));
  return words.empty() ? "no error of all joints" : joined(words, ", ", " and ") + " at all joints";
}

std::string calibration_as_text(const Calibration& of) {
  std::string text = fmt::format(
      "How good is the corrected arm?  Of poses that a fit has not seen it leaves {} rms; least squares of "
      "all "
      "geometry {}, the nominal arm {}\n",
      left(of.corrected), left(of.least_squares), left(of.nominal));
  for (const NominalEffect& one : of.beside) {
    text += fmt::format("  beside these, by a linear fit: {}", one.label());
    for (const auto& [name, value] : one.parameters) text += fmt::format(", {} = {:.3g}", name, value);
    text += "\n";
  }
  for (const SolvedFrame& one : of.frames) text += frame_in_words(one);
  return text;
}

Json calibration_as_json(const Calibration& of) {
  Json frames = Json::array(), sizes = Json::array(), beside = Json::array();
  for (const SolvedFrame& one : of.frames) {
    frames.push_back({{"name", one.name},
                      {"xyz", numbers(one.at.translation())},
                      {"rpy", numbers(roll_pitch_yaw(one.at.linear()))},
                      {"xyz_sd", numbers(one.shift)},
                      {"turn_sd", numbers(one.turn)}});
    if (one.focal_length > 0)
      frames.back()["focal_length"] = one.focal_length,
      frames.back()["focal_length_sd"] = one.focal_length_sd;
  }
  for (const LearnedSize& one : of.sizes)
    sizes.push_back({{"effect", one.effect.effect->id}, {"sd", one.size}, {"unit", one.unit}});
  for (const NominalEffect& one : of.beside)
    beside.push_back({{"effect", one.label()}, {"parameters", one.parameters}});
  return {{"noise", of.noise},
          {"frames", frames},
          {"every_joint", sizes},
          {"beside", beside},
          {"left_of_unseen_poses",
           {{"nominal", left_as_json(of.nominal)},
            {"least_squares", left_as_json(of.least_squares)},
            {"corrected", left_as_json(of.corrected)}}}};
}

}  // namespace plumbline::diagnose
