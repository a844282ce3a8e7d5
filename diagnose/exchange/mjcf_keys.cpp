#include "diagnose/exchange/mjcf_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
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

void take(const Words& from, std::size_t& next, std::size_t count, Words& to) {
  for (; count > 0 && next < from.size(); --count) to.push_back(from[next++]);
}

/// The joints as they stand now, in the order of their bodies.
void add_joints(xml_node holder, std::vector<xml_node>& all) {
  const auto within = [&](const auto& look) {
    for (const xml_node child : holder.children()) look(child, std::string(child.name()));
  };
  within([&](xml_node child, const std::string& kind) {
    if (kind == "joint" || kind == "freejoint") all.push_back(child);
  });
  within([&](xml_node child, const std::string& kind) {
    if (kind == "body" || kind == "frame") add_joints(child, all);
  });
}

/// What was said of each joint, and what is added, in the order of the joints now.
struct States {
  Words qpos, qvel;
};
States extended(const xml_node key, const std::vector<MjcfJoint>& old, const std::vector<xml_node>& now) {
  const Words qpos = words(key.attribute("qpos").value()), qvel = words(key.attribute("qvel").value());
  // Where the words of each joint begin.
  std::vector<std::array<std::size_t, 2>> from(old.size() + 1, {0, 0});
  for (std::size_t j = 0; j < old.size(); ++j) {
    const bool free = old[j].type == "free", ball = old[j].type == "ball";
    from[j + 1] = {from[j][0] + (free ? 7 : ball ? 4 : 1), from[j][1] + (free ? 6 : ball ? 3 : 1)};
  }
  States states;
  for (const xml_node one : now) {
    const auto place =
        std::find_if(old.begin(), old.end(), [&](const MjcfJoint& joint) { return joint.element == one; });
    if (place == old.end()) {
      states.qpos.emplace_back(one.attribute("springref").value());
      states.qvel.emplace_back("0");
      continue;
    }
    const auto j = static_cast<std::size_t>(place - old.begin());
    std::array<std::size_t, 2> next = from[j];
    take(qpos, next[0], from[j + 1][0] - from[j][0], states.qpos);
    take(qvel, next[1], from[j + 1][1] - from[j][1], states.qvel);
  }
  return states;
}

std::vector<xml_node> actuators_in(xml_node root) {
  std::vector<xml_node> all;
  for (const xml_node section : root.children("actuator"))
    for (const xml_node one : section.children())
      if (one.type() == pugi::node_element) all.push_back(one);
  return all;
}

/// Of the actuators that were added.
Words controls(const xml_node root, std::size_t old, Pair start) {
  Words all;
  const std::vector<xml_node> now = actuators_in(root);
  for (std::size_t a = old; a < now.size(); ++a) {
    const std::string name = now[a].attribute("name").value();
    all.push_back(number(name == "drive_x" ? start[0] : name == "drive_y" ? start[1] : 0));
  }
  return all;
}

std::string joined(const Words& all) {
  return fmt::format("{}", fmt::join(all, " "));
}

}  // namespace

void extend_keys(MjcfScene& scene, std::size_t actuators, Pair start) {
  std::vector<xml_node> now;
  for (const xml_node world : scene.document.root().children("worldbody")) add_joints(world, now);
  const Words added = controls(scene.document.root(), actuators, start);
  for (const xml_node keyframe : scene.document.root().children("keyframe"))
    for (const xml_node key : keyframe.children("key")) {
      const States states = extended(key, scene.joints, now);
      if (key.attribute("qpos")) set(key, "qpos", joined(states.qpos));
      if (key.attribute("qvel")) set(key, "qvel", joined(states.qvel));
      if (!key.attribute("ctrl")) continue;
      Words ctrl = words(key.attribute("ctrl").value());
      ctrl.insert(ctrl.end(), added.begin(), added.end());
      set(key, "ctrl", joined(ctrl));
    }
}

}  // namespace plumbline::exchange
