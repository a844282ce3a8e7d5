#include "diagnose/motion/balance/balance_causes.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>

#include "diagnose/motion/balance/balance_terms.hpp"

namespace plumbline::motion {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Terms of a load of mass one at a place in the frame of the last link.
VectorXd load_terms(std::size_t joints, const Eigen::Vector3d& at) {
  const auto n = static_cast<Index>(joints);
  VectorXd terms = VectorXd::Zero(n * (terms_of_link + terms_of_joint));
  const Eigen::Matrix3d inertia = at.squaredNorm() * Eigen::Matrix3d::Identity() - at * at.transpose();
  terms.segment(terms_of_link * (n - 1), terms_of_link) << 1, at, inertia(0, 0), inertia(1, 1), inertia(2, 2),
      inertia(0, 1), inertia(0, 2), inertia(1, 2);
  return terms;
}

/// A change: torques over its number, one column a number, out of the columns of the terms.
struct Change {
  std::string id, words, name, unit;
  std::function<VectorXd(const MatrixXd& columns)> torque;  ///< by joint, at number one
};

std::vector<Change> changes(const diagnose::NominalArm& arm, const VectorXd& stated) {
  const std::size_t joints = arm.arm.size();
  const VectorXd load = load_terms(joints, arm.arm.tip.translation());
  std::vector<Change> all{{"payload", "a load at the tip", "m", "kg",
                           [load](const MatrixXd& columns) { return columns * load; }}};
  for (std::size_t j = 0; j < joints; ++j)
    all.push_back({fmt::format("torque_constant({})", j + 1),
                   fmt::format("another torque constant of the drive of {}", arm.joint[j]), "e", "ratio",
                   [stated, j](const MatrixXd& columns) {
                     VectorXd torque = VectorXd::Zero(columns.rows());
                     torque(static_cast<Index>(j)) = columns.row(static_cast<Index>(j)).dot(stated);
                     return torque;
                   }});
  if (joints > 1)
    all.push_back({"torque_constants", "one factor of all drives' torques", "e", "ratio",
                   [stated](const MatrixXd& columns) { return columns * stated; }});
  return all;
}

/// Least squares of what the model leaves, by the joints' own terms and a change.
class ChangeFit {
 public:
  ChangeFit(const std::vector<Stretches>& logs, std::size_t lead, const VectorXd& stated,
            const VectorXd& weight)
      : logs_(logs), lead_(lead), stated_(stated), weight_(weight) {}

  [[nodiscard]] BalanceCause of(const Change* change) const {
    const Index joints = weight_.size(), own = joints * terms_of_joint, size = own + (change ? 1 : 0);
    MatrixXd normal = MatrixXd::Zero(size, size);
    VectorXd right = VectorXd::Zero(size);
    each(change, [&](const MatrixXd& columns, const VectorXd& left) {
      normal += columns.transpose() * weight_.asDiagonal() * columns;
      right += columns.transpose() * weight_.cwiseProduct(left);
    });
    normal.diagonal().array() += 1e-12 * normal.diagonal().maxCoeff();  // of joints that did not move
    const Eigen::LDLT<MatrixXd> factor(normal);
    const VectorXd value = factor.solve(right);
    VectorXd square = VectorXd::Zero(joints);
    double stretches = 0;
    each(change, [&](const MatrixXd& columns, const VectorXd& left) {
      square += (left - columns * value).cwiseAbs2(), ++stretches;
    });
    const double readings = static_cast<double>(joints) * std::max(1.0, stretches * stretch_share()),
                 chi2 = square.dot(weight_) * stretch_share();
    BalanceCause cause{"as_stated", "the model as it is stated", {}, {}, 0};
    if (change) {
      const double variance =
                       chi2 / readings / stretch_share() * factor.solve(VectorXd::Unit(size, own))(own),
                   half = 1.959964 * std::sqrt(variance);
      cause.id = change->id, cause.words = change->words;
      cause.numbers.push_back({change->name, change->unit, value(own), value(own) - half, value(own) + half});
    }
    const VectorXd left = (square / stretches).cwiseSqrt();
    cause.left.assign(left.begin(), left.end());
    cause.probability = -readings / 2 * std::log(chi2) - (change ? 0.5 * std::log(readings) : 0);
    return cause;
  }

 private:
  /// The share of stretches that are independent.
  static double stretch_share() { return mean_of_balance / block_duration; }

  template <class Visit>
  void each(const Change* change, const Visit& visit) const {
    const Index joints = weight_.size(), own = joints * terms_of_joint;
    for (const Stretches& log : logs_)
      for (std::size_t k = 0; k < log.time.size(); ++k) {
        const MatrixXd& all = log.columns[k];
        MatrixXd columns(joints, own + (change ? 1 : 0));
        columns.leftCols(own) = all.rightCols(own);
        if (change) columns.col(own) = change->torque(all);
        visit(columns, log.torque[lead_][k] - all * stated_);
      }
  }

  const std::vector<Stretches>& logs_;
  std::size_t lead_;
  const VectorXd &stated_, &weight_;
};

}  // namespace

std::vector<BalanceCause> balance_causes(const diagnose::NominalArm& arm, const std::vector<Stretches>& logs,
                                         std::size_t lead, const VectorXd& stated, const VectorXd& weight) {
  const ChangeFit fit(logs, lead, stated, weight);
  std::vector<BalanceCause> all{fit.of(nullptr)};
  for (const Change& one : changes(arm, stated)) all.push_back(fit.of(&one));
  std::stable_sort(all.begin(), all.end(), [](const BalanceCause& a, const BalanceCause& b) {
    return a.probability > b.probability;
  });
  const double best = all.front().probability;
  double sum = 0;
  for (BalanceCause& one : all) sum += one.probability = std::exp(one.probability - best);
  for (BalanceCause& one : all) one.probability /= sum;
  return all;
}

}  // namespace plumbline::motion
