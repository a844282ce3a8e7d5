#include "diagnose/draft/told_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <plumbline/base/error.hpp>

#include "diagnose/draft/actuator_words.hpp"
#include "diagnose/draft/unit_words.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

struct ChannelWord {
  const char* name;
  Kind kind;
  bool commanded = false, numbered = false;
  char axis = ' ';
};

constexpr ChannelWord channels[] = {{"t", Kind::time},
                                    {"x", Kind::x},
                                    {"y", Kind::y},
                                    {"z", Kind::z},
                                    {"F", Kind::force},
                                    {"Fx", Kind::force_x},
                                    {"Fy", Kind::force_y},
                                    {"Fz", Kind::force_z},
                                    {"Mx", Kind::moment_x},
                                    {"My", Kind::moment_y},
                                    {"Mz", Kind::moment_z},
                                    {"angle", Kind::angle},
                                    {"q_command", Kind::angle, true, true},
                                    {"q", Kind::angle, false, true},
                                    {"torque", Kind::torque, false, true},
                                    {"weight", Kind::mass},
                                    {"temperature", Kind::temperature},
                                    {"tension", Kind::tension},
                                    {"pressure", Kind::pressure},
                                    {"qw", Kind::rotation, false, false, 'W'},
                                    {"qx", Kind::rotation, false, false, 'X'},
                                    {"qy", Kind::rotation, false, false, 'Y'},
                                    {"qz", Kind::rotation, false, false, 'Z'},
                                    {"roll", Kind::rotation, false, false, 'r'},
                                    {"pitch", Kind::rotation, false, false, 'p'},
                                    {"yaw", Kind::rotation, false, false, 'y'},
                                    {"run", Kind::run},
                                    {"ignore", Kind::left_out}};

/// Parts between single separators; a double one stands for itself.
std::vector<std::string> parts(const std::string& text, char separator) {
  std::vector<std::string> all(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != separator) {
      all.back() += text[i];
    } else if (i + 1 < text.size() && text[i + 1] == separator) {
      all.back() += text[i++];
    } else {
      all.emplace_back();
    }
  }
  return all;
}

ColumnWords words_of_channel(const std::string& name) {
  for (const ChannelWord& one : channels) {
    const std::string stem = one.name;
    const bool numbered = one.numbered && name.size() > stem.size() && name.starts_with(stem) &&
                          std::all_of(name.begin() + static_cast<std::ptrdiff_t>(stem.size()), name.end(),
                                      [](unsigned char c) { return std::isdigit(c) != 0; });
    if (name != stem && !numbered) continue;
    ColumnWords words{one.kind};
    words.commanded = one.commanded, words.axis = one.axis;
    constexpr std::size_t digits = 4;
    if (numbered && name.size() < stem.size() + digits) words.joint = std::stoul(name.substr(stem.size()));
    return words;
  }
  throw Error("--columns", files::shown(name),
              fmt::format("one of {}, q1 …, q_command1 …, torque1 …", fmt::join(channel_words(), ", ")));
}

/// A torque may be told in the unit of a force on a lever, a force by the mass that weighs so much.
void take_unit(ColumnWords& words, const std::string& unit) {
  const Quantity* const quantity = quantity_of(words.kind);
  if (quantity == nullptr) return;
  words.unit = unit_in(unit, *quantity);
  if (words.unit.empty()) words.unit = parse_unit(unit, *quantity, "--columns").name;
}

}  // namespace

std::vector<std::string> channel_words() {
  std::vector<std::string> all;
  for (const ChannelWord& one : channels) all.emplace_back(one.name);
  return all;
}

std::vector<ToldColumn> told_columns(const std::string& text) {
  std::vector<ToldColumn> all;
  if (text.empty()) return all;
  for (const std::string& entry : parts(text, ',')) {
    const std::size_t is = entry.find('=');
    if (is == std::string::npos || is + 1 == entry.size())
      throw Error("--columns", files::shown(entry),
                  "CHANNEL=COLUMN or CHANNEL=COLUMN:UNIT, with commas between them");
    ToldColumn& told = all.emplace_back(ToldColumn{"", words_of_channel(entry.substr(0, is))});
    std::vector<std::string> said = parts(entry.substr(is + 1), ':');
    if (said.front().size() > 1 && said.front().front() == '-')
      told.words.sign = -1, said.front().erase(0, 1);
    told.column = said.front();
    if (said.size() > 1) take_unit(told.words, said[1]);
    if (is_actuation(told.words.kind)) told.words.variable = variable_of({folded(told.column)});
  }
  return all;
}

}  // namespace plumbline::diagnose
