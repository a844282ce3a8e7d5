#include "diagnose/exchange/mjcf_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::exchange {
namespace {

Xml weighted_sum(const std::string& name, const std::vector<std::pair<std::string, double>>& joints) {
  Xml xml("fixed");
  xml.set("name", name);
  for (const auto& [joint, share] : joints)
    xml.add(Xml("joint").set("joint", joint).set("coef", number(share)));
  return xml;
}

Xml tendon(const Tendon& one) {
  Xml xml = weighted_sum(one.name, one.joints);
  if (one.stiffness > 0) xml.set("stiffness", number(one.stiffness));
  if (one.friction > 0) xml.set("frictionloss", number(one.friction));
  return xml;
}

/// An actuator that no control drives: its force is first + second · length.
Xml free_actuator(const std::string& name, double first, double second) {
  Xml xml("general");
  xml.set("name", name).set("gainprm", "0").set("biastype", "affine");
  return std::move(xml.set("biasprm", numbers({first, second, 0})));
}

/// (angle - rest) to its power, by powers of the angle.
std::array<double, 5> polynomial(const Follower& one) {
  const double r = one.rest;
  if (one.power == 2) return {r * r, -2 * r, 1, 0, 0};
  return {r * r * r * r, -4 * r * r * r, 6 * r * r, -4 * r, 1};
}

void add_follower(const Follower& one, Xml& equality, Xml& actuator) {
  const std::array<double, 5> coefficients = polynomial(one);
  equality.add(Xml("joint")
                   .set("name", one.slide)
                   .set("joint1", one.slide)
                   .set("joint2", one.hinge)
                   .set("polycoef", numbers({coefficients.begin(), coefficients.end()})));
  if (one.force != 0) actuator.add(free_actuator(one.slide, one.force, 0).set("joint", one.slide));
}

void add_ramp(const Ramp& one, Xml& tendons, Xml& actuator) {
  const double slope = one.torque / (one.to - one.from);
  if (slope == 0) return;
  Xml xml = free_actuator(one.name, -slope * one.from, slope);
  xml.set("forcelimited", "true")
      .set("forcerange", numbers({std::min(0.0, one.torque), std::max(0.0, one.torque)}));
  if (one.joints.size() == 1 && one.joints.front().second == 1) {
    xml.set("joint", one.joints.front().first);
  } else {
    tendons.add(weighted_sum(one.name, one.joints));
    xml.set("tendon", one.name);
  }
  actuator.add(std::move(xml));
}

std::vector<Xml> not_empty(std::vector<Xml> sections) {
  std::erase_if(sections, [](const Xml& one) { return one.empty(); });
  return sections;
}

Xml slide(const std::string& name, const char* axis) {
  return std::move(Xml("joint").set("name", name).set("type", "slide").set("axis", axis));
}

constexpr std::array<const char*, 2> axes{"1 0 0", "0 1 0"};

/// Where the joints that are read stand when the force is zero, so that they read the bias.
Pair shifts(const Drive& drive) {
  const auto [a, b, c, d] = drive.matrix;
  const double k = -drive.stiffness * (a * d - b * c);
  return {(d * drive.bias[0] - b * drive.bias[1]) / k, (a * drive.bias[1] - c * drive.bias[0]) / k};
}

/// Two slides, stiff or damped.
void add_slides(Xml& body, const std::string& prefix, Pair rest, double stiffness, double damping,
                double armature) {
  for (std::size_t i = 0; i < 2; ++i) {
    Xml one = slide(prefix + (i == 0 ? "_x" : "_y"), axes[i]);
    if (rest[i] != 0) one.set("ref", number(rest[i])).set("springref", number(rest[i]));
    if (stiffness > 0) one.set("stiffness", number(stiffness));
    body.add(std::move(one.set("damping", number(damping)).set("armature", number(armature))));
  }
}

/// What the lag's spring pulls with is nothing beside the cell's.
constexpr double weak = 1e-4;

/// A weighted sum of how far the cell gave way: what one of its channels reads.
Xml reading(const Drive& drive, std::size_t row) {
  const std::string joints = drive.lag > 0 ? "lag" : "cell";
  std::vector<std::pair<std::string, double>> sum{
      {joints + "_x", -drive.stiffness * drive.matrix[2 * row]},
      {joints + "_y", -drive.stiffness * drive.matrix[2 * row + 1]}};
  if (drive.drift[row] != 0) sum.emplace_back("clock", drive.drift[row]);
  return weighted_sum(row == 0 ? "Fx" : "Fy", sum);
}

/// A list of numbers that scripts find by its name; MuJoCo's dynamics knows nothing of it.
void note(Xml& custom, const std::string& name, const std::vector<double>& values) {
  if (!values.empty()) custom.add(Xml("numeric").set("name", name).set("data", numbers(values)));
}

Pair turned(Pair v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v[0] - s * v[1], s * v[0] + c * v[1]};
}

}  // namespace

std::string rigid_reference() {
  return number(2 * mjcf_timestep) + " 1";
}

std::string rigid_impedance() {
  return "0.9999 0.9999 0.001";
}

Xml mjcf_joint(const Hinge& hinge) {
  Xml xml("joint");
  xml.set("name", hinge.name).set("type", hinge.along == 'z' ? "hinge" : "slide");
  xml.set("axis", hinge.along == 'x' ? "1 0 0" : hinge.along == 'y' ? "0 1 0" : "0 0 1");
  if (hinge.stiffness != 0) xml.set("stiffness", number(hinge.stiffness));
  if (hinge.rest != 0) xml.set("springref", number(hinge.rest));
  if (hinge.range) xml.set("limited", "true").set("range", numbers({(*hinge.range)[0], (*hinge.range)[1]}));
  if (hinge.friction > 0) xml.set("frictionloss", number(hinge.friction));
  if (hinge.damping > 0) xml.set("damping", number(hinge.damping));
  if (hinge.armature > 0) xml.set("armature", number(hinge.armature));
  return xml;
}

Xml mjcf_inertial(double mass, Pair middle) {
  return std::move(Xml("inertial")
                       .set("pos", numbers({middle[0], middle[1], 0}))
                       .set("mass", number(mass))
                       .set("diaginertia", "1e-09 1e-09 1e-09"));
}

std::vector<Xml> mjcf_couplings(const Tree& tree) {
  Xml tendons("tendon"), equality("equality"), actuator("actuator");
  for (const Tendon& one : tree.tendons) tendons.add(tendon(one));
  for (const Follower& one : tree.followers) add_follower(one, equality, actuator);
  for (const Ramp& one : tree.ramps) add_ramp(one, tendons, actuator);
  return not_empty({std::move(tendons), std::move(equality), std::move(actuator)});
}

Xml mjcf_rail(const Drive& drive, Pair reference) {
  const double k = drive.stiffness, damping = 2 * k * response_time,
               armature = k * response_time * response_time;
  const Pair along = turned({reference[0] - drive.start[0], reference[1] - drive.start[1]}, -drive.turned);
  Xml rail("body"), led("body"), cell("body");
  rail.set("name", "rail").set("pos", numbers({drive.start[0], drive.start[1], 0}));
  rail.set("quat", numbers({std::cos(drive.turned / 2), 0, 0, std::sin(drive.turned / 2)}));
  led.set("name", "drive").set("pos", numbers({along[0], along[1], 0}));
  for (std::size_t i = 0; i < 2; ++i)
    led.add(slide(i == 0 ? "drive_x" : "drive_y", axes[i])
                .set("ref", number(drive.start[i] + along[i]))
                .set("springref", number(drive.start[i]))
                .set("damping", number(damping))
                .set("armature", number(armature)));
  led.add(mjcf_inertial(speck));
  cell.set("name", "cell");
  add_slides(cell, "cell", drive.lag > 0 ? Pair{0, 0} : shifts(drive), k, damping, armature);
  cell.add(mjcf_inertial(speck));
  led.add(std::move(cell));
  if (drive.lag > 0) {
    Xml late("body");
    late.set("name", "lag");
    add_slides(late, "lag", shifts(drive), 0, weak * k * drive.lag,
               weak * k * drive.lag * 1e-3 * response_time);
    led.add(std::move(late.add(mjcf_inertial(speck))));
  }
  return std::move(rail.add(std::move(led)));
}

std::optional<Xml> mjcf_clock(const Drive& drive) {
  if (drive.drift == Pair{0, 0}) return {};
  Xml body("body");
  body.set("name", "clock");
  body.add(slide("clock", "0 0 1").set("damping", "1").set("armature", "0.001"));
  return std::move(body.add(mjcf_inertial(speck)));
}

std::vector<Xml> mjcf_drive(const Drive& drive, const std::string& tip, const std::vector<double>& grip) {
  Xml tendons("tendon"), equality("equality"), actuator("actuator"), sensor("sensor");
  equality.add(
      Xml("connect").set("name", "grip").set("body1", tip).set("body2", "cell").set("anchor", numbers(grip)));
  if (drive.friction > 0)
    tendons.add(
        weighted_sum("guide", {{"drive_x", 1}, {"cell_x", 1}}).set("frictionloss", number(drive.friction)));
  for (std::size_t row = 0; row < 2; ++row) tendons.add(reading(drive, row));
  if (drive.lag > 0)
    for (const char* axis : {"_x", "_y"})
      tendons.add(weighted_sum(std::string("lag") + axis,
                               {{std::string("lag") + axis, 1}, {std::string("cell") + axis, -1}})
                      .set("stiffness", number(weak * drive.stiffness)));
  for (const char* axis : {"x", "y"}) {
    const std::string joint = std::string("drive_") + axis;
    actuator.add(Xml("position").set("name", joint).set("joint", joint).set("kp", number(drive.stiffness)));
    sensor.add(Xml("jointpos").set("name", axis).set("joint", joint));
  }
  if (drive.drift != Pair{0, 0}) actuator.add(free_actuator("clock", 1, 0).set("joint", "clock"));
  for (const char* force : {"Fx", "Fy"}) {
    Xml one("tendonpos");
    one.set("name", force).set("tendon", force);
    if (drive.limit > 0) one.set("cutoff", number(drive.limit));
    sensor.add(std::move(one));
  }
  return not_empty({std::move(tendons), std::move(equality), std::move(actuator), std::move(sensor)});
}

Xml mjcf_beside(const Model& model, const std::vector<Carried>& effects) {
  Xml custom("custom");
  for (std::size_t e = 0; e < model.experiment.effects.size(); ++e)
    for (const auto& [name, value] : model.experiment.effects[e].parameters)
      if (!effects[e].carried) note(custom, effects[e].effect + " " + name, {value});
  return custom;
}

}  // namespace plumbline::exchange
