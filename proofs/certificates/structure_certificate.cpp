#include "proofs/certificates/structure_certificate.hpp"

#include <nlohmann/json.hpp>

#include "proofs/certificates/certificate.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exact_list.hpp"

namespace plumbline::proofs {
namespace {

using nlohmann::json;

std::string text(const Restraint<Rational>& restraint) {
  if (restraint.is_held()) return "held";
  return restraint.is_free() ? "free" : to_exact(restraint.stiffness);
}

json to_json(const Support<Rational>& support) {
  return {{"along", text(support.along)}, {"across", text(support.across)}, {"turn", text(support.turn)}};
}

json to_json(const Load<Rational>& load) {
  return {{"at", load.node},
          {"force", to_exact(load.force.x)},
          {"multiplied", load.multiplied ? 1 : 0},
          {"follows", load.kind == LoadKind::follower ? 1 : 0}};
}

json described(const std::string& name, const Structure<Rational>& structure) {
  json across = json::array(), loads = json::array();
  for (std::size_t node = 1; node < structure.chain.size(); ++node)
    across.push_back(text(structure.across_at(node)));
  for (const Load<Rational>& load : structure.loads) loads.push_back(to_json(load));
  return {{"structure", name},
          {"lengths", exact_list(structure.chain.length())},
          {"stiffness", exact_list(structure.chain.stiffness())},
          {"base", to_json(structure.base)},
          {"end_point", to_json(structure.end_point)},
          {"across", across},
          {"loads", loads}};
}

json to_json(const SpaceJoint<Rational>& joint) {
  json axes = json::array();
  for (const Axis<Rational>& axis : joint.axes) {
    const auto& a = axis.direction;
    axes.push_back({{"axis", exact_list({a[0], a[1], a[2]})}, {"stiffness", to_exact(axis.stiffness)}});
  }
  return axes;
}

/// The compression of all links.
json all_links(const std::vector<Rational>& compression, std::size_t links) {
  return exact_list(compression.empty() ? std::vector<Rational>(links, Rational(0)) : compression);
}

json described(const std::string& name, const SpaceChain<Rational>& chain, const SpaceLoad<Rational>& load) {
  json joints = json::array(), across = json::array();
  for (const SpaceJoint<Rational>& joint : chain.joint) joints.push_back(to_json(joint));
  for (std::size_t node = 1; node < chain.size(); ++node)
    across.push_back(load.across.empty() ? "free" : text(load.across[node - 1]));
  return {{"structure", name},
          {"lengths", exact_list(chain.length)},
          {"joints", joints},
          {"clamped", load.base_clamped ? 1 : 0},
          {"end_point", {{"across", text(load.end_point.across)}, {"turn", text(load.end_point.turn)}}},
          {"across", across},
          {"compression",
           {{"fixed", all_links(load.compression.fixed, chain.size())},
            {"multiplied", all_links(load.compression.multiplied, chain.size())}}}};
}

template <class Straight>
json with_factors(json entry, const Straight& straight, std::size_t lowest, int digits) {
  json factors = json::array();
  for (const ForceEnclosure& factor : straight.enclose(lowest, digits))
    factors.push_back(to_json(factor, digits));
  entry["modes"] = straight.modes();
  entry["factors"] = factors;
  return entry;
}

}  // namespace

json structure_certificate(const std::string& name, const Structure<Rational>& structure,
                           const StraightStructure& straight, std::size_t lowest, int digits) {
  return with_factors(described(name, structure), straight, lowest, digits);
}

json structure_certificate(const std::string& name, const SpaceChain<Rational>& chain,
                           const SpaceLoad<Rational>& load, const StraightSpace& straight, std::size_t lowest,
                           int digits) {
  return with_factors(described(name, chain, load), straight, lowest, digits);
}

json structure_certificate(const std::string& name, const Structure<Rational>& structure,
                           const StabilityLoss& loss, int digits) {
  json entry = described(name, structure);
  entry["masses"] = exact_list(masses_of(structure));
  entry["loss"] = {{"kind", loss.kind == Motion::divergence ? "divergence" : "flutter"},
                   {"digits", digits},
                   {"low", to_exact(loss.low)},
                   {"high", to_exact(loss.high)}};
  return entry;
}

}  // namespace plumbline::proofs
