#include "diagnose/exchange/mujoco_model.hpp"

#include <array>
#include <cstddef>
#include <plumbline/base/error.hpp>

#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

mjModel* load(const std::string& file) {
  mju_user_warning = [](const char*) {};  // else it writes a log file
  std::array<char, 500> reason{};
  mjModel* model = mj_loadXML(file.c_str(), nullptr, reason.data(), static_cast<int>(reason.size()));
  if (model == nullptr) throw Error(file, files::shown(reason.data()), "a model that MuJoCo reads");
  return model;
}

}  // namespace

MujocoModel::MujocoModel(const std::string& file)
    : model(load(file), mj_deleteModel), data(mj_makeData(model.get()), mj_deleteData) {
  mj_kinematics(model.get(), data.get());
  mj_comPos(model.get(), data.get());
}

std::string MujocoModel::name(int type, int id, const char* otherwise) const {
  const char* own = mj_id2name(model.get(), type, id);
  return own != nullptr && *own != '\0' ? files::shown(own) : otherwise + std::to_string(id + 1);
}

int MujocoModel::last_joint(int body) const {
  for (; body > 0; body = model->body_parentid[body])
    if (model->body_jntnum[body] > 0) return model->body_jntadr[body] + model->body_jntnum[body] - 1;
  return -1;
}

Eigen::Vector3d vector_of(const mjtNum* values, int number) {
  const mjtNum* own = values + std::ptrdiff_t{3} * number;
  return {own[0], own[1], own[2]};
}

}  // namespace plumbline::exchange
