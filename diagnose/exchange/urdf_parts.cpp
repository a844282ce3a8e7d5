#include "diagnose/exchange/urdf_parts.hpp"

namespace plumbline::exchange {

Xml urdf_inertial(double mass, Pair middle, double turning) {
  Xml inertial("inertial"), inertia("inertia");
  inertial.add(Xml("origin").set("xyz", numbers({middle[0], middle[1], 0})));
  inertial.add(Xml("mass").set("value", number(mass)));
  for (const char* own : {"ixx", "iyy", "izz"}) inertia.set(own, number(turning));
  for (const char* shared : {"ixy", "ixz", "iyz"}) inertia.set(shared, "0");
  return std::move(inertial.add(std::move(inertia)));
}

Xml urdf_link(const Body& one) {
  Xml xml("link");
  xml.set("name", one.name);
  xml.add(urdf_inertial(one.mass, one.middle, one.turning));
  if (one.length > 0) {
    Xml visual("visual"), geometry("geometry");
    visual.add(Xml("origin").set("xyz", numbers({one.length / 2, 0, 0})));
    geometry.add(Xml("box").set("size", numbers({one.length, 0.1 * one.length, 0.1 * one.length})));
    xml.add(std::move(visual.add(std::move(geometry))));
  }
  return xml;
}

Xml urdf_joint(const Body& one, const Eigen::Vector3d& place, const Eigen::Vector3d& axis) {
  Xml xml("joint");
  const bool moves = one.joint.has_value(), slides = moves && one.joint->along != 'z';
  const bool bounded = moves && (one.joint->range || slides);
  xml.set("name", moves ? one.joint->name : one.name + "_fixed");
  xml.set("type", !moves ? "fixed" : slides ? "prismatic" : bounded ? "revolute" : "continuous");
  xml.add(Xml("parent").set("link", one.parent)).add(Xml("child").set("link", one.name));
  xml.add(Xml("origin").set("xyz", numbers_of(place)));
  if (!moves) return xml;
  const Hinge& hinge = *one.joint;
  xml.add(Xml("axis").set("xyz", numbers_of(axis)));
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

Xml urdf_joint(const Body& one) {
  return urdf_joint(one, {one.place[0], one.place[1], 0}, direction_of(one));
}

Xml urdf_spring(const Hinge& hinge) {
  Xml spring("gazebo");
  spring.set("reference", hinge.name);
  spring.add("springStiffness", number(hinge.stiffness)).add("springReference", number(hinge.rest));
  return spring;
}

}  // namespace plumbline::exchange
