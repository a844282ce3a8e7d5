#include "diagnose/motion/balance/torque_log.hpp"

#include <doctest/doctest.h>

#include <fstream>

#include "tests/close_to.hpp"
#include "tests/folder.hpp"

// A body's moments about its centre, turned by a quarter and moved: the same in each format.
namespace plumbline::motion {
namespace {

constexpr const char* turned_urdf =
    "<robot name=\"r\"><link name=\"base\"/><link name=\"arm\"><inertial><origin xyz=\"0 0 -0.2\" rpy=\"0 0 "
    "1.5707963267948966\"/><mass value=\"0.5\"/><inertia ixx=\"0.001\" iyy=\"0.002\" izz=\"0.0025\" "
    "ixy=\"0\" "
    "ixz=\"0\" iyz=\"0\"/></inertial></link><joint name=\"j\" type=\"continuous\"><parent "
    "link=\"base\"/><child "
    "link=\"arm\"/><axis xyz=\"0 1 0\"/></joint></robot>";
constexpr const char* turned_mjcf =
    "<mujoco><worldbody><body name=\"arm\"><joint name=\"j\" axis=\"0 1 0\"/><inertial pos=\"0 0 -0.2\" "
    "quat=\"0.7071067811865476 0 0 0.7071067811865476\" mass=\"0.5\" diaginertia=\"0.001 0.002 0.0025\"/>"
    "</body></worldbody></mujoco>";
constexpr const char* turned_sdf =
    "<sdf version=\"1.9\"><model name=\"r\"><link name=\"base\"/><joint name=\"fix\" "
    "type=\"fixed\"><parent>world"
    "</parent><child>base</child></joint><link name=\"arm\"><inertial><pose>0 0 -0.2 0 0 "
    "1.5707963267948966</pose><mass>0.5</mass><inertia><ixx>0.001</ixx><iyy>0.002</iyy><izz>0.0025</izz>"
    "</inertia></inertial></link><joint name=\"j\" type=\"revolute\"><parent>base</parent><child>arm</child>"
    "<axis><xyz>0 1 0</xyz></axis></joint></model></sdf>";

TorqueBench bench_with(const std::string& file, const std::string& model) {
  const Folder folder;
  folder.write(file, model);
  folder.write("experiment.toml",
               "format = \"torque/1\"\nname = \"arm\"\n[model]\nfile = \"" + file +
                   "\"\n[logs]\nfiles = [\"log.csv\"]\n[columns]\nposition = [\"q\"]\ntorque = [\"tau\"]\n");
  std::string log = "t,q,tau\n";
  for (int k = 0; k < 100; ++k) log += std::to_string(0.01 * k) + ",0,0\n";
  folder.write("log.csv", log);
  return read_torque_bench(folder.path());
}

}  // namespace

TEST_CASE("a model's tensors of inertia are read, about the origin of the link's frame") {
  for (const auto& [file, model] :
       {std::pair{"arm.urdf", turned_urdf}, {"arm.xml", turned_mjcf}, {"arm.sdf", turned_sdf}}) {
    CAPTURE(file);
    const TorqueBench bench = bench_with(file, model);
    REQUIRE(bench.inertia.size() == 1);
    // x and y change places, and Huygens and Steiner add m r^2 across z.
    const Eigen::Matrix3d expected = Eigen::Vector3d(0.002 + 0.02, 0.001 + 0.02, 0.0025).asDiagonal();
    CHECK((bench.inertia[0] - expected).norm() < 1e-15);  // a turn by pi/2 in doubles
  }
}

}  // namespace plumbline::motion
