#include "exchange/mjcf.hpp"

#include <fmt/format.h>

#include "exchange/carried.hpp"
#include "exchange/tree.hpp"
#include "exchange/xml.hpp"

namespace plumbline::exchange {
namespace {

/// Within a time step or two: what is constrained is as good as rigid.
constexpr double timestep = response_time / 5;

Xml joint(const Hinge& hinge) {
  Xml xml("joint");
  xml.set("name", hinge.name).set("type", hinge.along == 'z' ? "hinge" : "slide");
  xml.set("axis", hinge.along == 'x' ? "1 0 0" : hinge.along == 'y' ? "0 1 0" : "0 0 1");
  if (hinge.stiffness != 0) xml.set("stiffness", number(hinge.stiffness));
  if (hinge.rest != 0) xml.set("springref", number(hinge.rest));
  if (hinge.range) xml.set("limited", "true").set("range", numbers({(*hinge.range)[0], (*hinge.range)[1]}));
  if (hinge.friction > 0) xml.set("frictionloss", number(hinge.friction));
  if (hinge.damping > 0) xml.set("damping", number(hinge.damping));
  if (hinge.armature > 0) xml.set("armature", number(hinge.armature));
  return xml;
}

Xml body(const Tree& tree, const Body& one) {
  Xml xml("body");
  xml.set("name", one.name).set("pos", numbers({one.place[0], one.place[1], 0}));
  if (one.joint) xml.add(joint(*one.joint));
  xml.add(Xml("inertial")
              .set("pos", numbers({one.middle, 0, 0}))
              .set("mass", number(one.mass))
              .set("diaginertia", "1e-09 1e-09 1e-09"));
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

Xml tendon(const Tendon& one) {
  Xml xml("fixed");
  xml.set("name", one.name);
  if (one.stiffness > 0) xml.set("stiffness", number(one.stiffness));
  if (one.friction > 0) xml.set("frictionloss", number(one.friction));
  for (const auto& [name, share] : one.joints)
    xml.add(Xml("joint").set("joint", name).set("coef", number(share)));
  return xml;
}

void add_followers(const Tree& tree, Xml& root) {
  if (tree.followers.empty()) return;
  Xml equality("equality"), actuator("actuator");
  for (const Follower& one : tree.followers) {
    equality.add(Xml("joint")
                     .set("name", one.slide)
                     .set("joint1", one.slide)
                     .set("joint2", one.hinge)
                     .set("polycoef", numbers({one.polynomial.begin(), one.polynomial.end()})));
    actuator.add(Xml("general")
                     .set("name", one.slide)
                     .set("joint", one.slide)
                     .set("gainprm", "0")
                     .set("biastype", "affine")
                     .set("biasprm", numbers({one.force, 0, 0})));
  }
  root.add(std::move(equality)).add(std::move(actuator));
}

/// A list of numbers that scripts find by its name; MuJoCo's dynamics knows nothing of it.
void note(Xml& custom, const std::string& name, const std::vector<double>& values) {
  if (!values.empty()) custom.add(Xml("numeric").set("name", name).set("data", numbers(values)));
}

/// What MJCF cannot carry.
Xml beside(const Model& model, const std::vector<Carried>& effects) {
  Xml custom("custom");
  for (std::size_t e = 0; e < model.experiment.effects.size(); ++e)
    for (const auto& [name, value] : model.experiment.effects[e].parameters)
      if (!effects[e].carried) note(custom, effects[e].effect + " " + name, {value});
  for (const diagnose::LawPicture& law : model.laws) {
    for (const std::size_t joint : law.joints) {
      const std::string name = fmt::format("torque_law q{}", joint);
      std::vector<double> knots, sliders, arms;
      for (const auto& one : law.knots) knots.insert(knots.end(), {one.deflection, one.torque});
      for (const auto& one : law.sliders)
        sliders.insert(sliders.end(), {one.slips_at, one.torque, one.growth});
      for (const auto& one : law.arms) arms.insert(arms.end(), {one.time_constant, one.stiffness});
      note(custom, name, knots);
      note(custom, name + " sliders", sliders);
      note(custom, name + " arms", arms);
    }
  }
  return custom;
}

Xml defaults() {
  const std::string reference = number(2 * timestep) + " 1", impedance = "0.9999 0.9999 0.001";
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
  const Tree tree = tree_of(carried_rig(model, file.effects), model, {.tendons = true});
  Xml root("mujoco");
  root.set("model", model.experiment.name);
  root.add(Xml("compiler").set("angle", "radian").set("inertiafromgeom", "false"));
  root.add(Xml("option")
               .set("timestep", number(timestep))
               .set("integrator", "implicit")
               .set("solver", "Newton")
               .set("tolerance", "1e-12")
               .set("gravity", numbers({tree.gravity[0], tree.gravity[1], 0})));
  root.add(defaults());
  Xml world("worldbody");
  for (const Body& one : tree.bodies)
    if (one.parent.empty()) world.add(body(tree, one));
  root.add(std::move(world));
  if (!tree.tendons.empty()) {
    Xml all("tendon");
    for (const Tendon& one : tree.tendons) all.add(tendon(one));
    root.add(std::move(all));
  }
  add_followers(tree, root);
  if (Xml custom = beside(model, file.effects); !custom.empty()) root.add(std::move(custom));
  file.text = document(
      head_lines(model, file.effects,
                 {"In the plane of x and y; armature, damping and time step are numerical, not identified.",
                  "What is not carried stands in <custom> as numbers."}),
      root);
  return file;
}

}  // namespace plumbline::exchange
