#include <doctest/doctest.h>
#include <fmt/format.h>

#include <plumbline/base/error.hpp>

#include "diagnose/exchange/read_model.hpp"
#include "diagnose/exchange/xml_document.hpp"
#include "tests/folder.hpp"

// Files that were made to do harm, or were broken: each is answered in one line that names it.
namespace plumbline::exchange {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

std::string answer_to(const Folder& folder, const std::string& name) {
  try {
    static_cast<void>(read_model(folder / name));
  } catch (const Error& error) {
    return error.what();
  }
  return "read without a word";
}

std::string answer_to(const std::string& name, const std::string& text) {
  const Folder folder;
  folder.write(name, text);
  return answer_to(folder, name);
}

void check_refused(const std::string& name, const std::string& text, const std::string& words) {
  const std::string said = answer_to(name, text);
  CAPTURE(text.substr(0, 300));
  CAPTURE(said);
  CHECK(said.find(words) != std::string::npos);
  CHECK(said.find(name) != std::string::npos);
  CHECK(said.find('\n') == std::string::npos);
  CHECK(said.size() < 2000);
}

std::string mjcf(const std::string& body) {
  return "<mujoco><worldbody><body>" + body + "</body></worldbody></mujoco>";
}
std::string urdf(const std::string& joint) {
  return R"(<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="continuous"><parent link="a"/><child link="b"/>)" +
         joint + "</joint></robot>";
}
std::string sdf(const std::string& rest) {
  return R"(<sdf version="1.9"><model name="m"><link name="a"/><link name="b"/>)" + rest + "</model></sdf>";
}

}  // namespace

TEST_CASE("entities are not read: neither files nor text without end") {
  const std::string bomb =
      R"(<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;">]>)";
  const std::string file = R"(<!DOCTYPE x [<!ENTITY f SYSTEM "file:///etc/hostname">]>)";
  for (const std::string& head : {bomb, file}) {
    check_refused("m.xml", head + mjcf("<joint name=\"&b;\"/>"), "declares entities");
    check_refused("m.urdf", head + urdf(""), "declares entities");
    check_refused("m.sdf", head + sdf(""), "declares entities");
  }
}

TEST_CASE("elements may be deep, but not without end") {
  const auto nested = [](int times) {
    return "<mujoco><worldbody>" + repeated("<body pos=\"0.1 0 0\"><joint/><geom size=\"0.1\"/>", times) +
           "<site name=\"end\" pos=\"0.1 0 0\"/>" + repeated("</body>", times) + "</worldbody></mujoco>";
  };
  const Folder folder;
  folder.write("deep.xml", nested(deepest_element - 10));
  CHECK(read_model(folder / "deep.xml").chain.link_length.size() == deepest_element - 10);
  check_refused("m.xml", nested(100000), "deep");
  check_refused("m.urdf", "<robot>" + repeated("<a>", 100000) + repeated("</a>", 100000) + "</robot>",
                "deep");
  check_refused("m.sdf", "<sdf>" + repeated("<a>", 100000) + repeated("</a>", 100000) + "</sdf>", "deep");
}

TEST_CASE("a file that includes itself, another twice, or one that is not there") {
  const Folder folder;
  folder.write("self.xml", R"(<mujoco><include file="self.xml"/></mujoco>)");
  folder.write("a.xml", R"(<mujoco><include file="b.xml"/></mujoco>)");
  folder.write("b.xml", R"(<mujocoinclude><include file="./a.xml"/></mujocoinclude>)");
  folder.write("twice.xml", R"(<mujoco><include file="part.xml"/><include file="part.xml"/></mujoco>)");
  folder.write("part.xml", "<mujocoinclude/>");
  for (const char* name : {"self.xml", "a.xml", "twice.xml"})
    CHECK(answer_to(folder, name).find("included twice") != std::string::npos);
  check_refused("m.xml", R"(<mujoco><include/></mujoco>)", "no file");
  folder.write("none.xml", R"(<mujoco><include file="gone.xml"/></mujoco>)");
  CHECK(answer_to(folder, "none.xml").find("gone.xml: found No such file") != std::string::npos);
  folder.write("device.xml", R"(<mujoco><include file="/dev/zero"/></mujoco>)");
  CHECK(answer_to(folder, "device.xml").find("not in the model's folder") != std::string::npos);
}

TEST_CASE("a model reads nothing that lies outside of its folder, by whatever way") {
  const Folder folder;
  folder.write("outside.xml", "<mujocoinclude/>");
  std::filesystem::create_directories(folder / "model/parts");
  std::filesystem::create_symlink(folder / "outside.xml", folder / "model/link.xml");
  folder.write("model/parts/part.xml", "<mujocoinclude/>");
  for (const std::string name : {"../outside.xml", "parts/../../outside.xml", "link.xml", "/etc/passwd"}) {
    folder.write("model/m.xml", "<mujoco><include file=\"" + name + "\"/></mujoco>");
    CHECK(answer_to(folder, "model/m.xml").find("not in the model's folder") != std::string::npos);
  }
  for (const std::string name : {"parts/part.xml", "parts/../parts/part.xml"}) {
    folder.write("model/m.xml", "<mujoco><include file=\"" + name + "\"/></mujoco>");
    CHECK(answer_to(folder, "model/m.xml").find("not in the model's folder") == std::string::npos);
  }
}

TEST_CASE("numbers that are none, too few, too many, or nothing that can be turned about") {
  for (const char* pos :
       {"nan 0 0", "inf 0 0", "1e999 0 0", "1 2", "1 2 3 4", "", "a b c", "0x10 0 0", "1,5 0 0"}) {
    check_refused("m.xml", mjcf(fmt::format("<joint/><body pos=\"{}\"><joint/></body>", pos)), "pos");
    check_refused("m.urdf", urdf(fmt::format("<origin xyz=\"{}\"/>", pos)), "xyz");
  }
  check_refused("m.xml", mjcf("<joint axis=\"0 0 0\"/>"), "axis of no length");
  check_refused("m.urdf", urdf("<axis xyz=\"0 0 0\"/>"), "axis of no length");
  check_refused("m.xml", mjcf("<joint/><body quat=\"0 0 0 0\"/>"), "quaternion of no length");
  check_refused("m.xml", mjcf("<joint/><body xyaxes=\"1 0 0 1 0 0\"/>"), "one direction");
  check_refused("m.xml",
                "<mujoco><compiler eulerseq=\"xyzxyz\"/>" + mjcf("<body euler=\"1 2 3\"/>").substr(8),
                "eulerseq");
  check_refused("m.sdf",
                sdf("<link name=\"c\"><pose>1 2 3</pose></link>"
                    R"(<joint name="j" type="revolute"><parent>a</parent><child>c</child><axis/></joint>)"),
                "pose");
}

TEST_CASE("names that are not there, twice there, or go round in a circle") {
  check_refused("m.xml", mjcf("<joint class=\"none\"/>"), "class none");
  check_refused("m.xml", R"(<mujoco><default><default class="a"/><default class="a"/></default></mujoco>)",
                "twice");
  check_refused("m.xml", mjcf("<joint name=\"a\"/><body pos=\"1 0 0\"><joint name=\"a\"/></body>"),
                "two joints a");
  check_refused("m.xml",
                "<mujoco><worldbody><body><joint/></body></worldbody><actuator><motor "
                "joint=\"x\"/></actuator></mujoco>",
                "the joint x");
  check_refused("m.urdf", R"(<robot><link name="a"/><link name="a"/></robot>)", "two links a");
  check_refused("m.urdf", R"(<robot><joint name="j"><parent link="x"/><child link="y"/></joint></robot>)",
                "\"x\"");
  check_refused(
      "m.urdf",
      R"(<robot><link name="r"/><link name="a"/><link name="b"/><joint name="j"><parent link="a"/><child link="b"/></joint>
<joint name="k"><parent link="b"/><child link="a"/></joint></robot>)",
      "hang by each other");
  check_refused("m.urdf", "<robot/>", "0 links");
  check_refused("m.urdf", R"(<robot xmlns:xacro="x"><xacro:arm/></robot>)", "xacro FILE > arm.urdf");
  check_refused("m.sdf", sdf(R"(<frame name="f" attached_to="g"/><frame name="g" attached_to="f"/>
<joint name="j" type="revolute"><parent>a</parent><child>f</child><axis/></joint>)"),
                "circle");
  check_refused(
      "m.sdf",
      sdf(R"(<frame name="f"><pose relative_to="g"/></frame><frame name="g"><pose relative_to="f"/></frame>
<joint name="j" type="revolute"><parent>a</parent><child>b</child><pose relative_to="f"/><axis/></joint>)"),
      "circle");
  check_refused("m.sdf",
                sdf(R"(<joint name="j" type="revolute"><parent>a</parent><child>b</child><axis/></joint>
<joint name="k" type="revolute"><parent>b</parent><child>a</child><axis/></joint>)"),
                "no joint at the base");
  check_refused("m.sdf", sdf(R"(<joint name="j" type="fixed"><parent>a</parent><child>b</child></joint>
<joint name="k" type="fixed"><parent>b</parent><child>a</child></joint>)"),
                "hang by each other");
  check_refused("m.sdf", R"(<sdf version="1.9"><model name="a"/><model name="b"/></sdf>)", "2 models");
  check_refused("m.sdf", sdf("<include><uri>model://arm</uri></include>"), "<include>");
}

TEST_CASE("what stands for several bodies is refused, and so is another format under the name") {
  for (const char* macro :
       {"<composite type=\"cable\"/>", "<attach model=\"x\"/>", "<flexcomp/>", "<replicate count=\"9\"/>"})
    check_refused("m.xml", mjcf(std::string("<joint/>") + macro), "which stands for several");
  check_refused("m.xml", urdf(""), "a URDF");
  check_refused("m.urdf", mjcf("<joint/>"), "root <mujoco>");
  check_refused("m.sdf", mjcf("<joint/>"), "root <mujoco>");
}

TEST_CASE("control characters and marks that turn the writing stay out of messages") {
  const std::string said = answer_to("m.xml", mjcf("<joint class=\"a\x01\xe2\x80\xae&#10;b\"/>"));
  for (const char* raw : {"\x01", "\xe2\x80\xae", "\n"}) CHECK(said.find(raw) == std::string::npos);
}

}  // namespace plumbline::exchange
