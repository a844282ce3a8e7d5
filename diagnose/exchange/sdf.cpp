#include "diagnose/exchange/sdf.hpp"

#include "diagnose/exchange/carried.hpp"
#include "diagnose/exchange/sdf_parts.hpp"

namespace plumbline::exchange {

Written to_sdf(const Model& model) {
  Written file;
  file.effects = what_is_carried(model, Format::sdf);
  const Tree tree = carried_tree(model, file.effects, {.soft_ranges = true});
  Xml root("sdf"), world("world"), chain("model");
  root.set("version", "1.7");
  world.set("name", "bench").add("gravity", numbers({tree.gravity[0], tree.gravity[1], 0}));
  chain.set("name", model.experiment.name);
  for (const Body& one : tree.bodies) chain.add(sdf_link(one, {one.place[0], one.place[1], 0}, one.parent));
  for (const Body& one : tree.bodies) chain.add(sdf_joint(one, direction_of(one)));
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
