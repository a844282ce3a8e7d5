#pragma once
/// \file
/// A model as MuJoCo compiles it, in its reference configuration.

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <memory>
#include <string>

namespace plumbline::exchange {

struct MujocoModel {
  /// \throws Error with the parser's reason
  explicit MujocoModel(const std::string& file);

  [[nodiscard]] std::string name(int type, int id, const char* otherwise) const;
  /// The last joint of the body, or of the nearest one that carries it; -1 at the base.
  [[nodiscard]] int last_joint(int body) const;

  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model;
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data;
};

/// One of many that stand one after the other.
Eigen::Vector3d vector_of(const mjtNum* values, int number = 0);

}  // namespace plumbline::exchange
