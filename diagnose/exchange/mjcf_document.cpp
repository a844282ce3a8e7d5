#include "diagnose/exchange/mjcf_document.hpp"

#include <algorithm>
#include <numbers>
#include <plumbline/base/error.hpp>
#include <utility>

#include "diagnose/exchange/mjcf_parts.hpp"
#include "support/files/printable.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::exchange {
namespace {

using pugi::xml_node;
using Attributes = std::vector<std::pair<const char*, std::string>>;

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

/// By which a file is known, whatever way leads to it.
std::string whole_name(const std::filesystem::path& file) {
  std::error_code none;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(file, none);
  return none ? file.string() : whole.string();
}

/// Whether a file lies in a folder or below it, wherever links lead.
bool is_within(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const std::filesystem::path inner = whole_name(file), outer = whole_name(folder.empty() ? "." : folder);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

}  // namespace

MjcfDocument::MjcfDocument(const std::filesystem::path& file) : file_(file.string()), source_(file) {
  const std::string name = root().name();
  if (name != "mujoco")
    throw Error(file_, name == "robot" ? "a URDF" : "the root <" + files::shown(name) + ">",
                name == "robot" ? "MJCF in a file that ends in .xml: URDF ends in .urdf"
                                : "the root <mujoco> of MJCF");
  std::set<std::string> included{whole_name(file)};
  include(root(), file.parent_path(), included);
}

/// Replaces every <include> by what its file's root holds.
void MjcfDocument::include(xml_node parent, const std::filesystem::path& folder,
                           std::set<std::string>& included) {
  for (xml_node child = parent.first_child(); child;) {
    const xml_node next = child.next_sibling();
    if (std::string(child.name()) != "include") {
      include(child, folder, included);
      child = next;
      continue;
    }
    if (*child.attribute("file").value() == '\0')
      throw Error(place_of(file_, child), "no file", "the name of one");
    const std::filesystem::path other_file = folder / child.attribute("file").value();
    if (!is_within(other_file, folder))
      throw Error(place_of(file_, child),
                  "the included file " + files::shown(child.attribute("file").value()) +
                      ", which is not in the model's folder",
                  "files in that folder or below it");
    if (!included.insert(whole_name(other_file)).second)
      throw Error(file_, files::shown(other_file.string()) + " included twice", "each file once");
    pugi::xml_document other;
    parse(files::read_text(other_file), other_file.string(), other);
    include(other.document_element(), folder, included);
    for (const xml_node one : other.document_element()) parent.insert_copy_before(one, child);
    parent.remove_child(child);
    child = next;
  }
}

std::string MjcfDocument::setting(const char* name, const char* otherwise) const {
  std::string said = otherwise;
  for (const xml_node compiler : root().children("compiler"))
    if (const auto own = compiler.attribute(name)) said = own.value();
  return said;
}

bool MjcfDocument::is_on(const char* name, bool otherwise) const {
  return setting(name, otherwise ? "true" : "false") == "true";
}

bool MjcfDocument::disabled(const char* flag) const {
  bool off = false;
  for (const xml_node option : root().children("option"))
    for (const xml_node flags : option.children("flag"))
      if (const auto own = flags.attribute(flag)) off = std::string(own.value()) == "disable";
  return off;
}

bool MjcfDocument::in_degrees() const {
  return setting("angle", "degree") != "radian";
}

double MjcfDocument::angle(double radians) const {
  return in_degrees() ? radians * 180 / std::numbers::pi : radians;
}

double MjcfDocument::radians(double angle) const {
  return in_degrees() ? angle * std::numbers::pi / 180 : angle;
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
