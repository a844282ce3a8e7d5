#include <mujoco/mujoco.h>

#include <array>
#include <memory>
#include <plumbline/dynamics/mass_matrix.hpp>
#include <sstream>

#include "tests/core/drawn_moving_arm.hpp"

using namespace plumbline;

namespace {

/// Decimals that give back every bit.
std::string decimals(const Eigen::VectorXd& values) {
  std::ostringstream text;
  text.precision(17);
  for (const double value : values) text << value << ' ';
  return text.str();
}

std::string placed(const Pose<double>& frame) {
  const Eigen::Quaterniond turn(frame.linear());
  return "pos=\"" + decimals(frame.translation()) + "\" quat=\"" +
         decimals(Eigen::Vector4d(turn.w(), turn.x(), turn.y(), turn.z())) + "\"";
}

/// The same arm as a model of MuJoCo's.
std::string mjcf(const MovingArm<double>& moving) {
  const SerialArm<double>& arm = moving.arm;
  std::string text = "<mujoco><compiler angle=\"radian\"/><option gravity=\"" + decimals(arm.gravity) +
                     "\"/><worldbody><body " + placed(arm.base) + ">";
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const ArmLink<double>& link = arm.links[i];
    // principal axes: MuJoCo's own search for them ends at eight digits
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(moving.inertia[i]);
    Pose<double> centre = Pose<double>::Identity();
    centre.translation() = link.centre;
    centre.linear() = principal.eigenvectors();
    if (centre.linear().determinant() < 0) centre.linear() = -centre.linear().eval();
    text += "<body " + placed(link.frame) + "><joint type=\"" +
            (link.kind == JointKind::prismatic ? "slide" : "hinge") + "\" axis=\"" + decimals(link.axis) +
            "\" armature=\"" + decimals(moving.armature.segment<1>(static_cast<Eigen::Index>(i))) +
            "\"/><inertial " + placed(centre) + " mass=\"" +
            decimals(Eigen::VectorXd::Constant(1, link.mass)) + "\" diaginertia=\"" +
            decimals(principal.eigenvalues()) + "\"/>";
  }
  for (std::size_t i = 0; i < arm.size(); ++i) text += "</body>";
  return text + "</body></worldbody></mujoco>";
}

struct Compiled {
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data{nullptr, mj_deleteData};
};

Compiled compiled(const std::string& xml) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "arm.xml", static_cast<int>(xml.size()));
  std::copy(xml.begin(), xml.end(), static_cast<char*>(files->filedata[0]));
  std::array<char, 500> reason{};
  Compiled result;
  result.model.reset(mj_loadXML("arm.xml", files.get(), reason.data(), static_cast<int>(reason.size())));
  mj_deleteVFS(files.get());
  REQUIRE_MESSAGE(result.model, reason.data());
  result.data.reset(mj_makeData(result.model.get()));
  return result;
}

}  // namespace

TEST_CASE("mass matrix and inverse dynamics are MuJoCo's to ten digits") {
  check_property("both mechanics agree", [] {
    const MovingArm<double> moving = drawn_moving_arm();
    const ArmState<double> state = drawn_state(moving);
    const Vector<double> a = drawn_rates(moving);
    const Compiled other = compiled(mjcf(moving));
    Eigen::Map<Eigen::VectorXd>(other.data->qpos, state.q.size()) = state.q;
    Eigen::Map<Eigen::VectorXd>(other.data->qvel, state.q.size()) = state.v;
    Eigen::Map<Eigen::VectorXd>(other.data->qacc, state.q.size()) = a;
    mj_inverse(other.model.get(), other.data.get());
    const Eigen::Map<const Eigen::VectorXd> drive(other.data->qfrc_inverse, state.q.size());
    const Vector<double> ours = inverse_dynamics(moving, state, a);
    RC_ASSERT((ours - drive).norm() < 1e-10 * (1 + drive.norm()));

    Matrix<double> mass(state.q.size(), state.q.size());
    mj_fullM(other.model.get(), mass.data(), other.data->qM);
    RC_ASSERT((mass_matrix(moving, state.q) - mass).norm() < 1e-10 * mass.norm());
  });
}
