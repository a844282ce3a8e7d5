#include <array>

#include "diagnose/draft/read_draft_model.hpp"
#include "diagnose/draft/told_columns.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "python/engine/engine.hpp"

namespace plumbline::python {
namespace {

using Texts = std::vector<std::pair<std::string, std::string>>;  ///< by name

py::dict chain_of(const std::string& file, const std::vector<std::string>& joints) {
  const exchange::PlanarChain read = unlocked([&] { return exchange::read_model(file, joints); });
  py::dict chain;
  chain["link_length"] = array_of(read.chain.link_length);
  chain["joint_stiffness"] = array_of(read.chain.joint_stiffness);
  chain["link_mass"] = array_of(read.chain.link_mass);
  chain["gravity"] = array_of({read.chain.gravity.begin(), read.chain.gravity.end()});
  chain["rest"] = array_of(read.chain.rest);
  chain["joints"] = read.names;
  chain["notes"] = read.notes;
  return chain;
}

template <std::size_t count>
using Row = std::array<double, count>;

Row<3> row_of(const Vector3<double>& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

/// Its matrix of four by four, row by row.
Row<16> row_of(const Pose<double>& pose) {
  Row<16> row{};
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(row.data()) = pose.matrix();
  return row;
}

py::array matrices(const std::vector<Row<16>>& rows) {
  return table_of(rows, 16).reshape({static_cast<py::ssize_t>(rows.size()), py::ssize_t{4}, py::ssize_t{4}});
}

py::array matrix(const Pose<double>& pose) {
  return table_of(std::vector{row_of(pose)}, 16).reshape({py::ssize_t{4}, py::ssize_t{4}});
}

/// Numbers of the arm's links, a row each.
void put_links(const SerialArm<double>& arm, py::dict& all) {
  std::vector<std::string> kinds;
  std::vector<double> stiffness, masses;
  std::vector<Row<3>> axes, centres;
  std::vector<Row<16>> frames;
  for (const ArmLink<double>& link : arm.links) {
    kinds.emplace_back(link.kind == JointKind::prismatic ? "prismatic" : "revolute");
    stiffness.push_back(link.joint_compliance > 0 ? 1 / link.joint_compliance : 0);
    masses.push_back(link.mass);
    axes.push_back(row_of(link.axis)), centres.push_back(row_of(link.centre));
    frames.push_back(row_of(link.frame));
  }
  all["kinds"] = kinds, all["frames"] = matrices(frames), all["axes"] = table_of(axes, 3);
  all["stiffness"] = array_of(stiffness), all["masses"] = array_of(masses);
  all["centres"] = table_of(centres, 3);
}

py::dict arm_of(const std::string& file, const std::string& base, const std::string& tip) {
  const exchange::SpatialArm read = unlocked([&] { return exchange::read_arm(file, {base, tip}); });
  const diagnose::NominalArm& nominal = read.nominal;
  py::dict all;
  all["base"] = nominal.base, all["tip"] = nominal.tip;
  all["joints"] = nominal.joint, all["links"] = nominal.link;
  put_links(nominal.arm, all);
  all["limits"] = table_of(nominal.limits, 2), all["friction"] = array_of(read.friction);
  all["gravity"] = array_of({nominal.arm.gravity.begin(), nominal.arm.gravity.end()});
  all["base_frame"] = matrix(nominal.arm.base), all["tip_frame"] = matrix(nominal.arm.tip);
  all["notes"] = read.notes;
  return all;
}

py::dict draft_of(const std::string& name, const std::string& file, const std::vector<std::string>& joints,
                  const Texts& tables, const std::string& columns, const std::string& base,
                  const std::string& tip) {
  const auto draft = unlocked([&] {
    std::vector<diagnose::DraftFile> given;
    for (const auto& [title, text] : tables) given.push_back({title, text});
    return diagnose::draft_experiment(name, diagnose::read_draft_model(file, joints, {base, tip}).model,
                                      given, {}, diagnose::told_columns(columns));
  });
  py::list guesses;
  for (const diagnose::Guess& one : draft.guesses)
    guesses.append(py::make_tuple(one.what, one.value, one.reason, one.doubtful));
  py::dict files;
  for (const diagnose::DraftFile& table : draft.tables) files[py::str(table.name)] = table.text;
  py::dict result;
  result["settings"] = draft.settings, result["tables"] = files;
  result["guesses"] = guesses, result["question"] = draft.question;
  return result;
}

}  // namespace

void add_models(py::module_& module) {
  using namespace py::literals;
  module.def("chain", &chain_of, "file"_a, "joints"_a);
  module.def("arm", &arm_of, "file"_a, "base"_a, "tip"_a);
  module.def("draft", &draft_of, "name"_a, "model"_a, "joints"_a, "tables"_a, "columns"_a, "base"_a, "tip"_a);
}

}  // namespace plumbline::python
