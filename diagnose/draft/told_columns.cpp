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
  const char *name, *means;
  Kind kind;
  bool commanded = false, numbered = false;
  char axis = ' ';
};

constexpr ChannelWord channels[] = {{"t", "time", Kind::time},
                                    {"x", "place along x", Kind::x},
                                    {"y", "place along y", Kind::y},
                                    {"z", "place along z", Kind::z},
                                    {"F", "the only force", Kind::force},
                                    {"Fx", "force along x", Kind::force_x},
                                    {"Fy", "force along y", Kind::force_y},
                                    {"Fz", "force along z", Kind::force_z},
                                    {"Mx", "moment about x", Kind::moment_x},
                                    {"My", "moment about y", Kind::moment_y},
                                    {"Mz", "moment about z", Kind::moment_z},
                                    {"angle", "angle of the joint", Kind::angle},
                                    {"q_command", "commanded angle", Kind::angle, true, true},
                                    {"q", "joint angle", Kind::angle, false, true},
                                    {"torque", "torque", Kind::torque, false, true},
                                    {"weight", "mass that hangs", Kind::mass},
                                    {"temperature", "temperature", Kind::temperature},
                                    {"tension", "tension of a tendon", Kind::tension},
                                    {"pressure", "pressure of an actuator", Kind::pressure},
                                    {"qw", "quaternion, w", Kind::rotation, false, false, 'W'},
                                    {"qx", "quaternion, x", Kind::rotation, false, false, 'X'},
                                    {"qy", "quaternion, y", Kind::rotation, false, false, 'Y'},
                                    {"qz", "quaternion, z", Kind::rotation, false, false, 'Z'},
                                    {"roll", "roll", Kind::rotation, false, false, 'r'},
                                    {"pitch", "pitch", Kind::rotation, false, false, 'p'},
                                    {"yaw", "yaw", Kind::rotation, false, false, 'y'},
                                    {"run", "name of the run", Kind::run},
                                    {"ignore", "left out", Kind::left_out}};

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
  std::vector<std::string> names;
  for (const ChannelWord& one : channels) names.emplace_back(one.name);
  throw Error("--columns", files::shown(name),
              fmt::format("one of {}, q1 …, q_command1 …, torque1 …", fmt::join(names, ", ")));
}

/// A torque may be told in the unit of a force on a lever, a force by the mass that weighs so much.
void take_unit(ColumnWords& words, const std::string& unit) {
  const Quantity* const quantity = quantity_of(words.kind);
  if (quantity == nullptr) return;
  words.unit = unit_in(unit, *quantity);
  if (words.unit.empty()) words.unit = parse_unit(unit, *quantity, "--columns").name;
}

}  // namespace

std::vector<ChannelChoice> channel_choices() {
  std::vector<ChannelChoice> all;
  for (const ChannelWord& one : channels) {
    const Quantity* const quantity = quantity_of(one.kind);
    const bool has_unit = quantity != nullptr && one.kind != Kind::rotation;
    all.push_back({one.name, one.means, one.numbered,
                   has_unit ? parts(quantity->examples, ',') : std::vector<std::string>()});
    for (std::string& unit : all.back().units) unit.erase(0, unit.find_first_not_of(' '));
  }
  return all;
}

std::string channel_word(const ColumnWords& words) {
  for (const ChannelWord& one : channels)
    if (one.kind == words.kind && one.commanded == words.commanded && one.axis == words.axis &&
        (words.joint == 0 || one.numbered))
      return words.joint == 0 ? one.name : fmt::format("{}{}", one.name, words.joint);
  return "";
}

std::string columns_option(const std::vector<ToldColumn>& told) {
  std::vector<std::string> entries;
  for (const ToldColumn& one : told) {
    std::string column;
    for (const char c : one.column) column += c == ',' || c == ':' ? std::string(2, c) : std::string(1, c);
    entries.push_back(fmt::format("{}={}{}{}", channel_word(one.words), one.words.sign < 0 ? "-" : "", column,
                                  one.words.unit.empty() ? "" : ":" + one.words.unit));
  }
  return fmt::format("--columns \"{}\"", fmt::join(entries, ","));
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
