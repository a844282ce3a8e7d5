#include "diagnose/exchange/edit_urdf.hpp"

#include <Eigen/Geometry>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/edited_chain.hpp"
#include "diagnose/exchange/model_gravity.hpp"
#include "diagnose/exchange/read_urdf.hpp"
#include "diagnose/exchange/urdf_parts.hpp"
#include "diagnose/exchange/xml_document.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Vector3d, Eigen::Isometry3d;
using pugi::xml_node;

class UrdfEditor {
 public:
  explicit UrdfEditor(const Model& model)
      : model_(model),
        chain_(model, read_urdf(model.source), Format::urdf, {}),
        tree_(model.source),
        n_(chain_.size()) {
    for (std::size_t j = 0; j < n_; ++j) joints_.push_back(named(root(), "joint", chain_.joint(j).name));
    joints_.push_back(tree_.holder_of(chain_.end().name));
    for (const xml_node joint : joints_)
      if (!joint)
        refuse("no such joint or link", "the joints and the end point by the names that the file has");
  }

  Written result() {
    for (std::size_t j = 0; j < n_; ++j) edit_joint(j);
    for (std::size_t j = 0; j <= n_; ++j) hang(j);
    const std::string name = model_.source.filename().string();
    std::vector<std::string> remarks{"Edited: " + name + "."};
    const auto weights = chain_.weights();
    if (weights) {
      add_weights(*weights);
      const Vector3d& g = weights->gravity;
      remarks.push_back("URDF knows no gravity: it is to be " + numbers_of(g) +
                        " m/s^2 in the frame of the root link.");
    }
    const std::string text = tree_.source.text(head_lines(model_, chain_.effects(), remarks));
    return {weights ? with_gravity(text, weights->gravity) : text, chain_.effects(),
            name + " with the correction in it"};
  }

 private:
  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    throw Error(model_.source.string(), found, expected);
  }

  [[nodiscard]] xml_node root() const { return tree_.root(); }

  [[nodiscard]] Vector3d place_of(std::size_t j) const {
    return j < n_ ? chain_.joint(j).anchor : chain_.end().place;
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
    xml_node own = tree_.gazebo_of(joint);
    if (own) return own;
    own = root().append_child("gazebo");
    set(own, "reference", joint);
    return own;
  }

  /// Joint j on what carries it, with what is added between.
  void hang(std::size_t j) {
    xml_node own = joints_[j];
    const std::string parent = link_of(own, "parent");
    const Eigen::Matrix3d turn = tree_.place(parent).linear().transpose();
    const Vector3d none = Vector3d::Zero(), carried = j > 0 ? chain_.moves(j - 1) : none,
                   base = j > 0 ? none : chain_.base_moves();
    Vector3d from = tree_.place(parent).translation() + carried;
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
    set(own.child("origin"), "xyz", numbers_of(xyz));
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
      const Isometry3d& at = tree_.place(link);
      const Vector3d place = one.link < n_ ? one.place : Vector3d(at.translation());
      add({one.name, link, {0, 0}, one.mass, {}, 0, {}}, link, at.inverse() * place, Vector3d::UnitZ());
    }
  }

  const Model& model_;
  EditedChain chain_;
  UrdfTree tree_;
  std::size_t n_;
  std::vector<xml_node> joints_;  ///< of the chain; then the one that holds the end point
};

}  // namespace

Written edit_urdf(const Model& model) {
  return UrdfEditor(model).result();
}

}  // namespace plumbline::exchange
