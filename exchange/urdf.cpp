#include "exchange/urdf.hpp"

#include "exchange/carried.hpp"
#include "exchange/xml.hpp"

namespace plumbline::exchange {
namespace {

Xml link(const Body& one) {
  Xml xml("link"), inertial("inertial");
  xml.set("name", one.name);
  const std::string turning = number(one.joint ? one.joint->armature : 1e-6);
  inertial.add(Xml("origin").set("xyz", numbers({one.middle, 0, 0})));
  inertial.add(Xml("mass").set("value", number(one.mass)));
  inertial.add(Xml("inertia")
                   .set("ixx", turning)
                   .set("iyy", turning)
                   .set("izz", turning)
                   .set("ixy", "0")
                   .set("ixz", "0")
                   .set("iyz", "0"));
  xml.add(std::move(inertial));
  if (one.length > 0) {
    Xml visual("visual"), geometry("geometry");
    visual.add(Xml("origin").set("xyz", numbers({one.length / 2, 0, 0})));
    geometry.add(Xml("box").set("size", numbers({one.length, 0.1 * one.length, 0.1 * one.length})));
    xml.add(std::move(visual.add(std::move(geometry))));
  }
  return xml;
}

Xml joint(const Body& one) {
  Xml xml("joint");
  const bool moves = one.joint.has_value(), slides = moves && one.joint->along != 'z';
  const bool bounded = moves && (one.joint->range || slides);
  xml.set("name", moves ? one.joint->name : one.name + "_fixed");
  xml.set("type", !moves ? "fixed" : slides ? "prismatic" : bounded ? "revolute" : "continuous");
  xml.add(Xml("parent").set("link", one.parent)).add(Xml("child").set("link", one.name));
  xml.add(Xml("origin").set("xyz", numbers({one.place[0], one.place[1], 0})));
  if (!moves) return xml;
  const Hinge& hinge = *one.joint;
  xml.add(Xml("axis").set("xyz", hinge.along == 'x' ? "1 0 0" : hinge.along == 'y' ? "0 1 0" : "0 0 1"));
  if (bounded) {
    const Pair range = hinge.range.value_or(Pair{-1, 1});
    xml.add(Xml("limit")
                .set("lower", number(range[0]))
                .set("upper", number(range[1]))
                .set("effort", "1e9")
                .set("velocity", "1e9"));
  }
  xml.add(Xml("dynamics").set("damping", number(hinge.damping)).set("friction", number(hinge.friction)));
  return xml;
}

/// A link at the end point. sdformat merges what is fixed, unless it is told not to.
void add_end(const Tree& tree, Xml& root) {
  Body end{"end", tree.tip, tree.end, tree.bodies.front().mass, 0, 0, {}};
  Xml keep("gazebo");
  const std::string preserve = "preserveFixedJoint";
  keep.set("reference", "end_fixed").add(preserve, "true");
  root.add(link(end)).add(joint(end)).add(std::move(keep));
}

}  // namespace

Written to_urdf(const Model& model) {
  Written file;
  file.effects = what_is_carried(model, Format::urdf);
  const Tree tree = carried_tree(model, file.effects, {});
  Xml root("robot");
  root.set("name", model.experiment.name);
  // The root link of this format has no place: what hangs from it has its place too.
  const Body& base = tree.bodies.front();
  for (Body one : tree.bodies) {
    if (one.parent == base.name) one.place = {one.place[0] + base.place[0], one.place[1] + base.place[1]};
    root.add(link(one));
    if (!one.parent.empty()) root.add(joint(one));
  }
  add_end(tree, root);
  for (const Body& one : tree.bodies) {
    if (!one.joint || one.joint->stiffness == 0) continue;
    Xml spring("gazebo");
    spring.set("reference", one.joint->name);
    spring.add("springStiffness", number(one.joint->stiffness));
    spring.add("springReference", number(one.joint->rest));
    root.add(std::move(spring));
  }
  file.text = document(
      head_lines(model, file.effects,
                 {"In the plane of x and y; inertias and damping are numerical, not identified.",
                  "URDF has no springs: they are in <gazebo>. Nor has it gravity: " +
                      numbers({tree.gravity[0], tree.gravity[1], 0}) + " m/s^2.",
                  "The end point is at " + numbers({tree.end[0], tree.end[1], 0}) + " of " + tree.tip + "."}),
      root);
  return file;
}

}  // namespace plumbline::exchange
