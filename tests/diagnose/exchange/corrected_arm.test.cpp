#include "diagnose/exchange/corrected_arm.hpp"

#include <doctest/doctest.h>

#include <plumbline/arm/arm_equilibrium.hpp>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/roll_pitch_yaw.hpp"
#include "diagnose/exchange/arm_document.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/exchange/arm_in_mujoco.hpp"
#include "tests/diagnose/exchange/drawn_arm.hpp"
#include "tests/folder.hpp"

// A corrected file, read again, is the corrected arm.
namespace plumbline::exchange {
namespace {

using namespace test;

/// Numbers are written with fifteen digits; sums of a dozen turned places of a metre or so.
constexpr double rounding = 1e-12;

Eigen::Isometry3d drawn_move() {
  const auto [x, y, z] = drawn_vector();
  const auto [a, b, c] = drawn_vector();
  Eigen::Isometry3d by = Eigen::Isometry3d::Identity();
  by.translate(0.1 * Eigen::Vector3d(x, y, z));
  by.rotate(Eigen::AngleAxisd(0.1 * a, Eigen::Vector3d::UnitX()) *
            Eigen::AngleAxisd(0.1 * b, Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(0.1 * c, Eigen::Vector3d::UnitZ()));
  return by;
}

Eigen::Vector3d drawn_step() {
  const auto [x, y, z] = drawn_vector();
  return {0.1 * x, 0.1 * y, 0.1 * z};
}

/// Changes some of the joints, masses, the base and the tip.
void disturb(SerialArm<double>& arm) {
  for (ArmLink<double>& link : arm.links) {
    if (choice(2) == 0) link.frame = link.frame * drawn_move();
    if (choice(3) == 0) link.axis = (link.axis + drawn_step()).normalized();
    if (choice(2) == 0) link.mass *= 0.5 + choice(20) / 10.0;
    if (choice(2) == 0) link.centre += drawn_step();
  }
  if (choice(2) == 0) arm.base = arm.base * drawn_move();
  if (choice(2) == 0) arm.tip = arm.tip * drawn_move();
}

void require_same(const SerialArm<double>& read, const SerialArm<double>& wanted) {
  RC_ASSERT(read.size() == wanted.size());
  for (int k = 0; k < 3; ++k) {
    const std::vector<double> q = drawn_coordinates(read.size());
    RC_ASSERT(apart(tip_pose(read, q), tip_pose(wanted, q)) < rounding);
    for (std::size_t i = 0; i < read.size(); ++i) {
      RC_ASSERT(apart(posture(read, q).frame(i), posture(wanted, q).frame(i)) < rounding);
      RC_ASSERT(std::abs(read.links[i].mass - wanted.links[i].mass) < 100 * rounding);
      RC_ASSERT((read.links[i].centre - wanted.links[i].centre).norm() < rounding);
    }
  }
}

/// The file with a random correction, read again; the ends are named.
void check_round_trip(const std::string& name, const std::string& text) {
  const Folder folder;
  folder.write(name, text);
  CorrectedArm corrected{"corrected", folder / name, {"base", "tip"}, {}};
  corrected.arm = read_arm(corrected.source, corrected.ends).nominal.arm;
  disturb(corrected.arm);
  const Written written = edited(corrected);
  for (const Carried& one : written.effects) RC_ASSERT(one.carried);
  const std::string again = "again" + std::filesystem::path(name).extension().string();
  folder.write(again, written.text);
  require_same(read_arm(folder / again, corrected.ends).nominal.arm, corrected.arm);
}

std::string text_in(const CorrectedArm& corrected) {
  return edited(corrected).text;
}

std::string how(const Written& written, const std::string& effect) {
  for (const Carried& one : written.effects)
    if (one.effect == effect) return (one.carried ? "" : "not carried: ") + one.how;
  return "nothing of " + effect;
}

/// Two joints on servos, and a third without; a spring, friction.
const std::string servo_arm = R"(<mujoco><compiler angle="radian"/>
<worldbody><body name="upper"><joint name="a" axis="0 1 0"/><geom size="0.1"/>
<body name="lower" pos="1 0 0"><joint name="b" axis="0 1 0" stiffness="30"/><geom size="0.1"/>
<body name="hand" pos="1 0 0"><joint name="c"/><inertial pos="0 0 0" mass="2" diaginertia="1 1 1"/>
<site name="tool" pos="0 0 1"/></body></body></body></worldbody>
<actuator><position joint="a" kp="100"/></actuator></mujoco>)";

CorrectedArm of(const Folder& folder, const std::string& name, const std::string& text) {
  folder.write(name, text);
  CorrectedArm corrected{"corrected", folder / name, {}, {}};
  corrected.arm = read_arm(corrected.source).nominal.arm;
  return corrected;
}

}  // namespace

TEST_CASE("a corrected URDF, MJCF or SDF, read again, is the corrected arm") {
  check_property("URDF", [] { check_round_trip("arm.urdf", arm_in_urdf(drawn_bodies())); });
  check_property("MJCF", [] { check_round_trip("arm.xml", arm_in_mjcf(drawn_bodies())); });
  check_property("SDF", [] { check_round_trip("arm.sdf", arm_in_sdf(drawn_bodies())); });
}

TEST_CASE("a file without a correction stays as it is but for its head") {
  const Folder folder;
  const Written same = edited(of(folder, "arm.xml", servo_arm));
  CHECK(same.effects.empty());
  REQUIRE(same.text.size() > servo_arm.size());
  CHECK(same.text.substr(same.text.size() - servo_arm.size()) == servo_arm);
}

TEST_CASE("gains, springs, friction and gravity go where the file has them, or it is said why not") {
  const Folder folder;
  CorrectedArm corrected = of(folder, "arm.xml", servo_arm);
  for (ArmLink<double>& link : corrected.arm.links) link.joint_compliance = 1.0 / 60;
  corrected.friction = {0.5, 0, 0};
  corrected.arm.gravity = {0, 1, -9};
  corrected.arm.links[1].compliance(5, 5) = 1e-4;
  corrected.others = {{"encoder_gain(1)", false, "of the sensor"}};
  const Written written = edited(corrected);
  CHECK(how(written, "stiffness of joint a") == "as the gain of the servo");
  CHECK(how(written, "stiffness of joint b") == "as the stiffness of the joint");
  CHECK(how(written, "stiffness of joint c") ==
        "not carried: the joint has neither a servo nor a spring in this file");
  CHECK(how(written, "compliance of link lower") == "not carried: links of this format are rigid");
  CHECK(how(written, "encoder_gain(1)") == "not carried: of the sensor");
  CHECK(written.text.find("NOT CARRIED: encoder_gain(1): of the sensor") != std::string::npos);
  folder.write("again.xml", written.text);
  const SpatialArm again = read_arm(folder / "again.xml");
  CHECK(again.nominal.arm.links[0].joint_compliance == close_to(1.0 / 60));
  CHECK(again.nominal.arm.links[1].joint_compliance == close_to(1.0 / 60));
  CHECK(again.friction == corrected.friction);
  CHECK(again.nominal.arm.gravity == corrected.arm.gravity);
}

TEST_CASE("springs that URDF and SDF have not are added; a URDF has no gravity") {
  for (const char* name : {"arm.urdf", "arm.sdf"}) {
    const Folder folder;
    const DrawnBody body{{false, {0, 0, 1}, {1, 0, 0}, {0, 0, 0}}, 1, {0.5, 0, 0}, false};
    const bool urdf = std::string(name) == "arm.urdf";
    CorrectedArm corrected = of(folder, name, urdf ? arm_in_urdf({body, body}) : arm_in_sdf({body, body}));
    corrected.arm.links[1].joint_compliance = 0.01;
    corrected.friction = {0, 0.7};
    corrected.arm.gravity = {0, 0, -5};
    const Written written = edited(corrected);
    CHECK(how(written, "gravity").starts_with(urdf ? "not carried: " : "as the gravity"));
    const std::string again = urdf ? "again.urdf" : "again.sdf";
    folder.write(again, written.text);
    const SpatialArm read = read_arm(folder / again);
    CHECK(read.nominal.arm.links[0].joint_compliance == 0);
    CHECK(read.nominal.arm.links[1].joint_compliance == close_to(0.01));
    CHECK(read.friction == corrected.friction);
  }
}

TEST_CASE("a payload is a body of its own at the tip") {
  const DrawnBody body{{false, {0, 0, 1}, {1, 0, 0}, {0, 0, 0}}, 1, {0.5, 0, 0}, false};
  for (const auto& [name, text] : {std::pair<std::string, std::string>{"arm.urdf", arm_in_urdf({body})},
                                   {"arm.sdf", arm_in_sdf({body})},
                                   {"arm.xml", arm_in_mjcf({body})}}) {
    CAPTURE(name);
    const Folder folder;
    folder.write(name, text);
    CorrectedArm corrected{"corrected", folder / name, {"base", "tip"}, {}};
    corrected.arm = read_arm(corrected.source, corrected.ends).nominal.arm;
    corrected.payload = {3, {0.1, 0.2, 0.3}};
    folder.write("again" + name, text_in(corrected));
    const ArmLink<double> was = corrected.arm.links.back(),
                          is = read_arm(folder / ("again" + name), corrected.ends).nominal.arm.links.back();
    CHECK(is.mass == close_to(was.mass + 3));
    const Eigen::Vector3d moment = was.mass * was.centre + 3 * (corrected.arm.tip * corrected.payload.centre);
    CHECK((is.mass * is.centre - moment).norm() < 100 * rounding);
  }
}

TEST_CASE("what MuJoCo makes of a corrected MJCF moves and weighs as the corrected arm") {
  const Folder folder;
  CorrectedArm corrected = of(folder, "arm.xml", servo_arm);
  corrected.arm.links[1].frame.translation() += Eigen::Vector3d(0.02, -0.01, 0.03);
  corrected.arm.links[0].mass *= 1.3;
  corrected.arm.links[2].centre += Eigen::Vector3d(0.1, 0, 0);
  folder.write("again.xml", text_in(corrected));
  ArmInMujoco mujoco(folder / "again.xml");
  mujoco.move({"a", "b", "c"}, {0, 0, 0});
  const double at_zero = mujoco.energy();
  mujoco.move({"a", "b", "c"}, {0.3, -0.5, 0.7});
  CHECK(apart(mujoco.site("tool"), tip_pose(corrected.arm, {0.3, -0.5, 0.7})) < rounding);
  // The spring of joint b is of MuJoCo's energy too.
  const double spring = 0.5 * 30 * 0.5 * 0.5;
  CHECK(mujoco.energy() - at_zero - spring ==
        close_to(energy(corrected.arm, {0.3, -0.5, 0.7}) - energy(corrected.arm, {0, 0, 0})));
}

TEST_CASE("roll, pitch and yaw say every rotation, where the pitch is a quarter turn too") {
  check_property("rotation", [] {
    Eigen::Quaterniond turn(drawn_number(), drawn_number(), drawn_number(), drawn_number());
    RC_PRE(turn.norm() > 0.1);
    turn.normalize();
    if (choice(3) == 0)
      turn = Eigen::AngleAxisd(drawn_number(), Eigen::Vector3d::UnitZ()) *
             Eigen::AngleAxisd(std::acos(0.0) + 1e-9 * drawn_number(), Eigen::Vector3d::UnitY()) *
             Eigen::AngleAxisd(drawn_number(), Eigen::Vector3d::UnitX());
    const Eigen::Vector3d angles = diagnose::roll_pitch_yaw(turn.toRotationMatrix());
    const Eigen::Quaterniond again = Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
                                     Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
                                     Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX());
    constexpr double ulps = 1e-14;  // a few roundings
    RC_ASSERT((again.toRotationMatrix() - turn.toRotationMatrix()).cwiseAbs().maxCoeff() < ulps);
  });
}

}  // namespace plumbline::exchange
