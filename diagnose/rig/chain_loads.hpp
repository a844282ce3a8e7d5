#pragma once
/// \file
/// The loads along a chain, as a rig feels them: moments of tendons and pressures, and forces on links.

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "diagnose/bench/load.hpp"

namespace plumbline::diagnose {

/// The loads along a chain at one time.
struct ChainLoads {
  struct Force {
    std::size_t link;       ///< from 0
    double at;              ///< share of its length
    Eigen::Vector2d value;  ///< N
  };
  std::vector<double> moment;  ///< on each joint, N m; empty where nothing loads the chain
  std::vector<Force> forces;
};

/// Loads between two times, by linear interpolation.
/// \param from  the same loads, or none
ChainLoads between(const ChainLoads& from, const ChainLoads& to, double share);

/// The loads on a rig along a run, in which tendons rub. From one joint that it passes to the next, a tendon
/// keeps its tension until it differs by a factor exp(mu) from that before the joint (capstan), and then
/// slips.
class LoadHistory {
 public:
  /// \param loads             outlive it
  /// \param moment_arm_error  relative, of all moment arms
  /// \param friction          mu of each tendon, from joint to joint
  LoadHistory(const std::vector<Load>& loads, std::size_t joints, double moment_arm_error = 0,
              double friction = 0);

  /// The loads at the next reading.
  /// \param covariates  of the reading
  ChainLoads next(std::span<const double> covariates);

 private:
  /// Moments of a tendon or a pressure.
  /// \param tension  of a tendon at each joint; is brought to the reading
  void add_moments(const Load& load, double value, std::vector<double>& tension,
                   std::vector<double>& moment) const;

  const std::vector<Load>* loads_;
  std::size_t joints_;
  double moment_arm_error_, friction_;
  std::vector<std::vector<double>> tension_;  ///< by load and joint
};

}  // namespace plumbline::diagnose
