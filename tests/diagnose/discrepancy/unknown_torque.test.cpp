#include "diagnose/discrepancy/unknown_torque.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

std::vector<double> unit_coordinate(std::size_t count, std::size_t which) {
  std::vector<double> values(count, 0.0);
  values[which] = 1;
  return values;
}

}  // namespace

TEST_CASE(
    "an unknown torque acts at its joint alone, is nothing at rest, and reaches beyond what is exercised") {
  const Study study(full_bench());
  const auto rows = unknown_torques(study);
  REQUIRE(rows->size() == 2);
  for (const Effect& row : *rows)
    for (std::size_t joint = 0; joint < 3; ++joint) {
      const std::size_t count = study.ranges(EffectAt(row, joint + 1)).size();
      for (std::size_t c = 0; c < count; ++c) {
        const std::vector<FreeLaw::Knot> knots = knots_of(row, joint, study, unit_coordinate(count, c));
        CHECK(knots.front().deflection == close_to(-knots.back().deflection));
        CHECK(knots.back().deflection > study.excitation().deflection[joint]);
        double most = 0;
        for (const FreeLaw::Knot& knot : knots) {
          most = std::max(most, std::abs(knot.torque));
          if (knot.deflection == 0) CHECK(std::abs(knot.torque) < 1e-12);
        }
        CHECK(most > 0);
      }
    }
  // Every value at nothing is the nominal model; any other is the chain that has such a law.
  const EffectAt at(rows->back(), 2);
  std::vector<double> values(study.ranges(at).size(), 0.0);
  CHECK(difference(predict(study, {{at}}, values).runs[0], study.nominal().runs[0]) == 0);
  values[0] = 0.5, values.back() = -1;
  Experiment with = full_bench();
  with.laws = {{2, knots_of(rows->back(), 1, study, values), {}, {}}};
  const Study own(with);
  for (std::size_t r = 0; r < with.runs.size(); ++r)
    CHECK(difference(predict(study, {{at}}, values).runs[r], own.nominal().runs[r]) == 0);
}

TEST_CASE(
    "an unknown torque is a Gaussian process of covariance Matern 5/2 that is known to be zero at rest") {
  const Study study(full_bench());
  const auto rows = unknown_torques(study);
  const auto matern = [](double distance) {
    const double z = std::sqrt(5.0) * std::abs(distance) / 0.35;
    return (1 + z + z * z / 3) * std::exp(-z);
  };
  double scale[2] = {0, 0};
  for (std::size_t size = 0; size < 2; ++size) {
    const Effect& row = (*rows)[size];
    const std::size_t count = study.ranges(EffectAt(row, 1)).size();
    std::vector<std::vector<FreeLaw::Knot>> parts;
    for (std::size_t c = 0; c < count; ++c)
      parts.push_back(knots_of(row, 0, study, unit_coordinate(count, c)));
    const auto n = static_cast<Eigen::Index>(parts.front().size());
    MatrixXd found = MatrixXd::Zero(n, n), prior(n, n);
    const double reach = parts.front().back().deflection;
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) {
        const auto at = [&](const std::vector<FreeLaw::Knot>& part, Eigen::Index k) {
          return part[static_cast<std::size_t>(k)];
        };
        for (const auto& part : parts) found(i, j) += at(part, i).torque * at(part, j).torque;
        const double a = at(parts.front(), i).deflection / reach, b = at(parts.front(), j).deflection / reach;
        prior(i, j) = matern(a - b) - matern(a) * matern(b);
      }
    scale[size] = found.trace() / prior.trace();
    // Principal components that are left out lower the covariance, and nothing else.
    CHECK((found / scale[size] - prior).cwiseAbs().maxCoeff() < 0.05);
  }
  // a small process and a large one: of 3 % and 20 % of the spring's torque
  CHECK(scale[1] / scale[0] == close_to(std::pow(0.2 / 0.03, 2)));
}
