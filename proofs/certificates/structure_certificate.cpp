#include "proofs/certificates/structure_certificate.hpp"

#include <nlohmann/json.hpp>

#include "proofs/certificates/certificate.hpp"
#include "proofs/exact/decimal.hpp"

namespace plumbline::proofs {
namespace {

using nlohmann::json;

template <class Straight>
json with_factors(const std::string& name, const json& chain, const Straight& straight, std::size_t lowest,
                  int digits) {
  json factors = json::array();
  for (const ForceEnclosure& factor : straight.enclose(lowest, digits))
    factors.push_back(to_json(factor, digits));
  return {{"structure", name}, {"chain", chain}, {"modes", straight.modes()}, {"factors", factors}};
}

}  // namespace

json structure_certificate(const std::string& name, const json& chain, const StraightStructure& straight,
                           std::size_t lowest, int digits) {
  return with_factors(name, chain, straight, lowest, digits);
}

json structure_certificate(const std::string& name, const json& chain, const StraightSpace& straight,
                           std::size_t lowest, int digits) {
  return with_factors(name, chain, straight, lowest, digits);
}

json structure_certificate(const std::string& name, const json& chain, const StabilityLoss& loss,
                           int digits) {
  json changes = json::array();
  for (const MotionChange& one : loss.changes) {
    changes.push_back({{"digits", digits},
                       {"low", to_exact(one.low)},
                       {"high", to_exact(one.high)},
                       {"at", name_of(one.at)},
                       {"above", name_of(one.above)}});
  }
  json entry{{"structure", name},
             {"chain", chain},
             {"loss",
              {{"kind", name_of(loss.kind)},
               {"digits", digits},
               {"low", to_exact(loss.low)},
               {"high", to_exact(loss.high)}}}};
  if (loss.first) entry["changes"] = changes;
  return entry;
}

}  // namespace plumbline::proofs
