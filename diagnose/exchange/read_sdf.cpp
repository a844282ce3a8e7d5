#include "diagnose/exchange/read_sdf.hpp"

#include <Eigen/Geometry>
#include <map>
#include <plumbline/base/error.hpp>
#include <sdf/sdf.hh>

#include "diagnose/exchange/urdf_end.hpp"
#include "support/files/printable.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Vector3d;
using ignition::math::Pose3d;

Vector3d vector(const ignition::math::Vector3d& v) {
  return {v.X(), v.Y(), v.Z()};
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {
    sdf::Console::Instance()->SetQuiet(true);
    // The parser sees a URDF's end only where it is told to keep it.
    demand(file.ends_with(".urdf") ? root_.LoadSdfString(with_end_kept(files::read_text(file)))
                                   : root_.Load(file));
    world_ = root_.WorldCount() > 0 ? root_.WorldByIndex(0) : nullptr;
    model_ = root_.Model();
    if (model_ == nullptr && world_ != nullptr && world_->ModelCount() == 1) model_ = world_->ModelByIndex(0);
    if (model_ == nullptr) throw Error(file, "no model, or several", "one model");
  }

  std::map<std::string, Eigen::Matrix3d> rotations() {
    for (std::uint64_t l = 0; l < model_->LinkCount(); ++l) turn(*model_->LinkByIndex(l));
    for (std::uint64_t j = 0; j < model_->JointCount(); ++j) turn(*model_->JointByIndex(j));
    for (std::uint64_t f = 0; f < model_->FrameCount(); ++f) turn(*model_->FrameByIndex(f));
    return std::move(turned_);
  }

  ReadModel read() {
    for (std::uint64_t j = 0; j < model_->JointCount(); ++j) join(*model_->JointByIndex(j));
    for (std::uint64_t j = 0; j < model_->JointCount(); ++j) add_joint(*model_->JointByIndex(j));
    for (std::uint64_t l = 0; l < model_->LinkCount(); ++l) add_mass(*model_->LinkByIndex(l));
    find_end();
    result_.gravity = world_ != nullptr ? vector(world_->Gravity()) : Vector3d(0, 0, -9.8);
    if (world_ == nullptr) result_.left_out.push_back("no gravity of its own: -9.8 along z");
    return std::move(result_);
  }

 private:
  void demand(const sdf::Errors& errors) const {
    if (!errors.empty())
      throw Error(file_, files::shown(errors.front().Message()), "a model that sdformat reads");
  }

  template <class Part>
  [[nodiscard]] Pose3d pose(const Part& part) const {
    Pose3d in_model;
    demand(part.SemanticPose().Resolve(in_model, "__model__"));
    return in_model;
  }

  template <class Part>
  void turn(const Part& part) {
    const auto rot = pose(part).Rot();
    turned_[part.Name()] = Eigen::Quaterniond(rot.W(), rot.X(), rot.Y(), rot.Z()).toRotationMatrix();
  }

  /// How a link hangs on another.
  struct Hold {
    std::string parent;
    const sdf::Joint* joint;
  };

  void join(const sdf::Joint& joint) {
    std::string parent, child;
    demand(joint.ResolveParentLink(parent));
    demand(joint.ResolveChildLink(child));
    if (!held_.emplace(child, Hold{parent, &joint}).second)
      throw Error(file_, "link " + child + " on two joints", "a serial chain");
  }

  /// The joint that a link moves with: its own, or of the link to which it is fixed.
  [[nodiscard]] std::string joint_of(const std::string& link) const {
    for (auto hold = held_.find(link); hold != held_.end(); hold = held_.find(hold->second.parent))
      if (hold->second.joint->Type() != sdf::JointType::FIXED) return hold->second.joint->Name();
    return "";
  }

  void add_joint(const sdf::Joint& own) {
    if (own.Type() == sdf::JointType::FIXED) return;
    std::string parent;
    demand(own.ResolveParentLink(parent));
    ReadJoint joint;
    joint.name = files::shown(own.Name());
    joint.carrier = joint_of(parent);
    joint.hinge = own.Type() == sdf::JointType::REVOLUTE || own.Type() == sdf::JointType::CONTINUOUS;
    joint.anchor = vector(pose(own).Pos());
    const sdf::JointAxis* axis = own.Axis();
    if (axis == nullptr) throw Error(file_, "joint " + joint.name + " without an axis", "hinges alone");
    ignition::math::Vector3d along;
    demand(axis->ResolveXyz(along, "__model__"));
    joint.axis = vector(along);
    joint.stiffness = axis->SpringStiffness();
    joint.rest = axis->SpringReference();
    if (axis->Friction() > 0) result_.left_out.push_back("friction of " + joint.name);
    if (joint.hinge && axis->Upper() - axis->Lower() < 6.2)
      result_.left_out.push_back("range of " + joint.name);
    result_.joints.push_back(std::move(joint));
  }

  void add_mass(const sdf::Link& link) {
    const std::string name = joint_of(link.Name());
    const double mass = link.Inertial().MassMatrix().Mass();
    const Vector3d at = vector((pose(link) * link.Inertial().Pose()).Pos());
    for (ReadJoint& joint : result_.joints) {
      if (joint.name != name || !(mass > 0)) continue;
      joint.middle = (joint.mass * joint.middle + mass * at) / (joint.mass + mass);
      joint.mass += mass;
    }
  }

  /// A frame or a link whose name says that it is an end.
  void find_end() {
    for (std::uint64_t l = 0; l < model_->LinkCount(); ++l) consider_end("link ", *model_->LinkByIndex(l));
    for (std::uint64_t f = 0; f < model_->FrameCount(); ++f) consider_end("frame ", *model_->FrameByIndex(f));
  }

  template <class Part>
  void consider_end(const char* kind, const Part& part) {
    const std::string& name = part.Name();
    if (!names_an_end(name)) return;
    result_.end = vector(pose(part).Pos());
    result_.end_name = kind + files::shown(name);
  }

  std::string file_;
  sdf::Root root_;
  const sdf::World* world_ = nullptr;
  const sdf::Model* model_ = nullptr;
  std::map<std::string, Hold> held_;
  ReadModel result_;
  std::map<std::string, Eigen::Matrix3d> turned_;
};

}  // namespace

ReadModel read_sdf(const std::string& file) {
  return Reader(file).read();
}

std::map<std::string, Eigen::Matrix3d> sdf_rotations(const std::string& file) {
  return Reader(file).rotations();
}

}  // namespace plumbline::exchange
