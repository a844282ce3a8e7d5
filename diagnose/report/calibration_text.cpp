#include "diagnose/report/calibration_text.hpp"

#include <fmt/format.h>

#include "diagnose/bench/roll_pitch_yaw.hpp"
#include "diagnose/report/view.hpp"

namespace plumbline::diagnose {
namespace {

using Json = nlohmann::ordered_json;

std::string left(const LeftOfPoses& one) {
  std::string text;
  if (one.place > 0) text += fmt::format("{:.3g} mm", 1e3 * one.place);
  if (one.turn > 0) text += fmt::format("{}{:.3g} mrad", text.empty() ? "" : ", ", 1e3 * one.turn);
  return text;
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

std::string frame_in_words(const SolvedFrame& one) {
  std::string text = fmt::format(
      "  {} {}: {} ± {}", one.name == "tracker" ? "base of the arm for the" : "point", one.name,
      vector_in_words(one.at.translation(), 1e3, "mm"), vector_in_words(one.shift, bounds * 1e3, "mm"));
  if (!one.turn.isZero(0))
    text += fmt::format(", turned by {} ± {}",
                        vector_in_words(roll_pitch_yaw(one.at.linear()), 1, "rad (roll, pitch, yaw)"),
                        vector_in_words(one.turn, bounds * 1e3, "mrad"));
  return text + "\n";
}

Json left_as_json(const LeftOfPoses& one) {
  Json result = Json::object();
  if (one.place > 0) result["place"] = one.place;
  if (one.turn > 0) result["turn"] = one.turn;
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
  for (const SolvedFrame& one : of.frames)
    frames.push_back({{"name", one.name},
                      {"xyz", numbers(one.at.translation())},
                      {"rpy", numbers(roll_pitch_yaw(one.at.linear()))},
                      {"xyz_sd", numbers(one.shift)},
                      {"turn_sd", numbers(one.turn)}});
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
