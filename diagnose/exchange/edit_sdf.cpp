#include "diagnose/exchange/edit_sdf.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/edited_chain.hpp"
#include "diagnose/exchange/model_gravity.hpp"
#include "diagnose/exchange/read_sdf.hpp"
#include "diagnose/exchange/sdf_parts.hpp"
#include "diagnose/exchange/xml_document.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Vector3d;
using pugi::xml_node;

/// The first three numbers of a pose, the others as they stand.
void move(xml_node pose, const Vector3d& by) {
  std::vector<double> all = numbers_in(pose.text().get(), "pose", 0, 7);
  all.resize(std::max<std::size_t>(all.size(), 6));
  for (Eigen::Index a = 0; a < 3; ++a) all[static_cast<std::size_t>(a)] += by[a];
  set_text(pose, numbers(all));
}

class SdfEditor {
 public:
  explicit SdfEditor(const Model& model)
      : model_(model),
        chain_(model, read_sdf(model.source), Format::sdf, {.soft_ranges = true}),
        tree_(model.source),
        n_(chain_.size()),
        end_(chain_.end().name),
        world_(tree_.world),
        robot_(tree_.model) {
    if (robot_.child("model")) refuse("a model that has others in it", "links and joints one by one");
    for (std::size_t j = 0; j < n_; ++j) {
      joints_.push_back(named(robot_, "joint", chain_.joint(j).name));
      if (!joints_[j])
        refuse("no joint " + chain_.joint(j).name, "the joints by the names that the file has");
    }
    if (!named(robot_, "frame", end_) && !held(end_))
      refuse("no frame or fixed link " + end_, "one at the end point");
  }

  Written result() {
    for (std::size_t j = 0; j < n_; ++j) edit_joint(j);
    move_places();
    for (std::size_t j = 0; j <= n_; ++j) hang(j);
    const std::string name = model_.source.filename().string();
    std::vector<std::string> remarks{"Edited: " + name + "."};
    const auto weights = chain_.weights();
    if (weights) edit_weights(*weights, remarks);
    const std::string text = tree_.source.text(head_lines(model_, chain_.effects(), remarks));
    return {weights && !world_ ? with_gravity(text, weights->gravity) : text, chain_.effects(),
            name + " with the correction in it"};
  }

 private:
  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    throw Error(model_.source.string(), found, expected);
  }

  /// The joint that a link hangs by.
  [[nodiscard]] xml_node held(const std::string& link) const {
    return robot_.find_child([&](const xml_node one) {
      return std::string(one.name()) == "joint" && text_in(one, "child") == link;
    });
  }

  /// How far what has this name moves in the frame of the model.
  [[nodiscard]] Vector3d moves(const std::string& name) const {
    if (name == end_) return chain_.moves(n_) + chain_.base_moves();
    if (const xml_node frame = named(robot_, "frame", name))
      return moves(frame.attribute("attached_to").value());
    if (const xml_node joint = named(robot_, "joint", name)) return moves(text_in(joint, "child"));
    const xml_node joint = held(name);
    if (!joint) return Vector3d::Zero();
    const auto own = std::find(joints_.begin(), joints_.end(), joint);
    if (own == joints_.end()) return moves(text_in(joint, "parent"));
    return chain_.moves(static_cast<std::size_t>(own - joints_.begin())) + chain_.base_moves();
  }

  /// What the pose of an element is in; empty for the model.
  static std::string frame_of(const xml_node element) {
    if (const auto frame = element.child("pose").attribute("relative_to")) return frame.value();
    const std::string kind = element.name();
    if (kind == "joint") return text_in(element, "child");
    return kind == "frame" ? element.attribute("attached_to").value() : "";
  }

  void move_places() {
    for (xml_node one : robot_.children()) {
      const std::string kind = one.name(), frame = frame_of(one);
      if (kind != "link" && kind != "joint" && kind != "frame") continue;
      const Vector3d by = moves(one.attribute("name").value()) - moves(frame);
      if (!(by.norm() > 0)) continue;
      if (!one.child("pose")) one.prepend_child("pose").text() = "0 0 0 0 0 0";
      move(one.child("pose"), tree_.pose(tree_.resolved(frame, "")).linear().transpose() * by);
    }
  }

  void edit_joint(std::size_t j) {
    const Hinge &old = chain_.before(j), &now = chain_.after(j);
    const double ease = chain_.joint(j).rest + chain_.ease_moves(j);
    if (now.stiffness != old.stiffness || now.rest != old.rest) {
      set_child(dynamics(j), "spring_reference", number(ease));
      set_child(dynamics(j), "spring_stiffness", number(now.stiffness));
    }
    if (now.friction != old.friction) set_child(dynamics(j), "friction", number(now.friction));
    if (!now.range || old.range) return;
    const double low = (*now.range)[0] - now.rest, high = (*now.range)[1] - now.rest;
    const Pair own = chain_.sense(j) > 0 ? Pair{ease + low, ease + high} : Pair{ease - high, ease - low};
    xml_node limit = joints_[j].child("axis").child("limit");
    if (!limit) limit = joints_[j].child("axis").append_child("limit");
    set_child(limit, "lower", number(own[0]));
    set_child(limit, "upper", number(own[1]));
    set_child(limit, "stiffness", number(now.range_stiffness));
  }
  [[nodiscard]] xml_node dynamics(std::size_t j) const {
    xml_node axis = joints_[j].child("axis"), own = axis.child("dynamics");
    if (own) return own;
    own = axis.append_child("dynamics");
    for (const char* part : {"spring_reference", "spring_stiffness"}) set_child(own, part, "0");
    return own;
  }

  /// What is added before joint j, or the end point, on what carries that.
  void hang(std::size_t j) {
    const xml_node frame = named(robot_, "frame", end_);
    xml_node own = j < n_ ? joints_[j] : frame ? frame : held(end_);
    const bool by_frame = j == n_ && frame;
    const std::string parent = by_frame ? own.attribute("attached_to").value() : text_in(own, "parent");
    std::string last = parent;
    for (const EditedChain::Added& one : chain_.in_series())
      if (one.before == j) last = add(*one.body, last, one.place + chain_.base_moves(), one.axis);
    if (last == parent) return;
    if (!by_frame) {
      set_child(own, "parent", last);
      return;
    }
    if (!own.child("pose")) own.prepend_child("pose").text() = "0 0 0 0 0 0";
    if (!own.child("pose").attribute("relative_to")) set(own.child("pose"), "relative_to", parent);
    set(own, "attached_to", last);
  }

  /// \return its name
  std::string add(Body body, const std::string& parent, const Vector3d& place, const Vector3d& axis) {
    body.name = chain_.own_name(body.name);
    if (named(robot_, "link", body.name))
      refuse("a link " + body.name + " already", "that name free for one");
    body.parent = parent;
    body.length = 0;
    if (body.joint) body.joint->name = chain_.own_name(body.joint->name);
    append(robot_, sdf_link(body, place, ""));
    append(robot_, sdf_joint(body, axis));
    return body.name;
  }

  void edit_weights(const EditedChain::Weights& weights, std::vector<std::string>& remarks) {
    const Vector3d g = world_ ? Vector3d(tree_.placed().linear() * weights.gravity) : weights.gravity;
    const std::string gravity = numbers_of(g);
    if (world_) {
      set_child(world_, "gravity", gravity);
    } else {
      remarks.push_back("Gravity, which a world has: " + gravity + " m/s^2 in the frame of the model.");
    }
    for (const EditedChain::Weight& one : weights.added) {
      const std::size_t j = std::min(one.link, n_ - 1);
      const std::string link = one.link < n_ ? text_in(joints_[j], "child") : tip();
      add({one.name, link, {0, 0}, one.mass, {}, 0, {}}, link,
          one.place + chain_.moves(j) + chain_.base_moves(), Vector3d::UnitZ());
    }
  }
  /// The link that has the end point.
  [[nodiscard]] std::string tip() const {
    const xml_node frame = named(robot_, "frame", end_);
    return frame ? frame.attribute("attached_to").value() : end_;
  }

  const Model& model_;
  EditedChain chain_;
  SdfTree tree_;
  std::size_t n_;
  std::string end_;
  xml_node world_, robot_;
  std::vector<xml_node> joints_;  ///< of the chain
};

}  // namespace

Written edit_sdf(const Model& model) {
  return SdfEditor(model).result();
}

}  // namespace plumbline::exchange
