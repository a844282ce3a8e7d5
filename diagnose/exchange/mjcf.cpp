#include "diagnose/exchange/mjcf.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diagnose/exchange/carried.hpp"
#include "diagnose/exchange/mjcf_parts.hpp"

namespace plumbline::exchange {
namespace {

Xml body(const Tree& tree, const Body& one) {
  Xml xml("body");
  xml.set("name", one.name).set("pos", numbers({one.place[0], one.place[1], 0}));
  if (one.joint) xml.add(mjcf_joint(*one.joint));
  xml.add(mjcf_inertial(one.mass, one.middle));
  if (one.length > 0)
    xml.add(Xml("geom")
                .set("type", "capsule")
                .set("size", number(0.05 * one.length))
                .set("fromto", "0 0 0 " + number(one.length) + " 0 0"));
  for (const Body& next : tree.bodies)
    if (next.parent == one.name) xml.add(body(tree, next));
  if (one.name == tree.tip) {
    xml.add(Xml("site").set("name", "end").set("pos", numbers({tree.end[0], tree.end[1], 0})));
    xml.add(Xml("site").set("name", "load").set("pos", numbers({tree.load[0], tree.load[1], 0})));
  }
  return xml;
}

/// Where forces on the end point act while all joints are straight.
Pair reference_end(const Tree& tree) {
  Pair at = tree.load;
  for (std::string name = tree.tip; !name.empty();) {
    const auto one = std::find_if(tree.bodies.begin(), tree.bodies.end(),
                                  [&](const Body& body) { return body.name == name; });
    at = {at[0] + one->place[0], at[1] + one->place[1]};
    name = one->parent;
  }
  return at;
}

Xml defaults() {
  const std::string reference = rigid_reference(), impedance = rigid_impedance();
  Xml all("default");
  all.add(Xml("geom").set("contype", "0").set("conaffinity", "0"));
  all.add(Xml("joint")
              .set("solreflimit", reference)
              .set("solimplimit", impedance)
              .set("solreffriction", reference)
              .set("solimpfriction", impedance));
  all.add(Xml("tendon").set("solreffriction", reference).set("solimpfriction", impedance));
  all.add(Xml("equality").set("solref", reference).set("solimp", impedance));
  return all;
}

}  // namespace

Written to_mjcf(const Model& model) {
  Written file;
  file.effects = what_is_carried(model, Format::mjcf);
  const Tree tree = carried_tree(model, file.effects, {.tendons = true});
  Xml root("mujoco");
  root.set("model", model.experiment.name);
  root.add(Xml("compiler").set("angle", "radian").set("inertiafromgeom", "false"));
  root.add(Xml("option")
               .set("timestep", number(mjcf_timestep))
               .set("integrator", "implicit")
               .set("solver", "Newton")
               .set("tolerance", "1e-12")
               .set("gravity", numbers({tree.gravity[0], tree.gravity[1], 0})));
  root.add(defaults());
  Xml world("worldbody");
  for (const Body& one : tree.bodies)
    if (one.parent.empty()) world.add(body(tree, one));
  if (tree.drive) {
    world.add(mjcf_rail(*tree.drive, reference_end(tree)));
    if (std::optional<Xml> clock = mjcf_clock(*tree.drive)) world.add(*std::move(clock));
  }
  root.add(std::move(world));
  for (Xml& section : mjcf_couplings(tree)) root.add(std::move(section));
  if (tree.drive)
    for (Xml& section : mjcf_drive(*tree.drive, tree.tip, {tree.load[0], tree.load[1], 0}))
      root.add(std::move(section));
  if (Xml custom = mjcf_beside(model, file.effects); !custom.empty()) root.add(std::move(custom));
  file.text = document(
      head_lines(model, file.effects,
                 {"In the plane of x and y; armature, damping and time step are numerical, not identified.",
                  "What is not carried stands in <custom> as numbers."}),
      root);
  return file;
}

}  // namespace plumbline::exchange
