#include "diagnose/exchange/edit_urdf.hpp"

#include <Eigen/Geometry>
#include <map>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/edited_chain.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "diagnose/exchange/urdf_parts.hpp"
#include "diagnose/exchange/xml_document.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Vector3d, Eigen::Isometry3d;
using pugi::xml_node;

Vector3d vector_in(const char* text) {
  const std::vector<double> all = numbers_in(text);
  return all.size() == 3 ? Vector3d(all[0], all[1], all[2]) : Vector3d::Zero();
}

/// xyz and, about fixed axes one after the other, rpy.
Isometry3d origin_of(const xml_node joint) {
  const xml_node origin = joint.child("origin");
  const Vector3d turn = vector_in(origin.attribute("rpy").value());
  Isometry3d at = Isometry3d::Identity();
  at.translate(vector_in(origin.attribute("xyz").value()));
  at.rotate(Eigen::AngleAxisd(turn.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(turn.y(), Vector3d::UnitY()) *
            Eigen::AngleAxisd(turn.x(), Vector3d::UnitX()));
  return at;
}

std::string link_of(const xml_node joint, const char* end) {
  return joint.child(end).attribute("link").value();
}

class UrdfEditor {
 public:
  explicit UrdfEditor(const Model& model)
      : model_(model),
        chain_(model, parsed(model.source, Format::urdf), Format::urdf, {}),
        n_(chain_.size()) {
    parse(model.source, document_);
    for (const xml_node link : root().children("link"))
      if (!holder_of(link.attribute("name").value()))
        place(link.attribute("name").value(), Isometry3d::Identity());
    for (std::size_t j = 0; j <= n_; ++j) find(j);
  }

  Written result() {
    for (std::size_t j = 0; j < n_; ++j) edit_joint(j);
    for (std::size_t j = 0; j <= n_; ++j) hang(j);
    const std::string name = model_.source.filename().string();
    std::vector<std::string> remarks{"Edited: " + name + "."};
    if (const auto weights = chain_.weights()) {
      add_weights(*weights);
      const Vector3d& g = weights->gravity;
      remarks.push_back("URDF knows no gravity: it is to be " + numbers({g.x(), g.y(), g.z()}) +
                        " m/s^2 in the frame of the root link.");
    }
    return {text_of(document_, head_lines(model_, chain_.effects(), remarks)), chain_.effects(),
            name + " with the correction in it"};
  }

 private:
  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    throw Error(model_.source.string(), found, expected);
  }

  [[nodiscard]] xml_node root() const { return document_.document_element(); }

  /// The joint that a link hangs by.
  [[nodiscard]] xml_node holder_of(const std::string& link) const {
    return root().find_child([&](const xml_node one) {
      return std::string(one.name()) == "joint" && link_of(one, "child") == link;
    });
  }

  /// Where a link and all that it carries are in the reference configuration.
  void place(const std::string& link, const Isometry3d& at) {
    places_[link] = at;
    for (const xml_node joint : root().children("joint"))
      if (link_of(joint, "parent") == link) place(link_of(joint, "child"), at * origin_of(joint));
  }

  /// The joint j of the chain; after the last the one that holds the end point.
  void find(std::size_t j) {
    const bool last = j == n_;
    const std::string& end = chain_.read().end_name;  // "link tool_tip"
    const std::string name = last ? end.substr(end.find(' ') + 1) : chain_.joint(j).name;
    xml_node joint = named(root(), "joint", name);
    if (!joint && last) joint = holder_of(name);
    if (!joint || !places_.contains(link_of(joint, "child")))
      refuse("no joint " + name, "the joints and the end point by the names that the file has for them");
    const double away = (places_[link_of(joint, "child")].translation() - place_of(j)).norm();
    constexpr double rounding = 1e-6;
    if (away > rounding)
      refuse("joint " + name + " in another place than its parser has it", "a root link at the origin");
    joints_.push_back(joint);
  }
  [[nodiscard]] Vector3d place_of(std::size_t j) const {
    return j < n_ ? chain_.joint(j).anchor : *chain_.read().end;
  }

  void edit_joint(std::size_t j) {
    const Hinge &old = chain_.before(j), &now = chain_.after(j);
    if (now.stiffness != old.stiffness || now.rest != old.rest) {
      const std::string name = chain_.joint(j).name;
      set_child(spring(name), "springStiffness", number(now.stiffness));
      set_child(spring(name), "springReference", number(chain_.joint(j).rest + chain_.ease_moves(j)));
    }
    if (now.friction == old.friction) return;
    xml_node dynamics = joints_[j].child("dynamics");
    if (!dynamics) dynamics = joints_[j].append_child("dynamics");
    set(dynamics, "friction", number(now.friction));
  }

  /// Where Gazebo's words on a joint stand; those on its spring, if there are any.
  xml_node spring(const std::string& joint) {
    xml_node own;
    for (const xml_node one : root().children("gazebo"))
      if (one.attribute("reference").value() == joint && (!own || one.child("springStiffness"))) own = one;
    if (own) return own;
    own = root().append_child("gazebo");
    set(own, "reference", joint);
    return own;
  }

  /// Joint j on what carries it, with what is added between.
  void hang(std::size_t j) {
    xml_node own = joints_[j];
    const std::string parent = link_of(own, "parent");
    const Eigen::Matrix3d turn = places_.at(parent).linear().transpose();
    const Vector3d none = Vector3d::Zero(), carried = j > 0 ? chain_.moves(j - 1) : none,
                   base = j > 0 ? none : chain_.base_moves();
    Vector3d from = places_.at(parent).translation() + carried;
    std::string last = parent;
    for (const EditedChain::Added& one : chain_.in_series()) {
      if (one.before != j) continue;
      const Vector3d to = one.place + base;
      last = add(*one.body, last, turn * (to - from), turn * one.axis);
      from = to;
    }
    const bool moved = (chain_.moves(j) + base - carried).norm() > 0;
    if (last == parent && !moved) return;
    set(own.child("parent"), "link", last);
    if (!own.child("origin")) own.append_child("origin");
    const Vector3d xyz = turn * (place_of(j) + chain_.moves(j) + base - from);
    set(own.child("origin"), "xyz", numbers({xyz.x(), xyz.y(), xyz.z()}));
  }

  /// \return its name
  std::string add(Body body, const std::string& parent, const Vector3d& place, const Vector3d& axis) {
    body.name = chain_.own_name(body.name);
    if (named(root(), "link", body.name))
      refuse("a link " + body.name + " already", "that name free for one");
    body.parent = parent;
    body.length = 0;
    if (body.joint) body.joint->name = chain_.own_name(body.joint->name);
    append(root(), urdf_link(body));
    append(root(), urdf_joint(body, place, axis));
    if (body.joint && body.joint->stiffness > 0) append(root(), urdf_spring(*body.joint));
    return body.name;
  }

  void add_weights(const EditedChain::Weights& weights) {
    for (const EditedChain::Weight& one : weights.added) {
      const std::string link = link_of(joints_[one.link], "child");
      const Isometry3d& at = places_.at(link);
      const Vector3d place = one.link < n_ ? one.place : Vector3d(at.translation());
      add({one.name, link, {0, 0}, one.mass, 0, 0, {}}, link, at.inverse() * place, Vector3d::UnitZ());
    }
  }

  const Model& model_;
  EditedChain chain_;
  std::size_t n_;
  pugi::xml_document document_;
  std::map<std::string, Isometry3d> places_;  ///< of links
  std::vector<xml_node> joints_;              ///< of the chain; then the one that holds the end point
};

}  // namespace

Written edit_urdf(const Model& model) {
  return UrdfEditor(model).result();
}

}  // namespace plumbline::exchange
