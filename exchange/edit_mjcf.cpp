#include "exchange/edit_mjcf.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <plumbline/base/error.hpp>

#include "exchange/carried.hpp"
#include "exchange/mjcf_document.hpp"
#include "exchange/mjcf_keys.hpp"
#include "exchange/mjcf_parts.hpp"
#include "exchange/mujoco_model.hpp"
#include "exchange/planar_chain.hpp"
#include "exchange/read_mujoco.hpp"
#include "exchange/tree_path.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Vector3d;
using pugi::xml_node;

constexpr Means means{.tendons = true};

std::string numbers_of(const Vector3d& v) {
  return numbers({v.x(), v.y(), v.z()});
}

class Editor {
 public:
  explicit Editor(const Model& model)
      : model_(model),
        own_(model.source.string()),
        read_(read_mujoco(model.source.string())),
        chain_(planar_chain(read_, model.source.string())),
        document_(model.source),
        n_(chain_.joints.size()) {
    require_editable();
    Model bare = model;
    bare.experiment.effects.clear();
    bare.laws.clear();
    before_ = carried_tree(bare, {}, means);
    written_.effects = what_is_carried(model, Format::mjcf);
    after_ = carried_tree(model, written_.effects, means);
    if (!weights_fit()) leave_weights();
    measure_links();
  }

  Written result() {
    for (std::size_t j = 0; j < n_; ++j) edit_joint(j);
    edit_places();
    add_series();
    add_beside();
    if (weighs_otherwise()) edit_weights();
    for (const Xml& section : mjcf_couplings(renamed(after_))) document_.append(document_.root(), section);
    if (after_.drive) add_drive();
    if (Xml custom = mjcf_beside(model_, written_.effects); !custom.empty())
      document_.append(document_.root(), custom);
    extend_keys(document_, *own_.model, after_.drive ? after_.drive->start : Pair{0, 0});
    written_.note = model_.source.filename().string() + " with the correction in it";
    written_.text = document_.text(
        head_lines(model_, written_.effects, {"Edited: " + model_.source.filename().string() + "."}));
    return std::move(written_);
  }

 private:
  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    throw Error(model_.source.string(), found, expected);
  }

  void require_editable() {
    const mjModel& m = *own_.model;
    if (static_cast<int>(document_.bodies.size()) != m.nbody ||
        static_cast<int>(document_.joints.size()) != m.njnt ||
        static_cast<int>(document_.sites.size()) != m.nsite)
      refuse("bodies, joints and sites that MuJoCo counts otherwise", "a file that names each one");
    for (std::size_t j = 0; j < n_; ++j)
      if (m.body_jntnum[body(j)] != 1) refuse("joints that share a body", "a body for every joint");
    if (read_.end_site < 0) refuse("no site at the end point", "a site there");
    if (document_.sites[static_cast<std::size_t>(read_.end_site)].attribute("fromto"))
      refuse("an end point given by fromto", "a site with a pos");
    for (std::size_t j = 0; j < n_; ++j) {
      const std::string name = joint_name(j);
      if (!joint(j).attribute("name")) set(joint(j), "name", name);
    }
  }

  // The model's numbers.
  [[nodiscard]] int number(std::size_t j) const { return static_cast<int>(chain_.joints[j].number); }
  [[nodiscard]] double sense(std::size_t j) const { return chain_.joints[j].sense; }
  [[nodiscard]] int body(std::size_t j) const { return own_.model->jnt_bodyid[number(j)]; }
  [[nodiscard]] int end_body() const { return own_.model->site_bodyid[read_.end_site]; }
  [[nodiscard]] xml_node element(int body) const { return document_.bodies[static_cast<std::size_t>(body)]; }
  [[nodiscard]] xml_node joint(std::size_t j) const { return document_.joints[chain_.joints[j].number]; }
  [[nodiscard]] Vector3d anchor(std::size_t j) const { return read_.joints[chain_.joints[j].number].anchor; }
  [[nodiscard]] std::string joint_name(std::size_t j) const {
    const std::string own = joint(j).attribute("name").value();
    return own.empty() ? chain_name(j) : own;
  }

  [[nodiscard]] Eigen::Matrix3d turned(int body) const {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(own_.data->xmat +
                                                                          std::ptrdiff_t{9} * body);
  }
  [[nodiscard]] Vector3d in(int body, const Vector3d& direction) const {
    return turned(body).transpose() * direction;
  }
  [[nodiscard]] Vector3d point_in(int body, const Vector3d& place) const {
    return in(body, place - vector_of(own_.data->xpos, body));
  }

  void measure_links() {
    const std::vector<LinkOf> old = links_of(before_, n_), now = links_of(after_, n_);
    Vector3d moved = Vector3d::Zero();
    for (std::size_t j = 0; j < n_; ++j) {
      const Vector3d far = j + 1 < n_ ? anchor(j + 1) : *read_.end, way = far - anchor(j);
      const Vector3d in_plane = way - way.dot(chain_.plane.normal()) * chain_.plane.normal();
      along_.push_back(in_plane.normalized());
      moved_.push_back(moved);
      moved += (now[j].length - old[j].length) * along_.back();
      length_.push_back(now[j].length);
    }
    moved_.push_back(moved);
  }
  /// Across a link, counter-clockwise in the chain's plane.
  [[nodiscard]] Vector3d across(std::size_t j) const { return chain_.plane.normal().cross(along_[j]); }

  /// The angle, in the file's coordinate, at which the spring of a joint is at ease.
  [[nodiscard]] double ease(std::size_t j) const {
    const double moved =
        carrier_of(after_, chain_name(j))->joint->rest - carrier_of(before_, chain_name(j))->joint->rest;
    return own_.model->qpos_spring[own_.model->jnt_qposadr[number(j)]] + sense(j) * moved;
  }
  [[nodiscard]] double reference(std::size_t j) const {
    return own_.model->qpos0[own_.model->jnt_qposadr[number(j)]];
  }

  void edit_joint(std::size_t j) {
    const Hinge &old = *carrier_of(before_, chain_name(j))->joint,
                &now = *carrier_of(after_, chain_name(j))->joint;
    if (now.stiffness != old.stiffness) set(joint(j), "stiffness", number_of(now.stiffness));
    if (now.rest != old.rest) set(joint(j), "springref", number_of(document_.angle(ease(j))));
    if (now.friction == old.friction) return;
    set(joint(j), "frictionloss", number_of(now.friction));
    set(joint(j), "solreffriction", rigid_reference());
    set(joint(j), "solimpfriction", rigid_impedance());
  }
  static std::string number_of(double value) { return plumbline::exchange::number(value); }

  /// Moves what stands at a place of its own in a body.
  void move(xml_node element, const Vector3d& old, int carrier, const Vector3d& by) {
    if (by.norm() > 0) set(element, "pos", numbers_of(old + in(carrier, by)));
  }

  void edit_places() {
    const Pair base = path_of(after_).front()->place, old = path_of(before_).front()->place;
    for (std::size_t j = 0; j < n_; ++j) {
      Vector3d by = j > 0
                        ? Vector3d(moved_[j] - moved_[j - 1])
                        : Vector3d((base[0] - old[0]) * chain_.plane.x + (base[1] - old[1]) * chain_.plane.y);
      move(element(body(j)), vector_of(own_.model->body_pos, body(j)), own_.model->body_parentid[body(j)],
           by);
    }
    move(document_.sites[static_cast<std::size_t>(read_.end_site)],
         vector_of(own_.model->site_pos, read_.end_site), end_body(), moved_[n_] - moved_[n_ - 1]);
  }

  /// "q2_play" as the file's own: "elbow_play".
  [[nodiscard]] std::string own_name(const std::string& name) const {
    for (std::size_t j = n_; j-- > 0;) {
      const std::string chain = chain_name(j);
      if (name == chain) return joint_name(j);
      if (name.starts_with(chain + "_")) return joint_name(j) + name.substr(chain.size());
    }
    return name;
  }

  /// A joint of ours in a body of the file.
  [[nodiscard]] Xml joint_in(const Hinge& hinge, const Vector3d& axis, const Vector3d& at) const {
    Hinge own = hinge;
    own.name = own_name(hinge.name);
    if (own.along == 'z' && own.range)
      own.range = Pair{document_.angle((*own.range)[0]), document_.angle((*own.range)[1])};
    own.rest = 0;  // what is added is at ease where it is
    return std::move(mjcf_joint(own).set("axis", numbers_of(axis)).set("pos", numbers_of(at)));
  }

  /// Plays, and what gives way between two joints: joints of the body that they carry, before its own.
  void add_series() {
    std::size_t next = 0;  // links that have begun
    double travelled = 0;  // on the one that was last
    for (const Body* one : path_of(after_)) {
      if (next > 0) travelled += one->place[0];
      if (!one->joint) continue;
      if (next < n_ && one->joint->name == chain_name(next)) {
        ++next;
        travelled = 0;
        continue;
      }
      const bool before_first = next == 0;
      const Vector3d x = before_first ? chain_.plane.x : along_[next - 1],
                     y = before_first ? chain_.plane.y : across(next - 1);
      const Vector3d axis = one->joint->along == 'x'   ? x
                            : one->joint->along == 'y' ? y
                                                       : chain_.plane.normal();
      const Vector3d place =
          before_first ? anchor(0) : Vector3d(anchor(next - 1) + moved_[next - 1] + travelled * x);
      if (next < n_) {
        const Vector3d at = point_in(body(next), place - moved_[next]);
        document_.insert_before(joint(next), joint_in(*one->joint, in(body(next), axis), at));
      } else {
        const Vector3d at = point_in(end_body(), place - moved_[n_ - 1]);
        document_.append(beyond(), joint_in(*one->joint, in(end_body(), axis), at));
      }
    }
  }

  /// A body for what gives way between the last joint and the end point, which moves into it.
  xml_node beyond() {
    if (beyond_) return beyond_;
    Xml body("body");
    body.set("name", "beyond").add(mjcf_inertial(speck, 0));
    beyond_ = document_.append(element(end_body()), body);
    beyond_.append_move(document_.sites[static_cast<std::size_t>(read_.end_site)]);
    return beyond_;
  }
  [[nodiscard]] xml_node tip() const { return beyond_ ? beyond_ : element(end_body()); }
  std::string tip_name() {
    if (!tip().attribute("name")) set(tip(), "name", "tip_body");
    return tip().attribute("name").value();
  }
  [[nodiscard]] Vector3d at_end(const Pair& from_end) const {
    const Vector3d moved =
        moved_[n_] - moved_[n_ - 1] + from_end[0] * along_.back() + from_end[1] * across(n_ - 1);
    return point_in(end_body(), *read_.end + moved);
  }

  /// Arms and followers: bodies beside those of the joints.
  void add_beside() {
    const std::vector<const Body*> path = path_of(after_);
    for (const Body& one : after_.bodies) {
      if (!one.joint || std::find(path.begin(), path.end(), &one) != path.end()) continue;
      std::size_t j = n_;
      while (j-- > 0)
        if (one.joint->name.starts_with(chain_name(j) + "_")) break;
      const int carrier = own_.model->body_parentid[body(j)];
      Xml xml("body");
      xml.set("name", own_name(one.name)).set("pos", numbers_of(vector_of(own_.model->body_pos, body(j))));
      xml.add(joint_in(*one.joint, in(carrier, one.joint->along == 'z' ? chain_.plane.normal() : along_[j]),
                       Vector3d::Zero()));
      document_.append(element(carrier), xml.add(mjcf_inertial(one.mass, one.middle)));
    }
    if (after_.load != after_.end)
      document_.append(tip(), Xml("site").set("name", "load").set("pos", numbers_of(at_end(beside_end()))));
  }
  [[nodiscard]] Pair beside_end() const {
    return {after_.load[0] - after_.end[0], after_.load[1] - after_.end[1]};
  }

  /// What couples the joints, in the file's names and coordinates.
  [[nodiscard]] Tree renamed(Tree tree) const {
    const auto rename = [&](std::vector<std::pair<std::string, double>>& joints) {
      double shift = 0;
      for (auto& [name, share] : joints) {
        for (std::size_t j = 0; j < n_; ++j)
          if (name == chain_name(j)) {
            shift += share * (sense(j) * ease(j) - carrier_of(tree, name)->joint->rest);
            share *= sense(j);
          }
        name = own_name(name);
      }
      return shift;
    };
    for (Ramp& one : tree.ramps) {
      const double shift = rename(one.joints);
      one.name = own_name(one.name);
      one.from += shift;
      one.to += shift;
    }
    for (Tendon& one : tree.tendons) {
      rename(one.joints);
      one.name = own_name(one.name);
    }
    for (Follower& one : tree.followers) {
      std::size_t j = 0;
      while (one.hinge != chain_name(j)) ++j;
      const double r = ease(j) - reference(j);
      one.polynomial = {r * r * r * r, -4 * r * r * r, 6 * r * r, -4 * r, 1};
      one.hinge = own_name(one.hinge);
      one.slide = own_name(one.slide);
    }
    return tree;
  }

  // Weights. Those that the file has go on weighing.
  [[nodiscard]] double own_mass(std::size_t j) const {
    constexpr double no_mass = 1e-4;  // as the reader has it
    const double mass = read_.joints[chain_.joints[j].number].mass;
    return mass > no_mass ? mass : 0;
  }
  [[nodiscard]] const Body* payload() const {
    const auto found = std::find_if(after_.bodies.begin(), after_.bodies.end(),
                                    [](const Body& one) { return one.name == "payload"; });
    return found == after_.bodies.end() ? nullptr : &*found;
  }
  [[nodiscard]] bool weighs_otherwise() const {
    if (after_.gravity != before_.gravity || payload() != nullptr) return true;
    const std::vector<LinkOf> old = links_of(before_, n_), now = links_of(after_, n_);
    return !std::equal(old.begin(), old.end(), now.begin(),
                       [](const LinkOf& a, const LinkOf& b) { return a.mass == b.mass; });
  }
  /// As strong as it is, or as weak as the file's own masses let it be.
  [[nodiscard]] double gravity() const {
    const double wanted = std::hypot(after_.gravity[0], after_.gravity[1]);
    const std::vector<LinkOf> now = links_of(after_, n_);
    double allowed = wanted;
    for (std::size_t j = 0; j < n_; ++j)
      if (own_mass(j) > 0) allowed = std::min(allowed, now[j].mass * wanted / own_mass(j));
    return allowed;
  }
  [[nodiscard]] bool weights_fit() const { return !weighs_otherwise() || gravity() > 0; }
  void leave_weights() {
    for (Carried& one : written_.effects)
      if (one.carried && (one.effect == "gravity" || one.effect == "tip_payload"))
        one.carried = false, one.how = "the masses of the model itself would weigh with it";
    after_ = carried_tree(model_, written_.effects, means);
  }
  void edit_weights() {
    const double strength = std::hypot(after_.gravity[0], after_.gravity[1]), own = gravity();
    const Vector3d down =
        (after_.gravity[0] * chain_.plane.x + after_.gravity[1] * chain_.plane.y) / strength;
    const Vector3d normal = chain_.plane.normal();
    xml_node option = document_.root().child("option");
    if (!option) option = document_.root().prepend_child("option");
    for (xml_node one : document_.root().children("option"))
      if (one.attribute("gravity")) option = one;
    set(option, "gravity", numbers_of(read_.gravity.dot(normal) * normal + own * down));
    const std::vector<LinkOf> now = links_of(after_, n_);
    const auto add = [&](xml_node to, const std::string& name, double mass, const Vector3d& at) {
      Xml weight("body");
      weight.set("name", name).set("pos", numbers_of(at)).add(mjcf_inertial(mass, 0));
      document_.append(to, weight);
    };
    for (std::size_t j = 0; j < n_; ++j) {
      const double mass = now[j].mass * strength / own - own_mass(j);
      if (mass > 1e-9 * (1 + own_mass(j)))
        add(element(body(j)), joint_name(j) + "_weight", mass,
            point_in(body(j), anchor(j) + length_[j] / 2 * along_[j]));
    }
    if (payload() != nullptr) add(tip(), "payload", payload()->mass * strength / own, at_end({0, 0}));
  }

  /// The bench, in the plane of the chain.
  void add_drive() {
    Eigen::Matrix3d turn;
    turn << chain_.plane.x, chain_.plane.y, chain_.plane.normal();
    const Eigen::Quaterniond q(turn);
    const Pair base = path_of(after_).front()->place, old = path_of(before_).front()->place;
    const Eigen::Vector2d end = chain_.plane.of(*read_.end + moved_[n_] - anchor(0));
    Xml bench("body"), world("worldbody");
    const double height = chain_.plane.normal().dot(*read_.end - anchor(0));
    bench.set("name", "bench").set("pos", numbers_of(anchor(0) + height * chain_.plane.normal()));
    bench.set("quat", numbers({q.w(), q.x(), q.y(), q.z()}));
    bench.add(mjcf_rail(*after_.drive, {end.x() + base[0] - old[0], end.y() + base[1] - old[1]}));
    if (std::optional<Xml> clock = mjcf_clock(*after_.drive)) bench.add(*std::move(clock));
    document_.append(document_.root(), world.add(std::move(bench)));
    const Vector3d grip = at_end({0, 0});
    for (const Xml& section : mjcf_drive(*after_.drive, tip_name(), {grip.x(), grip.y(), grip.z()}))
      document_.append(document_.root(), section);
  }

  const Model& model_;
  MujocoModel own_;
  ReadModel read_;
  PlanarChain chain_;
  mutable MjcfDocument document_;
  std::size_t n_;
  Written written_;
  Tree before_, after_;
  std::vector<Vector3d> along_;  ///< by link, in the world
  std::vector<Vector3d> moved_;  ///< by joint, then the end point: by the links before it
  std::vector<double> length_;
  xml_node beyond_;
};

}  // namespace

Written edit_mjcf(const Model& model) {
  return Editor(model).result();
}

}  // namespace plumbline::exchange
