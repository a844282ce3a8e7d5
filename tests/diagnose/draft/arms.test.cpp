#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <plumbline/base/error.hpp>

#include "diagnose/draft/draft.hpp"
#include "support/files/toml_file.hpp"

// Poses of an arm, whatever its tables call them and wherever the tracker stands.
namespace plumbline::diagnose {
namespace {

/// Three joints about z, y and y.
DraftModel three_joints() {
  NominalArm nominal;
  SerialArm<double>& serial = nominal.arm;
  serial.links.resize(3);
  serial.links[0].frame.translation() = Eigen::Vector3d(0, 0, 0.1);
  for (std::size_t i : {std::size_t{1}, std::size_t{2}}) {
    serial.links[i].axis = Eigen::Vector3d(0, 1, 0);
    serial.links[i].frame.translation() = Eigen::Vector3d(i == 1 ? 0.05 : 0.3, 0, i == 1 ? 0.2 : 0);
  }
  for (ArmLink<double>& link : serial.links) link.mass = 1;
  serial.tip.translation() = Eigen::Vector3d(0.25, 0, 0.02);
  nominal.base = "base", nominal.tip = "tool";
  nominal.joint = {"pan", "lift", "elbow"}, nominal.link = {"a", "b", "c"};
  nominal.limits.assign(3, {-3, 3});
  DraftModel model;
  model.arm = std::make_shared<const NominalArm>(nominal);
  model.file = {"arm.urdf", "<robot/>"};
  return model;
}

std::vector<double> pose(int i) {
  return {std::sin(1.7 * i), 0.8 * std::sin(2.9 * i + 1), 0.9 * std::cos(3.7 * i)};
}

Pose<double> nominal_place(const std::vector<double>& command) {
  const NominalArm one = *three_joints().arm;
  return nominal_pose(one.arm, {2, one.arm.tip}, command);
}

/// A column of a table of the draft, by its name.
std::vector<double> column(const Draft& draft, const std::string& name) {
  std::istringstream in(draft.tables.front().text);
  std::string line, field;
  std::getline(in, line);
  std::istringstream head(line);
  std::size_t place = 0;
  for (; std::getline(head, field, ',') && field != name; ++place) continue;
  REQUIRE(field == name);
  std::vector<double> all;
  while (std::getline(in, line)) {
    std::istringstream row(line);
    for (std::size_t c = 0; c <= place; ++c) field.clear(), std::getline(row, field, ',');
    all.push_back(field.empty() ? NAN : std::stod(field));
  }
  return all;
}

/// Joints in degrees, places in mm in a frame of the tracker's own.
std::string poses_table(const Pose<double>& frame, const std::string& head, int poses = 12) {
  std::string text = head + "\n";
  for (int i = 0; i < poses; ++i) {
    const std::vector<double> q = pose(i);
    const Eigen::Vector3d at = 1000 * (frame * nominal_place(q).translation());
    text += fmt::format("{:.6f},{:.6f},{:.6f},{:.4f},{:.4f},{:.4f}\n", q[0] * 180 / M_PI, q[1] * 180 / M_PI,
                        q[2] * 180 / M_PI, at.x(), at.y(), at.z());
  }
  return text;
}

Pose<double> foreign() {
  Pose<double> frame = Pose<double>::Identity();
  frame.linear() = Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  frame.translation() = Eigen::Vector3d(1.2, -0.4, 0.9);
  return frame;
}

}  // namespace

TEST_CASE("poses of an arm are drafted whatever their columns are called") {
  for (const char* head :
       {"q1,q2,q3,x,y,z", "pan (deg),lift (deg),elbow (deg),tip_x [mm],tip_y [mm],tip_z [mm]",
        "J1_cmd,J2_cmd,J3_cmd,Position X,Position Y,Position Z",
        "joint_1_pos,joint_2_pos,joint_3_pos,tcp.x,tcp.y,tcp.z",
        "Gelenk 1,Gelenk 2,Gelenk 3,X (mm),Y (mm),Z (mm)"}) {
    CAPTURE(head);
    const Draft draft =
        draft_experiment("arm", three_joints(), {{"poses.csv", poses_table(Pose<double>::Identity(), head)}});
    CAPTURE(draft.settings);
    CHECK(draft.question == "");
    CHECK(draft.bench == BenchKind::arm);
    const std::vector<double> lift = column(draft, "q_command2"), z = column(draft, "tip_z");
    for (int i = 0; i < 12; ++i) {
      // six digits of a degree, four of a millimetre
      CHECK(std::abs(lift[static_cast<std::size_t>(i)] - pose(i)[1]) < 1e-8);
      CHECK(std::abs(z[static_cast<std::size_t>(i)] - nominal_place(pose(i)).translation().z()) < 1e-7);
    }
  }
}

TEST_CASE("the frame of the tracker is told, and with it the model has the readings") {
  const Draft draft =
      draft_experiment("arm", three_joints(), {{"poses.csv", poses_table(foreign(), "q1,q2,q3,x,y,z")}});
  CAPTURE(draft.settings);
  CHECK(draft.question == "");
  const toml::table settings = files::parse_toml(draft.settings, "experiment.toml");
  const auto* place = settings["arm"]["base_xyz"].as_array();
  REQUIRE(place != nullptr);
  for (std::size_t axis = 0; axis < 3; ++axis)
    // places were written to a ten-thousandth of a millimetre
    CHECK(std::abs(*place->get(axis)->value<double>() -
                   foreign().translation()(static_cast<Eigen::Index>(axis))) < 1e-6);
  CHECK(settings["arm"]["frames"].value<std::string>() == "unknown");
  const auto* gravity = settings["arm"]["gravity"].as_array();
  REQUIRE(gravity != nullptr);
  const Eigen::Vector3d down = foreign().linear() * Eigen::Vector3d(0, 0, -9.81);
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(std::abs(*gravity->get(axis)->value<double>() - down(static_cast<Eigen::Index>(axis))) < 1e-5);
}

TEST_CASE("a frame that is a little off stays for the diagnosis to find") {
  Pose<double> near = Pose<double>::Identity();
  near.translation() = Eigen::Vector3d(0.002, 0, 0);
  const Draft draft =
      draft_experiment("arm", three_joints(), {{"poses.csv", poses_table(near, "q1,q2,q3,x,y,z")}});
  CHECK(draft.settings.find("base_xyz") == std::string::npos);
}

TEST_CASE("wires, a camera and a level are drafted as sensors that stand anywhere") {
  std::string text = "J1 (deg),J2 (deg),J3 (deg),Wire 1 [mm],wire_2,cam_u,cam_v,tilt_x [deg],tilt_y [deg]\n";
  for (int i = 0; i < 12; ++i) {
    const std::vector<double> q = pose(i);
    text += fmt::format("{:.6f},{:.6f},{:.6f},{},{},{},{},{},{}\n", q[0] * 180 / M_PI, q[1] * 180 / M_PI,
                        q[2] * 180 / M_PI, 1000 + i, 900 + i, 3 + i, 5 - i, 10 + i, -20 - i);
  }
  const Draft draft = draft_experiment("arm", three_joints(), {{"poses.csv", text}});
  CAPTURE(draft.settings);
  CHECK(draft.question == "");
  const toml::table settings = files::parse_toml(draft.settings, "experiment.toml");
  CHECK(settings["arm"]["frames"].value<std::string>() == "unknown");
  const auto* drafted = settings["arm"]["sensor"].as_array();
  REQUIRE(drafted != nullptr);
  const std::vector<std::array<std::string, 2>> wanted{
      {"wire_1", "distance"}, {"wire_2", "distance"}, {"cam", "camera"}, {"tilt", "inclinometer"}};
  REQUIRE(drafted->size() == wanted.size());
  for (std::size_t s = 0; s < wanted.size(); ++s) {
    CHECK(toml::node_view(*drafted->get(s))["name"].value<std::string>() == wanted[s][0]);
    CHECK(toml::node_view(*drafted->get(s))["kind"].value<std::string>() == wanted[s][1]);
  }
  CHECK(column(draft, "wire_1").front() == doctest::Approx(1.0));  // m
  CHECK(column(draft, "wire_2").front() == doctest::Approx(0.9));  // no unit: longer than any arm in m
  CHECK(column(draft, "cam_u").front() == doctest::Approx(3.0));
  CHECK(column(draft, "tilt_y").front() == doctest::Approx(-20 * M_PI / 180));
  for (const char* kind : {"distance", "pixel", "inclination"}) CHECK(settings["noise"][kind].is_number());
}

TEST_CASE("a camera sees two coordinates") {
  std::string text = "q1,q2,q3,x [mm],z [mm]\n";
  for (int i = 0; i < 8; ++i) {
    const std::vector<double> q = pose(i);
    const Eigen::Vector3d at = 1000 * nominal_place(q).translation();
    text += fmt::format("{:.6f},{:.6f},{:.6f},{:.4f},{:.4f}\n", q[0], q[1], q[2], at.x(), at.z());
  }
  const Draft draft = draft_experiment("arm", three_joints(), {{"poses.csv", text}});
  CHECK(draft.question == "");
  CHECK(std::isnan(column(draft, "tip_y").front()));
}

TEST_CASE("orientations by quaternion, and by roll, pitch and yaw") {
  for (const bool quaternion : {true, false}) {
    std::string text =
        quaternion ? "q1,q2,q3,tip_x,tip_y,tip_z,qx,qy,qz,qw\n" : "q1,q2,q3,x,y,z,roll,pitch,yaw\n";
    for (int i = 0; i < 8; ++i) {
      const std::vector<double> q = pose(i);
      const Pose<double> at = nominal_place(q);
      text += fmt::format("{:.8f},{:.8f},{:.8f},{:.8f},{:.8f},{:.8f}", q[0], q[1], q[2], at.translation().x(),
                          at.translation().y(), at.translation().z());
      const Eigen::Quaterniond turn(at.linear());
      // pan about z, then lift and elbow about y: yaw and pitch
      text += quaternion
                  ? fmt::format(",{:.8f},{:.8f},{:.8f},{:.8f}\n", turn.x(), turn.y(), turn.z(), turn.w())
                  : fmt::format(",0,{:.8f},{:.8f}\n", q[1] + q[2], q[0]);
    }
    CAPTURE(text);
    const Draft draft = draft_experiment("arm", three_joints(), {{"poses.csv", text}});
    CHECK(draft.question == "");
    const std::vector<double> w = column(draft, "tip_qw");
    for (int i = 0; i < 8; ++i)
      CHECK(std::abs(std::abs(w[static_cast<std::size_t>(i)]) -
                     std::abs(Eigen::Quaterniond(nominal_place(pose(i)).linear()).w())) < 1e-6);
  }
}

TEST_CASE("poses without angles of every joint are a question that names them") {
  CHECK_THROWS_WITH_AS(
      draft_experiment("arm", three_joints(), {{"poses.csv", "q1,x,y,z\n1,2,3,4\n2,3,4,5\n"}}),
      doctest::Contains("pan, lift, elbow"), Error);
}

}  // namespace plumbline::diagnose
