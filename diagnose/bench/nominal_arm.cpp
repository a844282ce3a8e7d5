#include "diagnose/bench/nominal_arm.hpp"

#include <plumbline/arm/arm_equilibrium.hpp>

namespace plumbline::diagnose {

Pose<double> nominal_pose(const SerialArm<double>& arm, const OnLink<double>& point,
                          const std::vector<double>& command) {
  const Vector<double> q =
      Eigen::Map<const Vector<double>>(command.data(), static_cast<Eigen::Index>(command.size()));
  return ArmPosture<double>(arm, commanded(arm, q)).of(point);
}

}  // namespace plumbline::diagnose
