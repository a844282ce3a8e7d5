#include <numbers>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/roll_pitch_yaw.hpp"
#include "diagnose/exchange/physical_body.hpp"
#include "diagnose/exchange/read_sdf.hpp"
#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d;
using pugi::xml_node;

bool is_on(xml_node element, const char* child) {
  const std::string text = text_in(element, child);
  return text == "true" || text == "1";
}

}  // namespace

Isometry3d written_pose(xml_node element, const std::string& place) {
  Isometry3d at = Isometry3d::Identity();
  const xml_node pose = element.child("pose");
  const std::string text = pose.text().get();
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) return at;
  const bool quaternion = std::string(pose.attribute("rotation_format").value()) == "quat_xyzw";
  const std::size_t count = quaternion ? 7 : 6;
  const std::vector<double> p = numbers_in(text, place + ": pose", count, count);
  at.translate(Vector3d(p[0], p[1], p[2]));
  if (quaternion) {
    const Eigen::Quaterniond turn(p[6], p[3], p[4], p[5]);
    if (!(turn.norm() > 1e-14)) throw Error(place + ": pose", "a quaternion of no length", "one of length 1");
    at.rotate(turn.normalized());
    return at;
  }
  const std::string degrees = pose.attribute("degrees").value();
  const double unit = degrees == "true" || degrees == "1" ? std::numbers::pi / 180 : 1;
  if (unit == 1) require_radians({p[3], p[4], p[5]}, place + ": pose");
  at.rotate(diagnose::from_roll_pitch_yaw(unit * Vector3d(p[3], p[4], p[5])));
  return at;
}

SdfTree::SdfTree(const std::filesystem::path& file) : source(file), file_(file.string()) {
  const xml_node root = source.document.document_element();
  if (std::string(root.name()) != "sdf")
    throw Error(file_, "the root <" + files::shown(root.name()) + ">", "the root <sdf> of SDF");
  const std::string version = root.attribute("version").value();
  version_ = static_cast<int>(number_in(version.substr(version.find('.') + 1), file_ + ": version"));
  find_model();
  add_parts(model, "");
  find_holders();
}

void SdfTree::find_model() {
  const xml_node root = source.document.document_element();
  world = root.child("world");
  std::vector<xml_node> moving;
  for (const xml_node one : (world ? world : root).children("model"))
    if (!is_on(one, "static")) moving.push_back(one);
  if (moving.size() != 1)
    throw Error(file_, std::to_string(moving.size()) + " models that move", "one model");
  model = moving.front();
  placed_ = written_pose(model, place_of(file_, model));
}

void SdfTree::add_parts(xml_node holder, const std::string& scope) {
  if (holder.child("include"))
    throw Error(place_of(file_, holder), "an <include>", "links and joints in the file itself");
  if (holder.attribute("placement_frame"))
    throw Error(place_of(file_, holder), "a placement_frame", "a pose of the model's own frame");
  for (const xml_node child : holder.children()) {
    const std::string kind = child.name(), name = scope + child.attribute("name").value();
    if (kind != "link" && kind != "joint" && kind != "frame" && kind != "model") continue;
    if (!parts_.emplace(name, Part{child, scope}).second)
      throw Error(file_, "two parts " + files::shown(name), "a name for each");
    if (kind == "model") add_parts(child, name + "::");
  }
}

void SdfTree::find_holders() {
  for (const auto& [name, part] : parts_) {
    if (std::string(part.element.name()) != "joint") continue;
    const std::string child = link_of(named_by(part, "child"));
    static_cast<void>(link_of(named_by(part, "parent")));
    if (!holders_.emplace(child, name).second)
      throw Error(file_, "link " + files::shown(child) + " on two joints", "a serial chain");
  }
}

const SdfTree::Part& SdfTree::part(const std::string& name) const {
  const auto own = parts_.find(name);
  if (own == parts_.end())
    throw Error(file_, "no link, joint or frame \"" + files::shown(name) + "\"", "the name of one");
  return own->second;
}

std::string SdfTree::resolved(const std::string& name, const std::string& scope) const {
  if (name == "world" || name == "__root__") return "world";
  // Of the frame of a model as such the model itself is the part.
  if (name == "__model__" || name.empty()) return scope.empty() ? "" : scope.substr(0, scope.size() - 2);
  return name.ends_with("::__model__") ? scope + name.substr(0, name.size() - 11) : scope + name;
}

std::string SdfTree::named_by(const Part& one, const char* child) const {
  return resolved(text_in(one.element, child), one.scope);
}

std::string SdfTree::base_of(const Part& one) const {
  const xml_node pose = one.element.child("pose");
  for (const char* said : {"relative_to", "frame"})
    if (const auto frame = pose.attribute(said); frame && *frame.value() != '\0')
      return resolved(frame.value(), one.scope);
  const std::string kind = one.element.name();
  if (kind == "joint") return named_by(one, "child");
  return resolved(kind == "frame" ? one.element.attribute("attached_to").value() : "", one.scope);
}

/// Until 1.4 axes counted in the frame of the model, later where a switch says so.
std::string SdfTree::frame_of_axis(const std::string& joint) const {
  const Part& own = part(joint);
  const xml_node axis = own.element.child("axis");
  if (const auto frame = axis.child("xyz").attribute("expressed_in"); frame && *frame.value() != '\0')
    return resolved(frame.value(), own.scope);
  constexpr int first_in_own_frame = 5;
  const bool of_model = is_on(axis, "use_parent_model_frame") || version_ < first_in_own_frame;
  return of_model ? resolved("__model__", own.scope) : joint;
}

Isometry3d SdfTree::pose(const std::string& name) const {
  std::vector<const Part*> open;
  std::vector<std::string> names;
  Isometry3d at = Isometry3d::Identity();
  for (std::string one = name; !one.empty() && one != "world"; one = base_of(*open.back())) {
    if (const auto known = poses_.find(one); known != poses_.end()) {
      at = known->second;
      break;
    }
    if (open.size() > parts_.size())
      throw Error(place_of(file_, part(name).element), "a pose that is said in a circle",
                  "frames from the model on");
    open.push_back(&part(one));
    names.push_back(one);
  }
  for (; !open.empty(); open.pop_back(), names.pop_back()) {
    at = at * written_pose(open.back()->element, place_of(file_, open.back()->element));
    poses_.emplace(names.back(), at);
  }
  return at;
}

std::string SdfTree::link_of(const std::string& name) const {
  std::string own = name;
  for (std::size_t steps = 0; steps <= parts_.size(); ++steps) {
    if (own.empty() || own == "world") return "world";
    const Part& one = part(own);
    const std::string kind = one.element.name();
    if (kind == "link") return own;
    if (kind == "joint") {
      own = named_by(one, "child");
    } else if (kind == "frame") {
      own = resolved(one.element.attribute("attached_to").value(), one.scope);
    }
    if (kind == "model" || own.empty()) {  // the first link of a model is its own
      const xml_node holder = kind == "model" ? one.element : one.element.parent();
      const std::string scope = kind == "model" ? own + "::" : one.scope;
      const auto canonical = holder.attribute("canonical_link");
      own = scope + (canonical ? canonical : holder.child("link").attribute("name")).value();
    }
  }
  throw Error(file_, "the frame " + files::shown(name) + ", attached in a circle", "one attached to a link");
}

std::string SdfTree::holder_of(const std::string& link) const {
  const auto own = holders_.find(link);
  return own == holders_.end() ? "" : own->second;
}

}  // namespace plumbline::exchange
