#include "diagnose/motion/corrected_joint.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <plumbline/base/error.hpp>

#include "support/files/output_file.hpp"
#include "support/files/temporary_folder.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/motion/logs.hpp"

namespace plumbline::motion {
namespace {

constexpr const char* mjcf = R"(<mujoco model="servo">  <!-- mine -->
  <option timestep="0.001"/>
  <worldbody>
    <body name="arm">
      <joint name="hinge" axis="0 1 0"   armature="0.1" damping='0'/>
      <geom type="sphere" size="0.02" pos="0 0 -0.12" mass="0.5"/>
    </body>
  </worldbody>
  <actuator>
    <position name="servo" joint="hinge" kp="1"/>
  </actuator>
</mujoco>
)";

/// A bench of two gains, and a diagnosis that found a drive with a delay and with a loss of the gear.
struct Found {
  files::TemporaryFolder folder;
  Bench bench;
  Diagnosis diagnosis;

  Found() {
    for (const double gain : {4.0, 8.0}) bench.logs.push_back(test_log(planted_drive(Term::dry, 0), gain, 0));
    bench.name = "servo";
    diagnosis.name = "servo";
    diagnosis.drive = planted_drive(Term::command_delay, 0.0305);
    diagnosis.drive[Term::viscous] = 0.03, diagnosis.drive[Term::duty_missing] = 0.25;
    const Estimate loss{"c", "ratio", 0.2, 0.1, 0.3, false};
    diagnosis.causes = {{{{"command_delay", "a delay", {}}, {"load_friction", "a loss", {loss}}}, 1}};
  }
  void keep(const std::string& name, const std::string& text) {
    bench.model.file = folder.path() / name;
    files::write_text(bench.model.file, text);
  }
  [[nodiscard]] exchange::Written corrected(const char* name) const {
    return corrected_joint(bench, diagnosis, name);
  }
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("an MJCF gets the numbers of joint and servo, and all else stays byte by byte") {
  Found found;
  found.keep("servo.xml", mjcf);
  found.bench.model.gain = 0.16 * 4;
  const exchange::Written written = found.corrected("out.xml");
  INFO(written.text);
  CHECK(has(written.text, R"(<joint name="hinge" axis="0 1 0"   armature="0.006" damping='0.28')"));
  CHECK(has(written.text, R"(frictionloss="0.06")"));
  CHECK(has(written.text, R"(<geom type="sphere" size="0.02" pos="0 0 -0.12" mass="0.5"/>)"));
  CHECK(has(written.text, "<!-- mine -->"));
  // 0.3 N m/V at 12 V, times 0.64 duty per rad, and three quarters of the duty.
  CHECK(has(written.text, R"(kp="2.304")"));
  CHECK(has(written.text, R"(forcerange="-2.7 2.7")"));
  CHECK(has(written.text, R"(delay="0.0305")"));
  CHECK(has(written.text, R"(nsample="32")"));
  REQUIRE(written.effects.size() == 2);
  CHECK(written.effects[0].carried);
  CHECK(!written.effects[1].carried);
  CHECK(has(written.effects[1].how, "c = 0.2"));
}

TEST_CASE("a derivative part is kv of the servo, or the third number of its bias") {
  Found found;
  found.keep("servo.xml", mjcf);
  found.bench.model.gain = 0.16 * 4;
  found.diagnosis.drive[Term::derivative_gain] = 0.05;  // times 3.6 N m
  CHECK(has(found.corrected("out.xml").text, R"(kv="0.18")"));
  found.diagnosis.drive[Term::command_offset] = 0.02;  // which only <general> can hold
  CHECK(has(found.corrected("out.xml").text, "-2.304 -0.18"));
}

TEST_CASE("the gain of the model must be said where logs have several") {
  Found found;
  found.keep("servo.xml", mjcf);
  CHECK_THROWS_WITH_AS(
      found.corrected("out.xml"),
      "servo: model.gain: found logs with gains of 0.64 and 1.28 duty per rad, and none, expected the "
      "gain of the servo that the model has, duty per rad",
      Error);
}

TEST_CASE("a URDF gets friction, damping and effort") {
  Found found;
  found.keep(
      "servo.urdf",
      R"(<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="revolute"><parent link="a"/>)"
      R"(<child link="b"/><axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="10" velocity="5"/></joint></robot>)");
  const exchange::Written written = found.corrected("out.urdf");
  INFO(written.text);
  CHECK(has(written.text, R"(damping="0.28")"));
  CHECK(has(written.text, R"(friction="0.06")"));
  CHECK(has(written.text, R"(<limit lower="-1" upper="1" effort="2.7" velocity="5"/>)"));
  CHECK(!written.effects[0].carried);  // no delay in URDF
}

TEST_CASE("an SDF gets friction, damping and effort") {
  Found found;
  found.keep("servo.sdf", R"(<sdf version="1.7"><model name="r"><link name="a"/><link name="b"/>)"
                          R"(<joint name="j" type="revolute"><parent>a</parent><child>b</child>)"
                          R"(<axis><xyz>0 1 0</xyz></axis></joint></model></sdf>)");
  const exchange::Written written = found.corrected("out.sdf");
  INFO(written.text);
  CHECK(has(written.text, "<damping>0.28</damping>"));
  CHECK(has(written.text, "<friction>0.06</friction>"));
  CHECK(has(written.text, "<effort>2.7</effort>"));
}

TEST_CASE("BAM's parameters give back torque over voltage and back EMF: kt/R and kt^2/R") {
  Found found;
  const nlohmann::json json = nlohmann::json::parse(found.corrected("out.json").text);
  const double kt = json["kt"], resistance = json["R"];
  CHECK(kt / resistance == close_to(0.3));
  CHECK(kt * kt / resistance == close_to(0.25));
  CHECK(json["command_delay"] == 0.0305);
  CHECK(json["friction_base"] == close_to(0.06));
}

TEST_CASE("a model of another format, or none, is refused in one line") {
  Found found;
  CHECK_THROWS_WITH_AS(found.corrected("out.urdf"),
                       "servo: model.file: found none, expected the model that .urdf corrects", Error);
  found.keep("servo.xml", "<mujoco><worldbody/></mujoco>");
  found.bench.model.joint = "knee", found.bench.model.gain = 1;
  CHECK_THROWS_AS(found.corrected("out.xml"), Error);
}

}  // namespace plumbline::motion
