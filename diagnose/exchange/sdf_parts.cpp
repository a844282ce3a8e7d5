#include "diagnose/exchange/sdf_parts.hpp"

namespace plumbline::exchange {

Xml sdf_link(const Body& one, const Eigen::Vector3d& place, const std::string& relative_to) {
  Xml xml("link"), inertial("inertial"), inertia("inertia"), pose("pose");
  xml.set("name", one.name);
  if (!relative_to.empty()) pose.set("relative_to", relative_to);
  xml.add(std::move(pose.content(numbers({place.x(), place.y(), place.z(), 0, 0, 0}))));
  const std::string turning = number(one.turning);
  inertial.add("pose", numbers({one.middle[0], one.middle[1], 0, 0, 0, 0})).add("mass", number(one.mass));
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

namespace {

Xml axis_of(const Hinge& hinge, const Eigen::Vector3d& along) {
  Xml axis("axis"), dynamics("dynamics");
  axis.add("xyz", numbers_of(along));
  if (hinge.range) axis.add(sdf_limit(hinge, *hinge.range));
  dynamics.add("damping", number(hinge.damping)).add("friction", number(hinge.friction));
  dynamics.add("spring_reference", number(hinge.rest)).add("spring_stiffness", number(hinge.stiffness));
  return std::move(axis.add(std::move(dynamics)));
}

}  // namespace

Xml sdf_joint(const Body& one, const Eigen::Vector3d& axis) {
  Xml xml("joint");
  xml.set("name", one.joint ? one.joint->name : one.name + "_fixed");
  xml.set("type", !one.joint ? "fixed" : one.joint->along == 'z' ? "revolute" : "prismatic");
  xml.add("parent", one.parent.empty() ? "world" : one.parent).add("child", one.name);
  if (one.joint) xml.add(axis_of(*one.joint, axis));
  return xml;
}

Xml sdf_limit(const Hinge& hinge, Pair range) {
  Xml limit("limit");
  limit.add("lower", number(range[0])).add("upper", number(range[1]));
  if (hinge.range_stiffness > 0) limit.add("stiffness", number(hinge.range_stiffness));
  return limit;
}

}  // namespace plumbline::exchange
