#include "exchange/sdf.hpp"

#include "exchange/carried.hpp"
#include "exchange/xml.hpp"

namespace plumbline::exchange {
namespace {

Xml link(const Body& one) {
  Xml xml("link"), inertial("inertial"), inertia("inertia");
  xml.set("name", one.name);
  Xml pose("pose");
  if (!one.parent.empty()) pose.set("relative_to", one.parent);
  xml.add(std::move(pose.content(numbers({one.place[0], one.place[1], 0, 0, 0, 0}))));
  const std::string turning = number(one.joint ? one.joint->armature : 1e-6);
  inertial.add("pose", numbers({one.middle, 0, 0, 0, 0, 0})).add("mass", number(one.mass));
  inertia.add("ixx", turning).add("iyy", turning).add("izz", turning);
  xml.add(std::move(inertial.add(std::move(inertia))));
  if (one.length > 0) {
    Xml visual("visual"), geometry("geometry"), box("box");
    visual.set("name", one.name + "_bar").add("pose", numbers({one.length / 2, 0, 0, 0, 0, 0}));
    box.add("size", numbers({one.length, 0.1 * one.length, 0.1 * one.length}));
    xml.add(std::move(visual.add(std::move(geometry.add(std::move(box))))));
  }
  return xml;
}

Xml axis_of(const Hinge& hinge) {
  Xml axis("axis"), dynamics("dynamics");
  axis.add("xyz", hinge.along == 'x' ? "1 0 0" : hinge.along == 'y' ? "0 1 0" : "0 0 1");
  if (hinge.range) {
    Xml limit("limit");
    limit.add("lower", number((*hinge.range)[0])).add("upper", number((*hinge.range)[1]));
    if (hinge.range_stiffness > 0) limit.add("stiffness", number(hinge.range_stiffness));
    axis.add(std::move(limit));
  }
  dynamics.add("damping", number(hinge.damping)).add("friction", number(hinge.friction));
  dynamics.add("spring_reference", number(hinge.rest)).add("spring_stiffness", number(hinge.stiffness));
  return std::move(axis.add(std::move(dynamics)));
}

Xml joint(const Body& one) {
  Xml xml("joint");
  xml.set("name", one.joint ? one.joint->name : one.name + "_fixed");
  xml.set("type", !one.joint ? "fixed" : one.joint->along == 'z' ? "revolute" : "prismatic");
  xml.add("parent", one.parent.empty() ? "world" : one.parent).add("child", one.name);
  if (one.joint) xml.add(axis_of(*one.joint));
  return xml;
}

}  // namespace

Written to_sdf(const Model& model) {
  Written file;
  file.effects = what_is_carried(model, Format::sdf);
  const Tree tree = carried_tree(model, file.effects, {.soft_ranges = true});
  Xml root("sdf"), world("world"), chain("model");
  root.set("version", "1.7");
  world.set("name", "bench").add("gravity", numbers({tree.gravity[0], tree.gravity[1], 0}));
  chain.set("name", model.experiment.name);
  for (const Body& one : tree.bodies) chain.add(link(one));
  for (const Body& one : tree.bodies) chain.add(joint(one));
  Xml end("frame");
  end.set("name", "end").set("attached_to", tree.tip);
  chain.add(std::move(end.add("pose", numbers({tree.end[0], tree.end[1], 0, 0, 0, 0}))));
  root.add(std::move(world.add(std::move(chain))));
  file.text =
      document(head_lines(model, file.effects,
                          {"In the plane of x and y; inertias and damping are numerical, not identified."}),
               root);
  return file;
}

}  // namespace plumbline::exchange
