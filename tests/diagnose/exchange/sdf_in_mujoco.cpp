#include "tests/diagnose/exchange/sdf_in_mujoco.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <plumbline/base/error.hpp>
#include <sdf/sdf.hh>

#include "diagnose/exchange/mjcf_parts.hpp"
#include "support/files/text_file.hpp"
#include "tests/diagnose/exchange/urdf_end.hpp"

namespace plumbline::exchange::test {
namespace {

using ignition::math::Pose3d;

std::string numbers_of(const ignition::math::Vector3d& v) {
  return numbers({v.X(), v.Y(), v.Z()});
}

class Translation {
 public:
  Translation(const std::string& file, std::string end, std::array<double, 3> gravity)
      : file_(file), end_(std::move(end)), gravity_(numbers({gravity[0], gravity[1], gravity[2]})) {
    sdf::Console::Instance()->SetQuiet(true);
    demand(file.ends_with(".urdf") ? root_.LoadSdfString(with_end_kept(files::read_text(file)))
                                   : root_.Load(file));
    const sdf::World* world = root_.WorldByIndex(0);
    model_ = world != nullptr ? world->ModelByIndex(0) : root_.Model();
    if (model_ == nullptr) throw Error(file, "no model", "one");
    if (world != nullptr) gravity_ = numbers_of(world->Gravity());
    for (std::uint64_t j = 0; j < model_->JointCount(); ++j) hang(*model_->JointByIndex(j));
  }

  std::string text() {
    Xml world("worldbody"), mujoco("mujoco");
    for (std::uint64_t l = 0; l < model_->LinkCount(); ++l)
      if (const sdf::Link& link = *model_->LinkByIndex(l); parent_of(link.Name()).empty())
        add(link, Pose3d::Zero, world);
    mujoco.add(Xml("compiler").set("angle", "radian"));
    mujoco.add(Xml("option")
                   .set("timestep", number(mjcf_timestep))
                   .set("integrator", "implicit")
                   .set("tolerance", "1e-12")
                   .set("gravity", gravity_));
    mujoco.add(std::move(world));
    if (!tendons_.empty()) mujoco.add(tendons_);
    return mujoco.text(0);
  }

 private:
  void demand(const sdf::Errors& errors) const {
    if (!errors.empty()) throw Error(file_, errors.front().Message(), "what sdformat reads");
  }
  template <class Part>
  [[nodiscard]] Pose3d pose(const Part& part) const {
    Pose3d in_model;
    demand(part.SemanticPose().Resolve(in_model, "__model__"));
    return in_model;
  }

  void hang(const sdf::Joint& joint) {
    std::string parent, child;
    demand(joint.ResolveParentLink(parent));
    demand(joint.ResolveChildLink(child));
    held_[child] = {parent == "world" ? "" : parent, &joint};
  }
  [[nodiscard]] std::string parent_of(const std::string& link) const {
    const auto own = held_.find(link);
    return own == held_.end() ? "" : own->second.first;
  }

  void add(const sdf::Link& link, const Pose3d& carrier, Xml& to) {
    const Pose3d own = pose(link), at = carrier.Inverse() * own;
    const auto placed = [&] {
      const auto& q = at.Rot();
      return Xml("body").set("pos", numbers_of(at.Pos())).set("quat", numbers({q.W(), q.X(), q.Y(), q.Z()}));
    };
    Xml body = placed();
    body.set("name", link.Name());
    const auto& inertial = link.Inertial();
    const double mass = inertial.MassMatrix().Mass(), turning = inertial.MassMatrix().Izz();
    body.add(Xml("inertial")
                 .set("pos", numbers_of(inertial.Pose().Pos()))
                 .set("mass", number(mass))
                 .set("diaginertia", numbers({turning, turning, turning})));
    const auto held = held_.find(link.Name());
    if (held != held_.end() && held->second.second->Type() != sdf::JointType::FIXED)
      add_joint(*held->second.second, link, own, body, placed, to);
    for (std::uint64_t l = 0; l < model_->LinkCount(); ++l)
      if (const sdf::Link& next = *model_->LinkByIndex(l); parent_of(next.Name()) == link.Name())
        add(next, own, body);
    if (link.Name() == end_) body.add(Xml("site").set("name", "end"));
    for (std::uint64_t f = 0; f < model_->FrameCount(); ++f)
      add_end(*model_->FrameByIndex(f), link, own, body);
    to.add(std::move(body));
  }

  void add_end(const sdf::Frame& frame, const sdf::Link& link, const Pose3d& own, Xml& body) const {
    std::string carrier;
    demand(frame.ResolveAttachedToBody(carrier));
    if (frame.Name() != end_ || carrier != link.Name()) return;
    body.add(Xml("site").set("name", "end").set("pos", numbers_of((own.Inverse() * pose(frame)).Pos())));
  }

  /// A range that yields is a second hinge, hard, and a spring between the two.
  template <class Placed>
  void add_joint(const sdf::Joint& joint, const sdf::Link& link, const Pose3d& own, Xml& body,
                 const Placed& placed, Xml& to) {
    const sdf::JointAxis& axis = *joint.Axis();
    ignition::math::Vector3d along;
    demand(axis.ResolveXyz(along, link.Name()));
    const double stiffness = axis.SpringStiffness();
    Xml xml("joint");
    xml.set("name", joint.Name())
        .set("type", joint.Type() == sdf::JointType::PRISMATIC ? "slide" : "hinge")
        .set("axis", numbers_of(along))
        .set("pos", numbers_of((own.Inverse() * pose(joint)).Pos()))
        .set("solreflimit", rigid_reference())
        .set("solimplimit", rigid_impedance())
        .set("solreffriction", rigid_reference())
        .set("solimpfriction", rigid_impedance())
        // of numbers alone: statics does not know it
        .set("armature", number(std::max(stiffness, 1.0) * response_time * response_time));
    const bool bounded = std::isfinite(axis.Lower()) && axis.Upper() - axis.Lower() < 1e6,
               yields = bounded && axis.Stiffness() < 1e6;
    const std::string range = numbers({axis.Lower(), axis.Upper()});
    if (yields) {
      Xml second = xml, arm = placed(), spring("fixed");
      const std::string name = joint.Name() + "_range";
      second.set("name", name).set("limited", "true").set("range", range);
      second.set("springref", number(axis.SpringReference()));  // where the spring between the two is at ease
      second.set("damping", number(2 * axis.Stiffness() * response_time));
      to.add(std::move(arm.add(mjcf_inertial(speck)).add(std::move(second))));
      spring.set("name", name).set("stiffness", number(axis.Stiffness()));
      spring.add(Xml("joint").set("joint", joint.Name()).set("coef", "1"));
      spring.add(Xml("joint").set("joint", name).set("coef", "-1"));
      tendons_.add(std::move(spring));
    } else if (bounded) {
      xml.set("limited", "true").set("range", range);
    }
    body.add(std::move(xml.set("stiffness", number(stiffness))
                           .set("springref", number(axis.SpringReference()))
                           .set("damping", number(axis.Damping()))
                           .set("frictionloss", number(axis.Friction()))));
  }

  std::string file_, end_, gravity_;
  sdf::Root root_;
  const sdf::Model* model_ = nullptr;
  std::map<std::string, std::pair<std::string, const sdf::Joint*>> held_;  ///< by link: its carrier, by what
  Xml tendons_{"tendon"};
};

}  // namespace

std::string mjcf_of(const std::string& file, const std::string& end, std::array<double, 3> gravity) {
  return Translation(file, end, gravity).text();
}

}  // namespace plumbline::exchange::test
