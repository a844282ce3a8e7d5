#include "proofs/certificates/certificate.hpp"

#include <nlohmann/json.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exact_chain.hpp"
#include "proofs/exact/exact_list.hpp"
#include "support/files/sha256.hpp"

namespace plumbline::proofs {
namespace {

using nlohmann::json;

json to_json(const ShapeEnclosure& shape) {
  return {{"first", shape.part.first + 1},
          {"last", shape.part.last + 1},
          {"digits", shape.digits},
          {"q", shape.q}};
}

json to_json(const Tie& tie) {
  json cofactors = json::array();
  for (const Polynomial& cofactor : tie.cofactors) cofactors.push_back(exact_list(cofactor));
  return {{"mode", tie.index},
          {"low", to_exact(tie.low)},
          {"high", to_exact(tie.high)},
          {"factor", exact_list(tie.factor)},
          {"cofactors", cofactors}};
}

}  // namespace

json to_json(const ForceEnclosure& force, int digits) {
  return {{"mode", force.index},          {"digits", digits},
          {"low", to_exact(force.low)},   {"high", to_exact(force.high)},
          {"below_low", force.below_low}, {"below_high", force.below_high}};
}

json certificate(const std::string& name, const Chain<Rational>& chain, const CertifiedModes& modes) {
  json result{{"chain", name},
              {"lengths", exact_list(chain.length())},
              {"stiffness", exact_list(chain.stiffness())},
              {"forces", json::array()}};
  for (std::size_t i = 0; i < modes.forces.size(); ++i) {
    json entry = to_json(modes.forces[i], modes.digits);
    if (i < modes.shapes.size()) entry["shape"] = to_json(modes.shapes[i]);
    result["forces"].push_back(std::move(entry));
  }
  for (const Tie& tie : modes.ties) result["ties"].push_back(to_json(tie));
  return result;
}

json matrix_certificate(const Chain<Rational>& chain) {
  Polynomial characteristic = characteristic_polynomial(chain);
  for (Rational& coefficient : characteristic) coefficient *= determinant_of_B(chain);
  const Multiplicity zero = multiplicity_of_zero_eigenvalue(chain);
  return {{"rank_A", rank_of_BinvA(chain)},
          {"rank_B", chain.size() + 1},
          {"zero_algebraic", zero.algebraic},
          {"zero_geometric", zero.geometric},
          {"characteristic", exact_list(characteristic)}};
}

json to_json(const Provenance& provenance) {
  return {{"command", provenance.command}, {"program", provenance.program}, {"seed", provenance.seed}};
}

json certificate_file(const char* format, const Provenance& provenance, std::vector<json> certificates) {
  json file{{"format", format},
            {"version", 1},
            {"licence", "CC0-1.0"},
            {"provenance", to_json(provenance)},
            {"certificates", std::move(certificates)},
            {"sha256", ""}};
  // The digest is that of the compact text with keys in order and an empty digest: no other choice of ours.
  file["sha256"] = files::sha256(file.dump(-1, ' ', true));
  return file;
}

}  // namespace plumbline::proofs
