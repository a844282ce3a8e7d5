#include "diagnose/exchange/mjcf_document.hpp"

#include <map>
#include <numbers>
#include <plumbline/base/error.hpp>
#include <utility>

#include "diagnose/exchange/mjcf_parts.hpp"

namespace plumbline::exchange {
namespace {

using pugi::xml_node;
using Attributes = std::vector<std::pair<const char*, std::string>>;

/// Replaces every <include> by what its file's root holds.
void include(xml_node parent, const std::filesystem::path& folder) {
  for (xml_node child = parent.first_child(); child;) {
    const xml_node next = child.next_sibling();
    if (std::string(child.name()) == "include") {
      pugi::xml_document other;
      parse(folder / child.attribute("file").value(), other);
      include(other.document_element(), folder);
      for (const xml_node one : other.document_element()) parent.insert_copy_before(one, child);
      parent.remove_child(child);
    } else {
      include(child, folder);
    }
    child = next;
  }
}

/// What MuJoCo takes where neither the element nor a default says anything; constraints as good as rigid.
const Attributes& as_without_defaults(const xml_node element) {
  static const Attributes none;
  static const std::string reference = rigid_reference(), impedance = rigid_impedance();
  static const Attributes joint{{"type", "hinge"},
                                {"pos", "0 0 0"},
                                {"axis", "0 0 1"},
                                {"ref", "0"},
                                {"springref", "0"},
                                {"stiffness", "0"},
                                {"damping", "0"},
                                {"frictionloss", "0"},
                                {"armature", "0"},
                                {"limited", "false"},
                                {"margin", "0"},
                                {"springdamper", "0 0"},
                                {"solreflimit", reference},
                                {"solimplimit", impedance},
                                {"solreffriction", reference},
                                {"solimpfriction", impedance}};
  static const Attributes tendon{
      {"limited", "false"},         {"stiffness", "0"},     {"damping", "0"},
      {"frictionloss", "0"},        {"springlength", "-1"}, {"solreffriction", reference},
      {"solimpfriction", impedance}};
  static const Attributes equality{{"active", "true"}, {"solref", reference}, {"solimp", impedance}};
  static const Attributes actuator{
      {"ctrllimited", "false"}, {"forcelimited", "false"}, {"gear", "1 0 0 0 0 0"}};
  const std::string name = element.name(), parent = element.parent().name();
  if (name == "joint" && parent == "body") return joint;
  if (name == "fixed") return tendon;
  if (parent == "equality") return equality;
  return parent == "actuator" ? actuator : none;
}

void add_what_is_silent(xml_node element) {
  for (const auto& [name, value] : as_without_defaults(element))
    if (!element.attribute(name)) element.append_attribute(name) = value.c_str();
  for (const xml_node child : element.children()) add_what_is_silent(child);
}

}  // namespace

MjcfDocument::MjcfDocument(const std::filesystem::path& file) : file_(file.string()) {
  parse(file, document_);
  include(document_.document_element(), file.parent_path());
  for (const xml_node compiler : root().children("compiler")) {
    if (const auto angle = compiler.attribute("angle")) degrees_ = std::string(angle.value()) != "radian";
    if (std::string(compiler.attribute("coordinate").value()) == "global")
      throw Error(file_, "coordinate=\"global\"", "local coordinates");
    if (std::string(compiler.attribute("inertiafromgeom").value()) == "true")
      throw Error(file_, "inertiafromgeom=\"true\"", "bodies that may have an inertia of their own");
  }
  number();
}

void MjcfDocument::number() {
  bodies.assign(1, {});  // the world, of which there may be several parts
  joints.clear();
  sites.clear();
  for (const xml_node world : root().children("worldbody")) {
    if (!bodies.front()) bodies.front() = world;
    number(world);
  }
}

void MjcfDocument::number(xml_node body) {
  for (const xml_node child : body.children()) {
    const std::string name = child.name();
    if (name == "joint" || name == "freejoint") joints.push_back(child);
    if (name == "site") sites.push_back(child);
    if (name == "composite" || name == "frame") throw Error(file_, "a " + name, "bodies one by one");
  }
  for (const xml_node child : body.children("body")) {
    bodies.push_back(child);
    number(child);
  }
}

double MjcfDocument::angle(double radians) const {
  return degrees_ ? radians * 180 / std::numbers::pi : radians;
}

xml_node MjcfDocument::append(xml_node parent, const Xml& element) {
  const xml_node added = exchange::append(parent, element);
  add_what_is_silent(added);
  return added;
}

xml_node MjcfDocument::insert_before(xml_node sibling, const Xml& element) {
  const xml_node added = append(sibling.parent(), element);
  return sibling.parent().insert_move_before(added, sibling);
}

}  // namespace plumbline::exchange
