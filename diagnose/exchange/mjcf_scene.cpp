#include "diagnose/exchange/mjcf_scene.hpp"

#include <algorithm>
#include <cctype>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/mjcf_masses.hpp"
#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Isometry3d, Eigen::Quaterniond, Eigen::Vector3d;
using pugi::xml_node;

std::string name_of(xml_node element, const char* otherwise, std::size_t number) {
  const std::string own = element.attribute("name").value();
  return own.empty() ? otherwise + std::to_string(number + 1) : files::shown(own);
}

/// Elements that stand for bodies which the file does not name.
bool is_macro(const std::string& kind) {
  return kind == "composite" || kind == "flexcomp" || kind == "attach" || kind == "replicate";
}

bool holds_any(xml_node element, const char* kind) {
  return static_cast<bool>(
      element.find_node([&](const xml_node one) { return std::string(one.name()) == kind; }));
}

Vector3d unit(char axis, const std::string& place) {
  switch (std::tolower(static_cast<unsigned char>(axis))) {
    case 'x':
      return Vector3d::UnitX();
    case 'y':
      return Vector3d::UnitY();
    case 'z':
      return Vector3d::UnitZ();
    default:
      throw Error(place, std::string("the axis ") + files::shown(std::string(1, axis)), "x, y or z");
  }
}

}  // namespace

MjcfScene::MjcfScene(const std::filesystem::path& file)
    : document(file), defaults(document.root(), document.file()) {
  if (document.setting("coordinate", "local") == "global")
    throw Error(document.file(), "coordinate=\"global\"", "local coordinates");
  bodies.push_back({{}, "world", 0, Isometry3d::Identity(), Isometry3d::Identity(), {}, 0, Vector3d::Zero()});
  for (const xml_node world : document.root().children("worldbody")) add_contents(world, 0, bodies[0].at);
  for (const xml_node world : document.root().children("worldbody")) add_bodies(world, 0, bodies[0].at);
  scale_masses();
}

std::size_t MjcfScene::last_joint(std::size_t body) const {
  for (; body > 0; body = bodies[body].parent)
    if (!bodies[body].joints.empty()) return bodies[body].joints.back();
  return joints.size();
}

/// What a body holds itself, in frames too.
void MjcfScene::add_contents(xml_node holder, std::size_t body, const Isometry3d& frame) {
  for (const xml_node child : holder.children()) {
    const std::string kind = child.name();
    if (is_macro(kind) && (body > 0 || holds_any(child, "joint") || kind != "replicate"))
      throw Error(place(child), "a " + kind + ", which stands for several", "bodies one by one");
    if (kind == "frame") add_contents(child, body, frame * pose(child));
    if (kind == "joint" || kind == "freejoint") add_joint(child, body, frame);
    if (kind == "site")
      sites.push_back({child, name_of(child, "site ", sites.size()), body, frame, frame * pose(child)});
  }
}

void MjcfScene::add_bodies(xml_node holder, std::size_t body, const Isometry3d& frame) {
  for (const xml_node child : holder.children()) {
    const std::string kind = child.name();
    if (kind == "frame") add_bodies(child, body, frame * pose(child));
    if (kind == "body") add_body(child, body, frame);
  }
}

void MjcfScene::add_body(xml_node element, std::size_t parent, const Isometry3d& frame) {
  const std::size_t own = bodies.size();
  const Isometry3d at = frame * pose(element);
  bodies.push_back({element, name_of(element, "body ", own), parent, at, frame, {}, 0, at.translation()});
  add_contents(element, own, at);
  weigh(element, own);
  add_bodies(element, own, at);
}

void MjcfScene::add_joint(xml_node element, std::size_t body, const Isometry3d& frame) {
  MjcfJoint joint{element, name_of(element, "joint ", joints.size()), "free", body, {}, {}, 0, 0, 0};
  joint.axis = Vector3d::UnitZ();
  joint.anchor = frame.translation();
  if (std::string(element.name()) == "joint") {
    const auto type = defaults.attribute(element, "type");
    joint.type = type ? type.value() : "hinge";
    joint.axis = frame.linear() * defaults.vector(element, "axis", Vector3d::UnitZ());
    joint.anchor = frame * defaults.vector(element, "pos", Vector3d::Zero());
    if (!(joint.axis.norm() > 1e-14)) throw Error(place(element), "an axis of no length", "a direction");
    joint.axis.normalize();
    const bool turns = joint.type == "hinge";
    const auto coordinate = [&](const char* name) {
      const double value = defaults.number(element, name, 0);
      return turns ? document.radians(value) : value;
    };
    joint.ref = coordinate("ref");
    joint.springref = coordinate("springref");
    joint.stiffness = spring_of(joint);
    read_range(joint);
  }
  bodies[body].joints.push_back(joints.size());
  joints.push_back(std::move(joint));
}

/// Where nothing says whether a range holds, MuJoCo 3 takes it that it does.
void MjcfScene::read_range(MjcfJoint& joint) const {
  const auto limited = defaults.attribute(joint.element, "limited");
  if (limited && std::string(limited.value()) == "false") return;
  if (joint.type != "hinge" && joint.type != "slide") return;
  const std::vector<double> range = defaults.numbers(joint.element, "range", 2, 2, {});
  for (std::size_t i = 0; i < range.size(); ++i)
    joint.range[i] = joint.type == "hinge" ? document.radians(range[i]) : range[i];
}

double MjcfScene::spring_of(const MjcfJoint& joint) {
  const std::vector<double> damped = defaults.numbers(joint.element, "springdamper", 2, 2, {0, 0});
  if (damped[0] > 0 && damped[1] > 0)
    throw Error(place(joint.element), "springdamper, a stiffness that goes with the inertia", "stiffness");
  // MuJoCo 3 has polynomials: the stiffness at ease, and how it grows.
  const std::vector<double> said = defaults.numbers(joint.element, "stiffness", 1, 3, {0});
  if (std::any_of(said.begin() + 1, said.end(), [](double growth) { return growth != 0; }))
    left_out.push_back("growth of the stiffness of " + joint.name);
  if (said.front() != 0 && (document.disabled("spring") || document.disabled("passive"))) {
    left_out.push_back("spring of " + joint.name + ", which <flag> switches off");
    return 0;
  }
  return said.front();
}

void MjcfScene::weigh(xml_node element, std::size_t body) {
  const MjcfMass mass = mass_of(element, *this);
  MjcfBody& own = bodies[body];
  own.mass = mass.mass;
  own.middle = own.at * mass.middle;
  if (mass.unknown > 0 && last_joint(body) < joints.size())
    left_out.push_back("mass of " + std::to_string(mass.unknown) + " meshes of " + own.name);
  const double carried = defaults.number(element, "gravcomp", 0);
  if (carried == 0 || own.mass == 0) return;
  left_out.push_back(std::to_string(std::lround(100 * carried)) + " % of the weight of " + own.name +
                     ", which gravcomp carries");
  own.mass *= 1 - carried;
}

void MjcfScene::scale_masses() {
  const double wanted = number_in(document.setting("settotalmass", "-1"), document.file() + ": settotalmass");
  double total = 0;
  for (const MjcfBody& body : bodies) total += body.mass;
  if (!(wanted > 0) || !(total > 0)) return;
  for (MjcfBody& body : bodies) body.mass *= wanted / total;
}

Quaterniond MjcfScene::orientation(xml_node element) const {
  const auto words = [&](const char* name, std::size_t count) {
    return defaults.numbers(element, name, count, count, {});
  };
  const auto said = [&](const char* name) { return static_cast<bool>(defaults.attribute(element, name)); };
  if (said("quat")) {
    const std::vector<double> q = words("quat", 4);
    const Quaterniond turn(q[0], q[1], q[2], q[3]);
    if (!(turn.norm() > 1e-14)) throw Error(place(element), "a quaternion of no length", "one of length 1");
    return turn.normalized();
  }
  if (said("axisangle")) {
    const std::vector<double> a = words("axisangle", 4);
    return Quaterniond(Eigen::AngleAxisd(document.radians(a[3]), Vector3d(a[0], a[1], a[2]).normalized()));
  }
  if (said("xyaxes")) {
    const std::vector<double> a = words("xyaxes", 6);
    const Vector3d x = Vector3d(a[0], a[1], a[2]).normalized(), given(a[3], a[4], a[5]);
    const Vector3d y = (given - given.dot(x) * x).normalized();
    Eigen::Matrix3d turn;
    turn << x, y, x.cross(y);
    if (!turn.allFinite() || std::abs(turn.determinant() - 1) > 1e-6)
      throw Error(place(element), "xyaxes in one direction", "two directions");
    return Quaterniond(turn);
  }
  if (said("zaxis"))
    return Quaterniond::FromTwoVectors(Vector3d::UnitZ(),
                                       defaults.vector(element, "zaxis", Vector3d::UnitZ()));
  Quaterniond turn = Quaterniond::Identity();
  if (!said("euler")) return turn;
  const std::vector<double> angles = words("euler", 3);
  const std::string sequence = document.setting("eulerseq", "xyz");
  if (sequence.size() != 3) throw Error(document.file(), "eulerseq " + files::shown(sequence), "three axes");
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::AngleAxisd one(document.radians(angles[i]),
                                unit(sequence[i], document.file() + ": eulerseq"));
    const bool moving = std::islower(static_cast<unsigned char>(sequence[i])) != 0;
    turn = moving ? Quaterniond(turn * one) : Quaterniond(one * turn);
  }
  return turn;
}

Isometry3d MjcfScene::pose(xml_node element) const {
  Isometry3d at = Isometry3d::Identity();
  at.translate(defaults.vector(element, "pos", Vector3d::Zero()));
  at.rotate(orientation(element));
  return at;
}

}  // namespace plumbline::exchange
