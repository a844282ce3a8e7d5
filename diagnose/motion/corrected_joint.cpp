#include "diagnose/motion/corrected_joint.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/edit_servo.hpp"
#include "diagnose/exchange/format.hpp"
#include "diagnose/exchange/mjcf_servos.hpp"
#include "diagnose/exchange/read_sdf.hpp"
#include "diagnose/exchange/read_urdf.hpp"
#include "diagnose/motion/joint_law.hpp"

namespace plumbline::motion {
namespace {

using exchange::Format, exchange::number, exchange::set, exchange::set_child, exchange::Carried,
    exchange::Written;
using pugi::xml_node;

/// What each format has for an effect; what is not here, none has.
enum class Word { mjcf, urdf, sdf, bam };
using Words = std::map<Word, const char*>;

const Words* words_of(const std::string& effect) {
  static const std::map<std::string, Words> all{
      {"command_delay", {{Word::mjcf, "delay of the actuator (MuJoCo 4)"}, {Word::bam, "command_delay"}}},
      {"armature", {{Word::mjcf, "armature of the joint"}, {Word::bam, "armature"}}},
      {"joint_friction",
       {{Word::mjcf, "frictionloss of the joint"},
        {Word::urdf, "friction of <dynamics>"},
        {Word::sdf, "friction of <dynamics>"},
        {Word::bam, "friction_base"}}},
      {"viscous_friction",
       {{Word::mjcf, "damping of the joint"},
        {Word::urdf, "damping of <dynamics>"},
        {Word::sdf, "damping of <dynamics>"},
        {Word::bam, "friction_viscous"}}},
      {"back_emf",
       {{Word::mjcf, "damping of the joint"},
        {Word::urdf, "damping of <dynamics>"},
        {Word::sdf, "damping of <dynamics>"},
        {Word::bam, "kt and R"}}},
      {"stall_torque",
       {{Word::mjcf, "kp and forcerange of the servo"},
        {Word::urdf, "effort of <limit>"},
        {Word::sdf, "effort of <limit>"},
        {Word::bam, "kt and R"}}},
      {"duty_limit",
       {{Word::mjcf, "forcerange of the servo"},
        {Word::urdf, "effort of <limit>"},
        {Word::sdf, "effort of <limit>"}}},
      {"derivative_gain", {{Word::mjcf, "kv of the servo (MuJoCo 3)"}}},
      {"command_offset", {{Word::mjcf, "bias of the servo"}}},
      {"encoder_zero", {{Word::mjcf, "ref of the joint"}}},
      {"spring",
       {{Word::mjcf, "stiffness and springref of the joint"},
        {Word::sdf, "spring_stiffness and spring_reference"}}},
  };
  const auto found = all.find(effect);
  return found == all.end() ? nullptr : &found->second;
}

/// The effects of the cause that is named first, with what became of them.
std::vector<Carried> carried(const Diagnosis& diagnosis, Word format) {
  std::vector<Carried> all;
  if (diagnosis.causes.empty()) return all;
  for (const NamedEffect& effect : diagnosis.causes.front().effects) {
    const Words* words = words_of(effect.id);
    if (words != nullptr && words->count(format) > 0) {
      all.push_back({effect.id, true, words->at(format)});
      continue;
    }
    std::string values;
    for (const Estimate& one : effect.values)
      values += fmt::format("{}{} = {:.5g} {}", values.empty() ? "" : ", ", one.name, one.value, one.unit);
    all.push_back({effect.id, false, "the format has no word for it: " + values});
  }
  return all;
}

std::vector<std::string> head(const Diagnosis& diagnosis, const std::vector<Carried>& effects) {
  std::vector<std::string> lines{"Corrected by what was found in logs of " + diagnosis.name + "."};
  for (const Carried& one : effects)
    lines.push_back(fmt::format("{}{}: {}", one.carried ? "" : "Not carried: ", one.effect, one.how));
  return lines;
}

/// The torque over speed of a servo, beside its gain.
void set_gain_of_speed(xml_node servo, double gain, const std::string& file) {
  if (std::string(servo.name()) != "general") {
    set(servo, "kv", number(gain));
    return;
  }
  std::vector<double> bias = exchange::numbers_in(servo.attribute("biasprm").value(),
                                                  exchange::place_of(file, servo) + ": biasprm", 2, 10);
  bias.resize(std::max<std::size_t>(3, bias.size()));
  bias[2] = -gain;
  set(servo, "biasprm", exchange::numbers(bias));
}

Written written_mjcf(const Bench& bench, const Diagnosis& diagnosis) {
  exchange::MjcfScene scene(bench.model.file);
  const std::string& file = scene.document.file();
  std::size_t j = scene.joints.size();
  for (std::size_t k = 0; k < scene.joints.size(); ++k)
    if (scene.joints.size() == 1 || scene.joints[k].name == bench.model.joint) j = k;
  if (j == scene.joints.size())
    throw Error(file, "no joint '" + bench.model.joint + "'", "the joint that model.joint names");
  const JointLaw law = joint_law(bench, diagnosis.drive, servo_gain(bench));
  const exchange::MjcfJoint& joint = scene.joints[j];
  xml_node own = joint.element;
  set(own, "armature", number(law.armature));
  set(own, "frictionloss", number(law.friction));
  set(own, "damping", number(law.damping));
  const double reference = joint.ref - law.zero_moves;
  if (law.zero_moves != 0) set(own, "ref", number(scene.document.angle(reference)));
  if (law.stiffness != 0) {
    set(own, "stiffness", number(law.stiffness));
    set(own, "springref", number(scene.document.angle(reference)));
  }
  bool has_servo = false;
  for (const exchange::MjcfServo& servo : exchange::actuators_of(scene).servos) {
    if (servo.joint != j) continue;
    has_servo = true;
    exchange::edit_servo(servo, law.gain / servo.stiffness(), law.command_moves, file);
    xml_node element = servo.element;
    if (law.gain_of_speed != 0)
      set_gain_of_speed(element, law.gain_of_speed / (servo.gear * servo.gear), file);
    const double force = law.torque_limit / std::abs(servo.gear);
    set(element, "forcerange", exchange::numbers({-force, force}));
    if (law.delay == 0) continue;
    const double step =
        std::stod(scene.document.root().child("option").attribute("timestep").as_string("0.002"));
    set(element, "delay", number(law.delay));
    set(element, "interp", "linear");
    set(element, "nsample", fmt::format("{}", static_cast<int>(std::ceil(law.delay / step)) + 1));
  }
  if (!has_servo)
    throw Error(file, "no position servo at the joint " + joint.name,
                "one, whose kp and forcerange are found");
  const std::vector<Carried> effects = carried(diagnosis, Word::mjcf);
  return {scene.document.text(head(diagnosis, effects)), effects};
}

/// The joint of this name, or the only one that moves.
template <class Children>
xml_node moving_joint(const Children& joints, const std::string& file, const std::string& name) {
  std::vector<xml_node> moving;
  for (const xml_node one : joints)
    if (name.empty() ? std::string(one.attribute("type").value()) != "fixed"
                     : one.attribute("name").value() == name)
      moving.push_back(one);
  if (moving.size() != 1)
    throw Error(file,
                name.empty() ? fmt::format("{} joints that move", moving.size()) : "no joint '" + name + "'",
                "the one that model.joint names");
  return moving.front();
}

xml_node child_of(xml_node parent, const char* name) {
  const xml_node own = parent.child(name);
  return own ? own : parent.append_child(name);
}

Written written_urdf(const Bench& bench, const Diagnosis& diagnosis) {
  exchange::UrdfTree tree(bench.model.file);
  const JointLaw law = joint_law(bench, diagnosis.drive, 1);
  const xml_node joint = moving_joint(tree.root().children("joint"), tree.file(), bench.model.joint);
  set(child_of(joint, "dynamics"), "damping", number(law.damping));
  set(child_of(joint, "dynamics"), "friction", number(law.friction));
  if (joint.child("limit")) set(joint.child("limit"), "effort", number(law.torque_limit));
  const std::vector<Carried> effects = carried(diagnosis, Word::urdf);
  std::vector<std::string> lines = head(diagnosis, effects);
  lines.push_back(
      fmt::format("Inertia of the rotor, which a joint of URDF has not: {:.6g} kg m^2.", law.armature));
  return {tree.source.text(lines), effects};
}

Written written_sdf(const Bench& bench, const Diagnosis& diagnosis) {
  exchange::SdfTree tree(bench.model.file);
  const JointLaw law = joint_law(bench, diagnosis.drive, 1);
  const xml_node joint = moving_joint(tree.model.children("joint"), tree.file(), bench.model.joint);
  const xml_node axis = child_of(joint, "axis"), dynamics = child_of(axis, "dynamics");
  set_child(dynamics, "damping", number(law.damping));
  set_child(dynamics, "friction", number(law.friction));
  if (law.stiffness != 0) {
    set_child(dynamics, "spring_reference", number(-law.zero_moves));
    set_child(dynamics, "spring_stiffness", number(law.stiffness));
  }
  set_child(child_of(axis, "limit"), "effort", number(law.torque_limit));
  const std::vector<Carried> effects = carried(diagnosis, Word::sdf);
  std::vector<std::string> lines = head(diagnosis, effects);
  lines.push_back(
      fmt::format("Inertia of the rotor, which a joint of SDF has not: {:.6g} kg m^2.", law.armature));
  return {tree.source.text(lines), effects};
}

/// Duquesne, Passault and others' six models of servos: the first has dry and viscous friction, and a delay.
Written written_bam(const Bench& bench, const Diagnosis& diagnosis) {
  const JointLaw law = joint_law(bench, diagnosis.drive, 1);
  if (!(law.back_emf > 0))
    throw Error(bench.name + ": drive.back_emf", "none",
                "a torque that is lost with speed, from which BAM's constant kt and resistance R follow");
  const double kt = law.back_emf / law.stall_torque;
  const nlohmann::ordered_json parameters{{"model", "m1"},
                                          {"actuator", bench.model.actuator},
                                          {"kt", kt},
                                          {"R", kt / law.stall_torque},
                                          {"armature", law.armature},
                                          {"q_offset", law.zero},
                                          {"command_delay", law.delay},
                                          {"friction_base", law.friction},
                                          {"friction_viscous", law.viscous}};
  return {parameters.dump(1) + "\n", carried(diagnosis, Word::bam)};
}

}  // namespace

exchange::Written corrected_joint(const Bench& bench, const Diagnosis& diagnosis,
                                  const std::filesystem::path& path) {
  if (path.extension() == ".json") return written_bam(bench, diagnosis);
  const Format format = exchange::format_of(path);
  if (bench.model.file.empty() || bench.model.file.extension() != path.extension())
    throw Error(bench.name + ": model.file", bench.model.file.empty() ? "none" : bench.model.file.string(),
                "the model that " + path.extension().string() + " corrects");
  switch (format) {
    case Format::mjcf:
      return written_mjcf(bench, diagnosis);
    case Format::urdf:
      return written_urdf(bench, diagnosis);
    case Format::sdf:
      return written_sdf(bench, diagnosis);
    case Format::toml:
      break;
  }
  throw Error(path.string(), "a model of ours", "a file of .xml (MJCF), .urdf, .sdf, or .json (BAM)");
}

}  // namespace plumbline::motion
