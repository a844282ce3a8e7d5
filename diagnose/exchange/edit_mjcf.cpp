#include "diagnose/exchange/edit_mjcf.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/edit_servo.hpp"
#include "diagnose/exchange/edited_chain.hpp"
#include "diagnose/exchange/mjcf_keys.hpp"
#include "diagnose/exchange/mjcf_parts.hpp"
#include "diagnose/exchange/read_mjcf.hpp"
#include "diagnose/exchange/tree_path.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Vector3d;
using pugi::xml_node;

class MjcfEditor {
 public:
  explicit MjcfEditor(const Model& model)
      : model_(model),
        scene_(model.source),
        actuators_(actuators_of(scene_)),
        chain_(model, model_in(scene_, actuators_), Format::mjcf, {.tendons = true}),
        document_(scene_.document),
        n_(chain_.size()) {
    require_editable();
  }

  Written result() {
    for (std::size_t j = 0; j < n_; ++j) edit_joint(j);
    edit_places();
    add_series();
    add_beside();
    edit_weights();
    const Tree& after = chain_.after();
    for (const Xml& section : mjcf_couplings(renamed(after))) document_.append(document_.root(), section);
    if (after.drive) add_drive(*after.drive);
    if (Xml custom = mjcf_beside(model_, chain_.effects()); !custom.empty())
      document_.append(document_.root(), custom);
    extend_keys(scene_, actuators_.count, after.drive ? after.drive->start : Pair{0, 0});
    const std::string name = model_.source.filename().string();
    return {document_.text(head_lines(model_, chain_.effects(), {"Edited: " + name + "."})), chain_.effects(),
            name + " with the correction in it"};
  }

 private:
  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    throw Error(model_.source.string(), found, expected);
  }

  void require_editable() {
    if (document_.is_on("inertiafromgeom", false))
      refuse("inertiafromgeom=\"true\"", "bodies that may have an inertia of their own");
    for (std::size_t j = 0; j < n_; ++j) {
      if (own_body(j).joints.size() != 1) refuse("joints that share a body", "a body for every joint");
      if (joint(j).parent() != own_body(j).element) refuse("a joint within a frame", "joints in bodies");
      if (!joint(j).attribute("name")) set(joint(j), "name", chain_.joint(j).name);
    }
    if (end_site().element.attribute("fromto")) refuse("an end point given by fromto", "a site with a pos");
  }

  // The model's parts.
  [[nodiscard]] const MjcfJoint& own_joint(std::size_t j) const { return scene_.joints[chain_.number(j)]; }
  [[nodiscard]] std::size_t body(std::size_t j) const { return own_joint(j).body; }
  [[nodiscard]] const MjcfBody& own_body(std::size_t j) const { return scene_.bodies[body(j)]; }
  [[nodiscard]] const MjcfSite& end_site() const { return scene_.sites[chain_.end().number]; }
  [[nodiscard]] std::size_t end_body() const { return end_site().body; }
  [[nodiscard]] xml_node joint(std::size_t j) const { return own_joint(j).element; }

  /// The element that holds what a body holds; of the world the first.
  [[nodiscard]] xml_node element(std::size_t body) const {
    return body > 0 ? scene_.bodies[body].element : document_.root().child("worldbody");
  }
  [[nodiscard]] Vector3d in(std::size_t body, const Vector3d& direction) const {
    return scene_.bodies[body].at.linear().transpose() * direction;
  }
  [[nodiscard]] Vector3d point_in(std::size_t body, const Vector3d& place) const {
    return scene_.bodies[body].at.inverse() * place;
  }

  /// The angle, in the file's coordinate, at which the spring of a joint is at ease.
  [[nodiscard]] double ease(std::size_t j) const {
    return reference(j) + chain_.joint(j).rest + chain_.ease_moves(j);
  }
  [[nodiscard]] double reference(std::size_t j) const { return own_joint(j).ref; }

  void edit_joint(std::size_t j) {
    const Hinge &old = chain_.before(j), &now = chain_.after(j);
    const double factor = now.stiffness / old.stiffness;
    bool servos = false;
    for (const MjcfServo& servo : actuators_.servos) {
      if (servo.joint != chain_.number(j)) continue;
      servos = true;
      edit_servo(servo, factor, chain_.ease_moves(j), document_.file());
    }
    // Springs beside a servo stiffen and turn with it.
    const double own = servos ? own_joint(j).stiffness * factor : now.stiffness,
                 rest = servos ? own_joint(j).springref + chain_.ease_moves(j) : ease(j);
    if (own != own_joint(j).stiffness) set(joint(j), "stiffness", number_of(own));
    if (now.rest != old.rest && own > 0) set(joint(j), "springref", number_of(document_.angle(rest)));
    if (now.friction == old.friction) return;
    set(joint(j), "frictionloss", number_of(now.friction));
    set(joint(j), "solreffriction", rigid_reference());
    set(joint(j), "solimpfriction", rigid_impedance());
  }
  static std::string number_of(double value) { return plumbline::exchange::number(value); }

  /// Moves what stands at a place of its own, in what holds it.
  static void move(xml_node element, const Vector3d& place, const Eigen::Isometry3d& held,
                   const Vector3d& by) {
    if (by.norm() > 0) set(element, "pos", numbers_of(held.inverse() * (place + by)));
  }

  void edit_places() {
    for (std::size_t j = 0; j < n_; ++j) {
      const Vector3d by = j > 0 ? Vector3d(chain_.moves(j) - chain_.moves(j - 1)) : chain_.base_moves();
      move(own_body(j).element, own_body(j).at.translation(), own_body(j).held, by);
    }
    move(end_site().element, end_site().at.translation(), end_site().held,
         chain_.moves(n_) - chain_.moves(n_ - 1));
  }

  /// A joint of ours in a body of the file.
  [[nodiscard]] Xml joint_in(const Hinge& hinge, const Vector3d& axis, const Vector3d& at) const {
    Hinge own = hinge;
    own.name = chain_.own_name(hinge.name);
    if (own.along == 'z' && own.range)
      own.range = Pair{document_.angle((*own.range)[0]), document_.angle((*own.range)[1])};
    own.rest = 0;  // what is added is at ease where it is
    return std::move(mjcf_joint(own).set("axis", numbers_of(axis)).set("pos", numbers_of(at)));
  }

  /// Plays, and what gives way between two joints: joints of the body that they carry, before its own.
  void add_series() {
    for (const EditedChain::Added& one : chain_.in_series()) {
      const bool inside = one.before < n_;
      const std::size_t carried = inside ? body(one.before) : end_body();
      const Vector3d at = point_in(carried, one.place - chain_.moves(inside ? one.before : n_ - 1));
      const Xml added = joint_in(*one.body->joint, in(carried, one.axis), at);
      if (inside) {
        document_.insert_before(joint(one.before), added);
      } else {
        document_.append(beyond(), added);
      }
    }
  }

  /// A body for what gives way between the last joint and the end point, which moves into it.
  xml_node beyond() {
    if (beyond_) return beyond_;
    Xml body("body");
    body.set("name", "beyond").add(mjcf_inertial(speck));
    beyond_ = document_.append(element(end_body()), body);
    beyond_.append_move(end_site().element);
    return beyond_;
  }
  [[nodiscard]] xml_node tip() const { return beyond_ ? beyond_ : element(end_body()); }
  std::string tip_name() {
    if (!tip().attribute("name")) set(tip(), "name", "tip_body");
    return tip().attribute("name").value();
  }
  [[nodiscard]] Vector3d at_end(const Pair& from_end) const {
    const Vector3d moved = chain_.moves(n_) - chain_.moves(n_ - 1) + from_end[0] * chain_.along(n_ - 1) +
                           from_end[1] * chain_.across(n_ - 1);
    return point_in(end_body(), chain_.end().place + moved);
  }

  /// Arms and followers: bodies beside those of the joints.
  void add_beside() {
    for (const auto& [one, j] : chain_.beside()) {
      const std::size_t carrier = own_body(j).parent;
      const Vector3d axis = one->joint->along == 'z' ? chain_.plane().normal() : chain_.along(j);
      Xml xml("body");
      xml.set("name", chain_.own_name(one->name))
          .set("pos", numbers_of(point_in(carrier, own_body(j).at.translation())));
      xml.add(joint_in(*one->joint, in(carrier, axis), Vector3d::Zero()));
      document_.append(element(carrier), xml.add(mjcf_inertial(one->mass, one->middle)));
    }
    const Tree& after = chain_.after();
    if (after.load != after.end)
      document_.append(tip(), Xml("site").set("name", "load").set("pos", numbers_of(at_end(beside_end()))));
  }
  [[nodiscard]] Pair beside_end() const {
    const Tree& after = chain_.after();
    return {after.load[0] - after.end[0], after.load[1] - after.end[1]};
  }

  /// What couples the joints, in the file's names and coordinates.
  [[nodiscard]] Tree renamed(Tree tree) const {
    const auto rename = [&](std::vector<std::pair<std::string, double>>& joints) {
      double shift = 0;
      for (auto& [name, share] : joints) {
        for (std::size_t j = 0; j < n_; ++j)
          if (name == chain_name(j)) {
            shift += share * (chain_.sense(j) * ease(j) - chain_.after(j).rest);
            share *= chain_.sense(j);
          }
        name = chain_.own_name(name);
      }
      return shift;
    };
    for (Ramp& one : tree.ramps) {
      const double shift = rename(one.joints);
      one.name = chain_.own_name(one.name);
      one.from += shift;
      one.to += shift;
    }
    for (Tendon& one : tree.tendons) {
      rename(one.joints);
      one.name = chain_.own_name(one.name);
    }
    for (Follower& one : tree.followers) {
      std::size_t j = 0;
      while (one.hinge != chain_name(j)) ++j;
      one.rest = ease(j) - reference(j);
      one.hinge = chain_.own_name(one.hinge);
      one.slide = chain_.own_name(one.slide);
    }
    return tree;
  }

  void edit_weights() {
    const std::optional<EditedChain::Weights> weights = chain_.weights();
    if (!weights) return;
    xml_node option = document_.root().child("option");
    if (!option) option = document_.root().prepend_child("option");
    for (xml_node one : document_.root().children("option"))
      if (one.attribute("gravity")) option = one;
    set(option, "gravity", numbers_of(weights->gravity));
    for (const EditedChain::Weight& one : weights->added) {
      const std::size_t carrier = one.link < n_ ? body(one.link) : end_body();
      Xml weight("body");
      weight.set("name", one.name).set("pos", numbers_of(point_in(carrier, one.place)));
      document_.append(one.link < n_ ? element(carrier) : tip(), weight.add(mjcf_inertial(one.mass)));
    }
  }

  /// The bench, in the plane of the chain.
  void add_drive(const Drive& drive) {
    const Plane& plane = chain_.plane();
    const Vector3d base = chain_.joint(0).anchor, normal = plane.normal();
    Eigen::Matrix3d turn;
    turn << plane.x, plane.y, normal;
    const Eigen::Quaterniond q(turn);
    const Vector3d end = chain_.end().place - base;
    const Eigen::Vector2d reference = plane.of(end + chain_.moves(n_) + chain_.base_moves());
    Xml bench("body"), world("worldbody");
    bench.set("name", "bench").set("pos", numbers_of(base + normal.dot(end) * normal));
    bench.set("quat", numbers({q.w(), q.x(), q.y(), q.z()}));
    bench.add(mjcf_rail(drive, {reference.x(), reference.y()}));
    if (std::optional<Xml> clock = mjcf_clock(drive)) bench.add(*std::move(clock));
    document_.append(document_.root(), world.add(std::move(bench)));
    const Vector3d grip = at_end({0, 0});
    for (const Xml& section : mjcf_drive(drive, tip_name(), {grip.x(), grip.y(), grip.z()}))
      document_.append(document_.root(), section);
  }

  const Model& model_;
  MjcfScene scene_;
  MjcfActuators actuators_;
  EditedChain chain_;
  MjcfDocument& document_;
  std::size_t n_;
  xml_node beyond_;
};

}  // namespace

Written edit_mjcf(const Model& model) {
  return MjcfEditor(model).result();
}

}  // namespace plumbline::exchange
