#include "diagnose/exchange/urdf.hpp"

#include "diagnose/exchange/carried.hpp"
#include "diagnose/exchange/model_gravity.hpp"
#include "diagnose/exchange/urdf_parts.hpp"

namespace plumbline::exchange {
namespace {

/// A link at the end point. sdformat merges what is fixed, unless it is told not to.
void add_end(const Tree& tree, Xml& root) {
  Body end{"end", tree.tip, tree.end, tree.bodies.front().mass, {}, 0, {}};
  Xml keep("gazebo");
  const std::string preserve = "preserveFixedJoint";
  keep.set("reference", "end_fixed").add(preserve, "true");
  root.add(urdf_link(end)).add(urdf_joint(end)).add(std::move(keep));
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
    root.add(urdf_link(one));
    if (!one.parent.empty()) root.add(urdf_joint(one));
  }
  add_end(tree, root);
  for (const Body& one : tree.bodies) {
    if (!one.joint || one.joint->stiffness == 0) continue;
    root.add(urdf_spring(*one.joint));
  }
  const Eigen::Vector3d gravity(tree.gravity[0], tree.gravity[1], 0);
  const std::string text = document(
      head_lines(model, file.effects,
                 {"In the plane of x and y; inertias and damping are numerical, not identified.",
                  "URDF has no springs: they are in <gazebo>. Nor has it gravity: " + numbers_of(gravity) +
                      " m/s^2.",
                  "The end point is at " + numbers({tree.end[0], tree.end[1], 0}) + " of " + tree.tip + "."}),
      root);
  file.text = with_gravity(text, gravity);
  return file;
}

}  // namespace plumbline::exchange
