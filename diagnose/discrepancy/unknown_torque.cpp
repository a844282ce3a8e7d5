#include "diagnose/discrepancy/unknown_torque.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "diagnose/rig/effects/each_joint.hpp"

namespace plumbline::diagnose {
namespace {

constexpr Eigen::Index knots = 21, components = 8;
constexpr double length = 0.35;      // of the process, over the largest deflection
constexpr double reach_share = 1.3;  // the deflections may be so many times those of the nominal model

double matern(double distance) {
  const double z = std::sqrt(5.0) * std::abs(distance) / length;
  return (1 + z + z * z / 3) * std::exp(-z);
}

/// Torques at the knots, over size times stiffness times the largest deflection; a column a component.
const Eigen::MatrixXd& principal_components() {
  static const Eigen::MatrixXd all = [] {
    Eigen::MatrixXd k(knots, knots);
    const auto place = [](Eigen::Index i) { return 2.0 * static_cast<double>(i) / (knots - 1) - 1; };
    for (Eigen::Index i = 0; i < knots; ++i)
      for (Eigen::Index j = 0; j < knots; ++j)
        k(i, j) = matern(place(i) - place(j)) - matern(place(i)) * matern(place(j));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(k);
    return Eigen::MatrixXd(eigen.eigenvectors().rightCols(components) *
                           eigen.eigenvalues().tail(components).cwiseMax(0).cwiseSqrt().asDiagonal());
  }();
  return all;
}

std::vector<FreeLaw::Knot> law(double reach, double torque, const double* value) {
  const Eigen::VectorXd torques =
      torque * (principal_components() * Eigen::Map<const Eigen::VectorXd>(value, components));
  std::vector<FreeLaw::Knot> result;
  for (Eigen::Index i = 0; i < knots; ++i)
    result.push_back({reach * (2.0 * static_cast<double>(i) / (knots - 1) - 1), torques(i)});
  return result;
}

Effect row(std::vector<double> reach, double size) {
  return {.id = unknown_torque,
          .words = "an unknown torque at joint {}",
          .at_joint = true,
          .parameters =
              [](const Place&) {
                std::vector<ParameterRange> all;
                for (Eigen::Index c = 0; c < components; ++c)
                  all.push_back({numbered("w", static_cast<std::size_t>(c)), "ratio", Coordinate::plain, 0.3,
                                 -30, 30, 1});
                return all;
              },
          .add =
              [reach, size](const Addition& to) {
                const double most = reach[to.joint], k = to.scales.stiffness_at(to.joint);
                to.rig.laws.push_back({to.joint + 1, law(most, size * k * most, to.value), {}, {}});
              },
          .outside = true};
}

std::vector<double> reaches(const Study& study) {
  std::vector<double> reach = study.excitation().deflection;
  for (double& one : reach)
    one = reach_share * std::max(one, 1e-3 * std::max(study.excitation().largest, 1e-3));
  return reach;
}

}  // namespace

std::shared_ptr<const std::vector<Effect>> unknown_torques(const Study& study) {
  auto rows = std::make_shared<std::vector<Effect>>();
  for (const double size : {0.03, 0.2}) rows->push_back(row(reaches(study), size));
  return rows;
}

std::vector<FreeLaw::Knot> knots_of(const Effect& effect, std::size_t joint, const Study& study,
                                    const std::vector<double>& parameters) {
  Rig rig = study.nominal_rig();
  effect.add({rig, joint, study.scales(), study.experiment().bench.down(), parameters.data()});
  return rig.laws.back().knots;
}

}  // namespace plumbline::diagnose
