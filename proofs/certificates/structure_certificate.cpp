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

}  // namespace

json structure_certificate(const std::string& name, const Structure<Rational>& structure,
                           const StraightStructure& straight, std::size_t lowest, int digits) {
  json factors = json::array();
  for (const ForceEnclosure& factor : straight.enclose(lowest, digits))
    factors.push_back(to_json(factor, digits));
  json entry = described(name, structure);
  entry["modes"] = straight.modes();
  entry["factors"] = factors;
  return entry;
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
