#pragma once
/// \file
/// A model's file in MuJoCo, to be compared with the arm that is read out of it.

#include <doctest/doctest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <filesystem>
#include <memory>
#include <numeric>
#include <plumbline/arm/arm_kinematics.hpp>
#include <string>
#include <vector>

#include "diagnose/exchange/spatial_arm.hpp"

namespace plumbline::exchange::test {

class ArmInMujoco {
 public:
  explicit ArmInMujoco(const std::filesystem::path& file) {
    std::array<char, 500> reason{};
    model_.reset(mj_loadXML(file.c_str(), nullptr, reason.data(), 500));
    REQUIRE_MESSAGE(model_, std::string(reason.data()));
    data_.reset(mj_makeData(model_.get()));
    model_->opt.enableflags |= mjENBL_ENERGY;
  }

  /// Moves joints to these coordinates, the others as the model draws them.
  void move(const std::vector<std::string>& joints, const std::vector<double>& coordinates) {
    mj_resetData(model_.get(), data_.get());
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, joints[i].c_str());
      REQUIRE(joint >= 0);
      data_->qpos[model_->jnt_qposadr[joint]] = coordinates[i];
    }
    mj_fwdPosition(model_.get(), data_.get());
    mj_energyPos(model_.get(), data_.get());
  }

  [[nodiscard]] Eigen::Isometry3d site(const std::string& name) const {
    const int number = mj_name2id(model_.get(), mjOBJ_SITE, name.c_str());
    REQUIRE(number >= 0);
    return pose(data_->site_xpos + std::ptrdiff_t{3} * number, data_->site_xmat + std::ptrdiff_t{9} * number);
  }
  [[nodiscard]] Eigen::Isometry3d body(const std::string& name) const {
    const int number = mj_name2id(model_.get(), mjOBJ_BODY, name.c_str());
    REQUIRE(number >= 0);
    return pose(data_->xpos + std::ptrdiff_t{3} * number, data_->xmat + std::ptrdiff_t{9} * number);
  }
  /// Potential energy of all weights.
  [[nodiscard]] double energy() const { return data_->energy[0]; }

 private:
  static Eigen::Isometry3d pose(const mjtNum* place, const mjtNum* turn) {
    Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
    at.translation() = Eigen::Map<const Eigen::Vector3d>(place);
    at.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(turn);
    return at;
  }

  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model_{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data_{nullptr, mj_deleteData};
};

inline ArmPosture<double> posture(const SerialArm<double>& arm, const std::vector<double>& coordinates) {
  return {arm, Eigen::Map<const Eigen::VectorXd>(coordinates.data(),
                                                 static_cast<Eigen::Index>(coordinates.size()))};
}

inline Eigen::Isometry3d tip_pose(const SerialArm<double>& arm, const std::vector<double>& coordinates) {
  return posture(arm, coordinates).of({arm.size() - 1, arm.tip});
}

/// Potential energy of the links' weights.
inline double energy(const SerialArm<double>& arm, const std::vector<double>& coordinates) {
  const ArmPosture<double> at = posture(arm, coordinates);
  double sum = 0;
  for (std::size_t i = 0; i < arm.size(); ++i)
    sum -= arm.links[i].mass * arm.gravity.dot(at.frame(i) * arm.links[i].centre);
  return sum;
}

/// How far two poses are apart, m and rad together.
inline double apart(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

}  // namespace plumbline::exchange::test
