#include "diagnose/exchange/mjcf_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace plumbline::exchange {
namespace {

using pugi::xml_node;
using Words = std::vector<std::string>;

Words words(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

void take(const Words& from, int first, int last, Words& to) {
  for (auto i = static_cast<std::size_t>(first); i < std::min(from.size(), static_cast<std::size_t>(last));
       ++i)
    to.push_back(from[i]);
}

/// What was said of each joint, and what is added, in the order of the joints now.
struct States {
  Words qpos, qvel;
};
States extended(const xml_node key, const std::vector<xml_node>& old, const std::vector<xml_node>& now,
                const mjModel& own) {
  const Words qpos = words(key.attribute("qpos").value()), qvel = words(key.attribute("qvel").value());
  States states;
  for (const xml_node one : now) {
    const auto place = std::find(old.begin(), old.end(), one);
    if (place == old.end()) {
      states.qpos.emplace_back(one.attribute("springref").value());
      states.qvel.emplace_back("0");
      continue;
    }
    const auto j = static_cast<int>(place - old.begin());
    const bool last = j + 1 == own.njnt;
    take(qpos, own.jnt_qposadr[j], last ? own.nq : own.jnt_qposadr[j + 1], states.qpos);
    take(qvel, own.jnt_dofadr[j], last ? own.nv : own.jnt_dofadr[j + 1], states.qvel);
  }
  return states;
}

/// Of the actuators that were added.
Words controls(const xml_node root, int old, Pair start) {
  Words all;
  int number_of = 0;
  for (const xml_node section : root.children("actuator"))
    for (const xml_node one : section.children()) {
      if (one.type() != pugi::node_element || ++number_of <= old) continue;
      const std::string name = one.attribute("name").value();
      all.push_back(number(name == "drive_x" ? start[0] : name == "drive_y" ? start[1] : 0));
    }
  return all;
}

std::string joined(const Words& all) {
  return fmt::format("{}", fmt::join(all, " "));
}

}  // namespace

void extend_keys(MjcfDocument& document, const mjModel& own, Pair start) {
  const std::vector<xml_node> old = document.joints;
  document.number();
  const Words added = controls(document.root(), own.nu, start);
  for (const xml_node keyframe : document.root().children("keyframe"))
    for (const xml_node key : keyframe.children("key")) {
      const States states = extended(key, old, document.joints, own);
      if (key.attribute("qpos")) set(key, "qpos", joined(states.qpos));
      if (key.attribute("qvel")) set(key, "qvel", joined(states.qvel));
      if (!key.attribute("ctrl")) continue;
      Words ctrl = words(key.attribute("ctrl").value());
      ctrl.insert(ctrl.end(), added.begin(), added.end());
      set(key, "ctrl", joined(ctrl));
    }
}

}  // namespace plumbline::exchange
