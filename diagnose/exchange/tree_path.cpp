#include "diagnose/exchange/tree_path.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::exchange {

std::vector<const Body*> path_of(const Tree& tree) {
  std::vector<const Body*> path;
  for (std::string name = tree.tip; !name.empty(); name = path.back()->parent)
    path.push_back(&*std::find_if(tree.bodies.begin(), tree.bodies.end(),
                                  [&](const Body& body) { return body.name == name; }));
  std::reverse(path.begin(), path.end());
  return path;
}

const Body* carrier_of(const Tree& tree, const std::string& joint) {
  const auto found = std::find_if(tree.bodies.begin(), tree.bodies.end(),
                                  [&](const Body& body) { return body.joint && body.joint->name == joint; });
  return found == tree.bodies.end() ? nullptr : &*found;
}

std::string chain_name(std::size_t j) {
  return fmt::format("q{}", j + 1);
}

std::vector<LinkOf> links_of(const Tree& tree, std::size_t count) {
  std::vector<LinkOf> links(count);
  std::size_t next = 0;  // links that have begun
  for (const Body* body : path_of(tree)) {
    if (next > 0) links[next - 1].length += body->place[0];
    if (next < count && body->joint && body->joint->name == chain_name(next)) ++next;
    if (next == 0 || !(body->mass > 2 * speck)) continue;
    LinkOf& link = links[next - 1];
    const Eigen::Vector2d place(link.length + body->middle[0], body->middle[1]);
    link.centre = (link.mass * link.centre + body->mass * place) / (link.mass + body->mass);
    link.mass += body->mass;
  }
  links.back().length += tree.end[0];
  return links;
}

}  // namespace plumbline::exchange
