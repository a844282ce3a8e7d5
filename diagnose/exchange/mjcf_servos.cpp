#include "diagnose/exchange/mjcf_servos.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <plumbline/base/error.hpp>

#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

using pugi::xml_node;

/// An element's own attribute, or that of its class: of its kind, or as <general> has them all.
std::vector<double> parameters(const MjcfScene& scene, xml_node actuator, const char* name,
                               std::vector<double> otherwise) {
  constexpr std::size_t most = 100;
  const std::string place = place_of(scene.document.file(), actuator) + ": " + name;
  if (const auto own = actuator.attribute(name)) return numbers_in(own.value(), place, 1, most);
  for (const char* kind : {actuator.name(), "general"})
    for (const xml_node one : scene.defaults.inherited(actuator, kind))
      if (const auto theirs = one.attribute(name)) return numbers_in(theirs.value(), place, 1, most);
  return otherwise;
}

std::string word(const MjcfScene& scene, xml_node actuator, const char* name, const char* otherwise) {
  if (const auto own = actuator.attribute(name)) return own.value();
  for (const char* kind : {actuator.name(), "general"})
    for (const xml_node one : scene.defaults.inherited(actuator, kind))
      if (const auto theirs = one.attribute(name)) return theirs.value();
  return otherwise;
}

double at(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? values[i] : 0;
}

/// As <position> and <intvelocity> have it.
void read_gains(const MjcfScene& scene, MjcfServo& servo) {
  const double gain = parameters(scene, servo.element, "gainprm", {1}).front();
  servo.gain = parameters(scene, servo.element, "kp", {gain}).front();
  const double ratio = parameters(scene, servo.element, "dampratio", {0}).front();
  servo.bias = {0, -servo.gain, ratio > 0 ? ratio : -parameters(scene, servo.element, "kv", {0}).front()};
  for (const char* name : {"timeconst", "inheritrange"})
    if (!parameters(scene, servo.element, name, {}).empty()) servo.special = name;
  if (std::string(servo.element.name()) == "intvelocity") servo.special = "intvelocity";
}

/// Its law; or none where it is no spring.
std::optional<MjcfServo> law_of(const MjcfScene& scene, xml_node actuator) {
  MjcfServo servo{actuator, "", 0, parameters(scene, actuator, "gear", {1}).front(), 1, {}};
  const std::string kind = actuator.name();
  if (kind == "position" || kind == "intvelocity") {
    read_gains(scene, servo);
  } else if (kind == "general" && word(scene, actuator, "biastype", "none") == "affine" &&
             word(scene, actuator, "gaintype", "fixed") == "fixed") {
    servo.gain = parameters(scene, actuator, "gainprm", {1}).front();
    servo.bias = parameters(scene, actuator, "biasprm", {0});
    servo.bias.resize(std::max<std::size_t>(servo.bias.size(), 3));
  } else {
    return {};
  }
  if (!(servo.stiffness() > 0)) return {};
  return servo;
}

/// The keyframe `home`, or the only one there is.
xml_node home_of(const MjcfScene& scene) {
  std::vector<xml_node> all;
  for (const xml_node section : scene.document.root().children("keyframe"))
    for (const xml_node key : section.children("key")) all.push_back(key);
  for (const xml_node key : all)
    if (std::string(key.attribute("name").value()) == "home") return key;
  return all.size() == 1 ? all.front() : xml_node();
}

class Actuators {
 public:
  explicit Actuators(const MjcfScene& scene) : scene_(scene), home_(home_of(scene)) {
    if (const auto ctrl = home_.attribute("ctrl"))
      controls_ = numbers_in(ctrl.value(), place_of(scene.document.file(), home_) + ": ctrl", 0, 100000);
  }

  MjcfActuators result() {
    for (const xml_node section : scene_.document.root().children("actuator"))
      for (const xml_node one : section.children())
        if (one.type() == pugi::node_element) add(one);
    if (!all_.servos.empty() && !controls_.empty())
      all_.notes.push_back(
          fmt::format("rest: the command of the keyframe {}", files::shown(home_.attribute("name").value())));
    return std::move(all_);
  }

 private:
  void add(xml_node actuator) {
    const std::size_t number = all_.count++;
    const auto own_name = actuator.attribute("name");
    const std::string name =
        own_name ? files::shown(own_name.value()) : fmt::format("actuator {}", all_.count);
    const auto target =
        actuator.attribute("joint") ? actuator.attribute("joint") : actuator.attribute("jointinparent");
    const auto joint = std::find_if(scene_.joints.begin(), scene_.joints.end(), [&](const MjcfJoint& one) {
      return target && std::string(one.element.attribute("name").value()) == target.value();
    });
    if (target && joint == scene_.joints.end())
      throw Error(place_of(scene_.document.file(), actuator), "the joint " + files::shown(target.value()),
                  "a joint that the file has");
    std::optional<MjcfServo> servo;
    const bool simple = target && (joint->type == "hinge" || joint->type == "slide");
    if (simple && !scene_.document.disabled("actuation")) servo = law_of(scene_, actuator);
    if (!servo) {
      all_.left_out.push_back(fmt::format("{} {}", actuator.name(), name));
      return;
    }
    servo->name = name;
    servo->joint = static_cast<std::size_t>(joint - scene_.joints.begin());
    servo->control = commanded(actuator, at(controls_, number));
    if (actuator.attribute("forcerange") || word(scene_, actuator, "forcelimited", "") == "true")
      all_.left_out.push_back("force limit of " + name);
    all_.servos.push_back(*servo);
  }

  /// Within the range of the control.
  [[nodiscard]] double commanded(xml_node actuator, double control) const {
    const std::vector<double> range = parameters(scene_, actuator, "ctrlrange", {});
    const std::string limited = word(scene_, actuator, "ctrllimited", "auto");
    if (range.size() != 2 || limited == "false" || !(range[0] < range[1])) return control;
    return std::clamp(control, range[0], range[1]);
  }

  const MjcfScene& scene_;
  xml_node home_;
  std::vector<double> controls_;
  MjcfActuators all_;
};

}  // namespace

MjcfActuators actuators_of(const MjcfScene& scene) {
  return Actuators(scene).result();
}

}  // namespace plumbline::exchange
