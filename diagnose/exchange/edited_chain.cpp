#include "diagnose/exchange/edited_chain.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/carried.hpp"
#include "diagnose/exchange/tree_path.hpp"
#include "diagnose/exchange/ways.hpp"

namespace plumbline::exchange {

using Eigen::Vector3d;

EditedChain::EditedChain(const Model& model, ReadModel read, Format format, const Means& means)
    : read_(std::move(read)), chain_(planar_chain(read_, model.source.string())) {
  if (!chain_.end)
    throw Error(model.source.string(), "nothing that names the end point",
                "a site, frame or link there with end or tip in its name");
  if (!read_.rows.empty())
    throw Error(model.source.string(), "corrections in it already", "the model without them");
  Model bare = model;
  bare.experiment.effects = chain_.chain.effects;
  bare.experiment.laws.clear();
  before_ = carried_tree(bare, what_is_carried(bare, format), means);
  effects_ = what_is_carried(model, format);
  const diagnose::Rig plain = rig_with(model, {});
  for (std::size_t e = bare.experiment.effects.size(); e < model.experiment.effects.size(); ++e)
    if (effects_[e].carried && rig_with(model, {model.experiment.effects[e]}).centre != plain.centre)
      effects_[e].carried = false, effects_[e].how = "links of this file keep their centres of mass";
  after_ = carried_tree(model, effects_, means);
  if (weighs_otherwise() && !(gravity() > 0)) {
    for (Carried& one : effects_)
      if (one.carried && adds_weight(one.effect))
        one.carried = false, one.how = "the masses of the model itself would weigh with it";
    after_ = carried_tree(model, effects_, means);
  }
  measure_links();
}

const Hinge& EditedChain::before(std::size_t j) const {
  return *carrier_of(before_, chain_name(j))->joint;
}

const Hinge& EditedChain::after(std::size_t j) const {
  return *carrier_of(after_, chain_name(j))->joint;
}

double EditedChain::ease_moves(std::size_t j) const {
  return sense(j) * (after(j).rest - before(j).rest);
}

void EditedChain::measure_links() {
  const std::vector<LinkOf> old = links_of(before_, size()), now = links_of(after_, size());
  Vector3d moved = Vector3d::Zero();
  for (std::size_t j = 0; j < size(); ++j) {
    const Vector3d far = j + 1 < size() ? joint(j + 1).anchor : end().place, way = far - joint(j).anchor;
    const Vector3d in_plane = way - way.dot(plane().normal()) * plane().normal();
    along_.push_back(in_plane.normalized());
    moves_.push_back(moved);
    moved += (now[j].length - old[j].length) * along_.back();
    length_.push_back(now[j].length);
  }
  moves_.push_back(moved);
}

Vector3d EditedChain::base_moves() const {
  const Pair now = path_of(after_).front()->place, old = path_of(before_).front()->place;
  return (now[0] - old[0]) * plane().x + (now[1] - old[1]) * plane().y;
}

std::vector<EditedChain::Added> EditedChain::in_series() const {
  std::vector<Added> all;
  std::size_t next = 0;  // links that have begun
  double travelled = 0;  // on the one that was last
  for (const Body* one : path_of(after_)) {
    if (next > 0) travelled += one->place[0];
    if (!one->joint) continue;
    if (next < size() && one->joint->name == chain_name(next)) {
      ++next;
      travelled = 0;
      continue;
    }
    const bool at_base = next == 0;
    const Vector3d x = at_base ? plane().x : along_[next - 1], y = at_base ? plane().y : across(next - 1);
    const Vector3d axis = one->joint->along == 'x' ? x : one->joint->along == 'y' ? y : plane().normal();
    const Vector3d place =
        at_base ? joint(0).anchor : Vector3d(joint(next - 1).anchor + moves_[next - 1] + travelled * x);
    all.push_back({one, next, axis, place});
  }
  return all;
}

std::vector<std::pair<const Body*, std::size_t>> EditedChain::beside() const {
  const std::vector<const Body*> path = path_of(after_);
  std::vector<std::pair<const Body*, std::size_t>> all;
  for (const Body& one : after_.bodies) {
    if (!one.joint || std::find(path.begin(), path.end(), &one) != path.end()) continue;
    std::size_t j = size();
    while (j-- > 0)
      if (one.joint->name.starts_with(chain_name(j) + "_")) break;
    all.emplace_back(&one, j);
  }
  return all;
}

std::string EditedChain::own_name(const std::string& name) const {
  for (std::size_t j = size(); j-- > 0;) {
    const std::string chain = chain_name(j);
    if (name == chain) return joint(j).name;
    if (name.starts_with(chain + "_")) return joint(j).name + name.substr(chain.size());
  }
  return name;
}

double EditedChain::own_mass(std::size_t j) const {
  constexpr double no_mass = 1e-4;  // as the reader has it
  return joint(j).mass > no_mass ? joint(j).mass : 0;
}

const Body* EditedChain::payload() const {
  const auto found = std::find_if(after_.bodies.begin(), after_.bodies.end(),
                                  [](const Body& one) { return one.name == "payload"; });
  return found == after_.bodies.end() ? nullptr : &*found;
}

bool EditedChain::weighs_otherwise() const {
  if (after_.gravity != before_.gravity || payload() != nullptr) return true;
  const std::vector<LinkOf> old = links_of(before_, size()), now = links_of(after_, size());
  return !std::equal(old.begin(), old.end(), now.begin(),
                     [](const LinkOf& a, const LinkOf& b) { return a.mass == b.mass; });
}

/// As strong as it is, or as weak as the model's own masses, which go on weighing, let it be.
double EditedChain::gravity() const {
  const double wanted = std::hypot(after_.gravity[0], after_.gravity[1]);
  const std::vector<LinkOf> now = links_of(after_, size());
  double allowed = wanted;
  for (std::size_t j = 0; j < size(); ++j)
    if (own_mass(j) > 0) allowed = std::min(allowed, now[j].mass * wanted / own_mass(j));
  return allowed;
}

std::optional<EditedChain::Weights> EditedChain::weights() const {
  if (!weighs_otherwise()) return {};
  const double strength = std::hypot(after_.gravity[0], after_.gravity[1]), own = gravity();
  const Vector3d down = (after_.gravity[0] * plane().x + after_.gravity[1] * plane().y) / strength,
                 normal = plane().normal();
  Weights all{read_.gravity.dot(normal) * normal + own * down, {}};
  const std::vector<LinkOf> old = links_of(before_, size()), now = links_of(after_, size());
  for (std::size_t j = 0; j < size(); ++j) {
    const double all_of_it = now[j].mass * strength / own, mass = all_of_it - own_mass(j);
    if (!(mass > 1e-9 * (1 + own_mass(j)))) continue;
    const Eigen::Vector2d at = (all_of_it * now[j].centre - own_mass(j) * old[j].centre) / mass;
    all.added.push_back(
        {joint(j).name + "_weight", j, mass, joint(j).anchor + at.x() * along_[j] + at.y() * across(j)});
  }
  if (payload() != nullptr)
    all.added.push_back({"payload", size(), payload()->mass * strength / own,
                         end().place + moves_[size()] - moves_[size() - 1]});
  return all;
}

}  // namespace plumbline::exchange
