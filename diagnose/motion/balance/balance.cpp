#include "diagnose/motion/balance/balance.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>
#include <plumbline/base/parallel.hpp>

#include "diagnose/exchange/physical_body.hpp"

namespace plumbline::motion {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// The terms that the motions determine, and how the others stand in them.
struct Basis {
  std::vector<Index> terms;
  MatrixXd grouping;  ///< of all terms, by the determined ones
};

Basis basis_of(const MatrixXd& normal) {
  constexpr double least = 1e-6;  // of a column beside those before it, over itself; both squared
  // A column of rounding alone, that of the angles in the model too, over the largest; both squared.
  constexpr double rounding = 1e-10;
  Basis basis;
  const double largest = normal.diagonal().maxCoeff();
  const auto acts = [&](Index k) { return normal(k, k) > rounding * largest; };
  for (Index k = 0; k < normal.cols(); ++k) {
    if (!acts(k)) continue;
    const MatrixXd own = normal(basis.terms, basis.terms);
    const VectorXd across = normal(basis.terms, std::vector<Index>{k});
    const double left =
        basis.terms.empty() ? normal(k, k) : normal(k, k) - across.dot(own.ldlt().solve(across));
    if (left > least * normal(k, k)) basis.terms.push_back(k);
  }
  const Eigen::LDLT<MatrixXd> own(MatrixXd(normal(basis.terms, basis.terms)));
  basis.grouping = own.solve(MatrixXd(normal(basis.terms, Eigen::all)));
  for (std::size_t row = 0; row < basis.terms.size(); ++row)
    for (Index k = 0; k < normal.cols(); ++k) {
      double& share = basis.grouping(static_cast<Index>(row), k);
      const double part = share * share * normal(basis.terms[row], basis.terms[row]);
      if (!acts(k) || part < least * normal(k, k)) share = 0;
    }
  return basis;
}

/// Least squares over all logs at one lead.
struct Solution {
  VectorXd value;
  VectorXd square;  ///< mean over stretches, by joint
};

class Regression {
 public:
  Regression(const TorqueBench& bench) : joints_(static_cast<Index>(bench.arm.arm.size())) {
    logs_.resize(bench.logs.size());
    in_parallel(logs_.size(), available_threads(),
                [&](std::size_t i) { logs_[i] = stretches_of(bench.arm, bench.logs[i]); });
    weight_ = VectorXd::Ones(joints_);
    basis_ = basis_of(normal());
    if (basis_.terms.empty())
      throw Error(bench.name, "no motion that determines a number", "joints that move");
  }
  [[nodiscard]] const Basis& basis() const { return basis_; }
  [[nodiscard]] const std::vector<Stretches>& logs() const { return logs_; }
  /// Of a square, by joint.
  [[nodiscard]] const VectorXd& weight() const { return weight_; }

  /// The lead with which least is left; the joints then weigh by what is left of them.
  std::size_t settle() {
    std::size_t best = 0;
    for (int round = 0; round < 2; ++round) {
      double least = std::numeric_limits<double>::infinity();
      VectorXd square;
      for (std::size_t l = 0; l < leads().size(); ++l) {
        const VectorXd here = solved(l).square;
        if (const double sum = here.cwiseProduct(weight_).sum(); sum < least)
          least = sum, best = l, square = here;
      }
      weight_ = square.cwiseMax(1e-12).cwiseInverse();
    }
    return best;
  }
  [[nodiscard]] Solution solved(std::size_t lead) const {
    const MatrixXd own = normal()(basis_.terms, basis_.terms);
    VectorXd right = VectorXd::Zero(own.cols());
    each(
        [&](const MatrixXd& columns, const VectorXd& torque) {
          right += MatrixXd(columns(Eigen::all, basis_.terms)).transpose() * weight_.cwiseProduct(torque);
        },
        lead);
    Solution solution{own.ldlt().solve(right), VectorXd::Zero(joints_)};
    double count = 0;
    each(
        [&](const MatrixXd& columns, const VectorXd& torque) {
          solution.square += (torque - columns(Eigen::all, basis_.terms) * solution.value).cwiseAbs2();
          ++count;
        },
        lead);
    solution.square /= count;
    return solution;
  }
  /// Of the values, where stretches of a block are not independent.
  [[nodiscard]] MatrixXd covariance(const Solution& solution, std::size_t lead) const {
    const MatrixXd own = normal()(basis_.terms, basis_.terms);
    MatrixXd scatter = MatrixXd::Zero(own.rows(), own.cols());
    for (const Stretches& log : logs_) {
      VectorXd sum = VectorXd::Zero(own.cols());
      double begun = log.time.empty() ? 0 : log.time.front();
      for (std::size_t k = 0; k < log.time.size(); ++k) {
        if (log.time[k] - begun >= block_duration) {
          scatter += sum * sum.transpose();
          sum.setZero(), begun = log.time[k];
        }
        const MatrixXd columns = log.columns[k](Eigen::all, basis_.terms);
        sum += columns.transpose() * weight_.cwiseProduct(log.torque[lead][k] - columns * solution.value);
      }
      scatter += sum * sum.transpose();
    }
    const MatrixXd inverse = own.ldlt().solve(MatrixXd::Identity(own.rows(), own.cols()));
    return inverse * scatter * inverse;
  }

 private:
  template <class Visit>
  void each(const Visit& visit, std::size_t lead) const {
    for (const Stretches& log : logs_)
      for (std::size_t k = 0; k < log.time.size(); ++k) visit(log.columns[k], log.torque[lead][k]);
  }
  [[nodiscard]] MatrixXd normal() const {
    MatrixXd sum;
    each(
        [&](const MatrixXd& columns, const VectorXd&) {
          if (sum.size() == 0) sum = MatrixXd::Zero(columns.cols(), columns.cols());
          sum += columns.transpose() * weight_.asDiagonal() * columns;
        },
        0);
    return sum;
  }

  Index joints_;
  std::vector<Stretches> logs_;
  VectorXd weight_;
  Basis basis_;
};

/// "Izz(1) + 0.09 m(2)"
std::string name_of(const Basis& basis, std::size_t row, const std::vector<BalanceTerm>& terms) {
  std::string name = terms[static_cast<std::size_t>(basis.terms[row])].name;
  for (Index k = 0; k < basis.grouping.cols(); ++k) {
    const double share = basis.grouping(static_cast<Index>(row), k);
    if (k == basis.terms[row] || share == 0) continue;
    name += fmt::format(" {} {}{}", share < 0 ? "-" : "+",
                        std::abs(std::abs(share) - 1) < 1e-6 ? "" : fmt::format("{:.4g} ", std::abs(share)),
                        terms[static_cast<std::size_t>(k)].name);
  }
  return name;
}

TorqueLeft left_of(const diagnose::NominalArm& arm, const TorqueLog& log, bool held_out, std::size_t lead,
                   const VectorXd& stated, const VectorXd& found) {
  const Stretches all = stretches_of(arm, log);
  VectorXd whole = VectorXd::Zero(log.torque.cols()), model = whole, rest = whole;
  for (std::size_t k = 0; k < all.time.size(); ++k) {
    const VectorXd& torque = all.torque[lead][k];
    whole += torque.cwiseAbs2();
    model += (torque - all.columns[k] * stated).cwiseAbs2();
    rest += (torque - all.columns[k] * found).cwiseAbs2();
  }
  const auto root = [&](const VectorXd& sum) {
    const VectorXd mean = (sum / std::max<double>(1, static_cast<double>(all.time.size()))).cwiseSqrt();
    return std::vector<double>(mean.begin(), mean.end());
  };
  return {log.name, held_out, root(whole), root(model), root(rest)};
}

/// What a model says of its links that no body can be.
std::vector<std::string> contradictions_in(const TorqueBench& bench) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < bench.arm.arm.size(); ++i) {
    const ArmLink<double>& link = bench.arm.arm.links[i];
    const Eigen::Vector3d c = link.centre;
    const Eigen::Matrix3d about_centre =
        bench.inertia[i] - link.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
    if (const std::string words = exchange::impossible_inertia(about_centre); !words.empty())
      all.push_back(fmt::format("{} has {}", bench.arm.link[i], words));
  }
  return all;
}

}  // namespace

Balance balance_of(const TorqueBench& bench) {
  Regression regression(bench);
  const std::size_t lead = regression.settle();
  const Solution solution = regression.solved(lead);
  const MatrixXd covariance = regression.covariance(solution, lead);
  const Basis& basis = regression.basis();
  const std::vector<BalanceTerm> terms = balance_terms(bench.arm.arm.size());
  const VectorXd stated = stated_terms(bench.arm, bench.inertia);
  Balance result;
  result.name = bench.name;
  result.lead = leads()[lead];
  VectorXd found = VectorXd::Zero(static_cast<Index>(terms.size()));
  constexpr double two_sided = 1.959964;  // 95 %
  for (std::size_t b = 0; b < basis.terms.size(); ++b) {
    const auto row = static_cast<Index>(b);
    const double value = solution.value(row), half = two_sided * std::sqrt(covariance(row, row));
    found(basis.terms[b]) = value;
    result.numbers.push_back({name_of(basis, b, terms), terms[static_cast<std::size_t>(basis.terms[b])].unit,
                              value, value - half, value + half, basis.grouping.row(row).dot(stated)});
  }
  for (const bool held_out : {false, true})
    for (const TorqueLog& log : held_out ? bench.held_out : bench.logs) {
      result.left.push_back(left_of(bench.arm, log, held_out, lead, stated, found));
      ++result.logs, result.readings += log.time.size();
    }
  result.causes = balance_causes(bench.arm, regression.logs(), lead, stated, regression.weight());
  result.contradictions = contradictions_in(bench);
  return result;
}

}  // namespace plumbline::motion
