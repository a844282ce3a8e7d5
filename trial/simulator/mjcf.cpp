#include "trial/simulator/mjcf.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace plumbline::simulator {
namespace {

/// Gauss-Legendre points and weights on (0, 1).
const double gauss_reach = std::sqrt(0.6);
const std::array<double, 3> gauss_point{(1 - gauss_reach) / 2, 0.5, (1 + gauss_reach) / 2};
const std::array<double, 3> gauss_weight{5.0 / 18, 8.0 / 18, 5.0 / 18};

/// MuJoCo refuses bodies without mass; armature is what moves here.
constexpr double speck = 1e-9;

class Writer {
 public:
  Writer(const Plan& plan, const Physics& physics, const PlannedRun& run, const Pace& pace)
      : physics_(physics), run_(run), pace_(pace), typical_(plan.typical_stiffness()) {}

  std::string chain() {
    open("base", 0);
    if (physics_.base_compliance[0] > 0) slide("base_x", "1 0 0", 1 / physics_.base_compliance[0]);
    if (physics_.base_compliance[1] > 0) slide("base_y", "0 1 0", 1 / physics_.base_compliance[1]);
    for (std::size_t j = 0; j < physics_.length.size(); ++j) link(j);
    open("tip", at_, physics_.tip_mass);
    text_ += "<site name=\"end\"/>";
    for (std::size_t i = 0; i < depth_; ++i) text_ += "</body>";
    return text_;
  }

  std::string carriage() {
    text_.clear();
    open("carriage", 0);
    slide("train", "1 0 0", 1 / physics_.train_compliance);
    return text_ + "</body>";
  }

 private:
  void open(const std::string& name, double at, double mass = 0) {
    text_ += fmt::format("<body name=\"{}\" pos=\"{:.17g} 0 0\">", name, at);
    inertial(0, std::max(mass, speck));
    ++depth_;
    at_ = 0;
  }
  void inertial(double at, double mass) {
    text_ += fmt::format("<inertial pos=\"{:.17g} 0 0\" mass=\"{:.17g}\" diaginertia=\"{} {} {}\"/>", at,
                         mass, speck, speck, speck);
  }
  /// Without a spring of its own a joint moves at the pace of a typical one.
  std::string dynamics(double stiffness, double typical) const {
    const double felt = stiffness > 0 ? stiffness : typical;
    return fmt::format("stiffness=\"{:.17g}\" armature=\"{:.17g}\" damping=\"{:.17g}\"", stiffness,
                       felt * pace_.response * pace_.response, 2 * felt * pace_.response);
  }
  void slide(const std::string& name, const char* axis, double stiffness) {
    text_ += fmt::format("<joint name=\"{}\" type=\"slide\" axis=\"{}\" {}/>", name, axis,
                         dynamics(stiffness, stiffness));
  }
  void hinge(const std::string& name, double stiffness, double typical, double rest = 0) {
    text_ += fmt::format("<joint name=\"{}\" type=\"hinge\" axis=\"0 0 1\" springref=\"{:.17g}\" {}/>", name,
                         rest, dynamics(stiffness, typical));
  }
  void link(std::size_t j) {
    const Joint& joint = physics_.joint[j];
    open(fmt::format("link{}", j + 1), at_);
    hinge(fmt::format("q{}", j + 1), joint.plain() ? joint.stiffness : 0,
          joint.stiffness > 0 ? joint.stiffness : typical_, rest_angle(physics_, run_, j));
    text_ += fmt::format("<site name=\"axis{}\"/>", j + 1);
    if (physics_.mass[j] > 0) {
      text_ += fmt::format("<body name=\"mass{}\">", j + 1);
      inertial(physics_.length[j] / 2, physics_.mass[j]);
      text_ += "</body>";
    }
    if (physics_.flexibility > 0) {
      beam(j);
    } else {
      at_ = physics_.length[j];
    }
    if (physics_.axial > 0) {
      open(fmt::format("bar{}", j + 1), at_);
      slide(fmt::format("stretch{}", j + 1), "1 0 0", 1 / (physics_.axial * physics_.length[j]));
    }
  }
  void beam(std::size_t j) {
    const double length = physics_.length[j];
    double behind = 0;
    for (std::size_t g = 0; g < 3; ++g) {
      open(fmt::format("beam{}_{}", j + 1, g), (gauss_point[g] - behind) * length);
      hinge(fmt::format("bend{}_{}", j + 1, g), 1 / (physics_.flexibility * gauss_weight[g] * length), 0);
      behind = gauss_point[g];
    }
    at_ = (1 - behind) * length;
  }

  const Physics& physics_;
  const PlannedRun& run_;
  const Pace& pace_;
  double typical_;
  std::string text_;
  std::size_t depth_ = 0;
  double at_ = 0;  ///< where the next body starts, in the frame of the open one
};

std::string tendons(const Physics& physics) {
  std::string all;
  if (physics.tip_stiffness > 0) {
    all += fmt::format("<fixed name=\"pivot\" stiffness=\"{:.17g}\">", physics.tip_stiffness);
    for (std::size_t j = 0; j < physics.length.size(); ++j) {
      all += fmt::format("<joint joint=\"q{}\" coef=\"1\"/>", j + 1);
      for (int g = 0; g < 3 && physics.flexibility > 0; ++g)
        all += fmt::format("<joint joint=\"bend{}_{}\" coef=\"1\"/>", j + 1, g);
    }
    all += "</fixed>";
  }
  if (physics.band.joint > 0) {
    all += fmt::format(
        "<spatial name=\"band\" stiffness=\"{:.17g}\"><site site=\"axis1\"/><site "
        "site=\"axis{}\"/></spatial>",
        physics.band.stiffness, physics.band.joint + 1);
  }
  return all.empty() ? all : "<tendon>" + all + "</tendon>";
}

}  // namespace

std::string mjcf(const Plan& plan, const Physics& physics, const PlannedRun& run, const Pace& pace) {
  Writer writer(plan, physics, run, pace);
  const std::string chain = writer.chain();
  const bool train = physics.train_compliance > 0 && !run.force_controlled;
  const std::string hold = fmt::format(
      "<equality><connect name=\"hold\" body1=\"tip\" body2=\"{}\" anchor=\"0 0 0\" "
      "solref=\"{:.17g} 1\" solimp=\"0.9999 0.9999 1\"/></equality>",
      train ? "carriage" : "world", 2 * pace.timestep);
  // All damping is that of joints, which Euler's rule takes implicitly; the derivatives of MuJoCo's implicit
  // rule would cost two fifths of a step.
  return fmt::format(
      "<mujoco><compiler angle=\"radian\" inertiafromgeom=\"false\"/>"
      "<option timestep=\"{:.17g}\" gravity=\"{:.17g} {:.17g} 0\" integrator=\"Euler\" solver=\"Newton\" "
      "tolerance=\"1e-13\" iterations=\"100\"><flag contact=\"disable\"/></option>"
      "<worldbody>{}{}</worldbody>{}{}</mujoco>",
      pace.timestep, standard_gravity * plan.down[0], standard_gravity * plan.down[1], chain,
      train ? writer.carriage() : "", tendons(physics), run.force_controlled ? "" : hold);
}

}  // namespace plumbline::simulator
