#include "diagnose/draft/sensor_columns.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string_view>

namespace plumbline::diagnose {
namespace {

/// What titles call a kind of sensors, and how those of its columns end.
struct SensorWords {
  std::string_view key;
  std::array<std::string_view, 8> words;
  std::array<std::string_view, 2> ends;
};
constexpr std::array sensor_words{
    SensorWords{
        "distance", {"distance", "dist", "wire", "drawwire", "ballbar", "seilzug", "range", "abstand"}, {}},
    SensorWords{"camera", {"camera", "cam", "pixel", "px", "image", "picture", "marker"}, {"u", "v"}},
    SensorWords{
        "inclinometer", {"tilt", "level", "inclination", "inclinometer", "incl", "neigung"}, {"x", "y"}},
    SensorWords{"plane", {"contact"}, {}}};

/// The words of a title before its unit, in small letters; a number at the end of a word is left to it.
std::vector<std::string> title_words(const std::string& title) {
  std::vector<std::string> words{""};
  for (const char c : title.substr(0, title.find_first_of("[("))) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

bool is_called(const std::vector<std::string>& title, const SensorWords& of) {
  return std::ranges::any_of(title, [&](const std::string& word) {
    const std::string stem = word.substr(0, word.find_last_not_of("0123456789") + 1);
    return !stem.empty() && std::ranges::count(of.words, stem) > 0;
  });
}

std::string joined_words(std::span<const std::string> words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : "_") + word;
  return all;
}

}  // namespace

std::vector<SensorColumns> sensor_columns(const RunSource& source) {
  std::vector<std::vector<std::string>> titles;
  for (std::size_t c = 0; c < source.columns(); ++c) titles.push_back(title_words(source.title(c)));
  std::vector<SensorColumns> all;
  for (const SensorWords& of : sensor_words) {
    const ArmSensorKind* const kind = &*std::ranges::find(arm_sensor_kinds(), of.key, &ArmSensorKind::key);
    for (std::size_t c = 0; c < titles.size(); ++c) {
      const std::vector<std::string>& title = titles[c];
      if (!is_called(title, of) || std::ranges::count(source.others, c) > 0 || source.told.contains(c))
        continue;
      if (kind->numbers == 1) {
        all.push_back({joined_words(title), kind, {c}});
        continue;
      }
      if (title.size() < 2 || title.back() != of.ends[0]) continue;
      std::vector<std::string> other = title;
      other.back() = of.ends[1];
      if (const auto second = std::ranges::find(titles, other); second != titles.end())
        all.push_back({joined_words(std::span(title).first(title.size() - 1)),
                       kind,
                       {c, static_cast<std::size_t>(second - titles.begin())}});
    }
  }
  return all;
}

}  // namespace plumbline::diagnose
