#include "proofs/certificate.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "proofs/decimal.hpp"
#include "proofs/exact_chain.hpp"
#include "proofs/sha256.hpp"
#include "proofs/shape_enclosure.hpp"
#include "proofs/tie.hpp"

namespace plumbline {
namespace {

using nlohmann::json;

json exact_list(const std::vector<Rational>& values) {
  json list = json::array();
  for (const Rational& x : values) list.push_back(to_exact(x));
  return list;
}

json to_json(const ForceEnclosure& force, int digits) {
  return {{"mode", force.index},          {"digits", digits},
          {"low", to_exact(force.low)},   {"high", to_exact(force.high)},
          {"below_low", force.below_low}, {"below_high", force.below_high}};
}

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

json matrices_to_json(const Chain<Rational>& chain) {
  Polynomial characteristic = characteristic_polynomial(chain);
  for (Rational& coefficient : characteristic) coefficient *= determinant_of_B(chain);
  const Multiplicity zero = multiplicity_of_zero_eigenvalue(chain);
  return {{"rank_A", rank_of_BinvA(chain)},
          {"rank_B", chain.size() + 1},
          {"zero_algebraic", zero.algebraic},
          {"zero_geometric", zero.geometric},
          {"characteristic", exact_list(characteristic)}};
}

/// The part of the chain that buckles at a force. Nothing when two parts do and no tie says that they share
/// it.
std::optional<ChainPart> buckling_part(const ExactCount& count, const ForceEnclosure& force,
                                       const std::vector<Tie>& ties) {
  if (std::any_of(ties.begin(), ties.end(), [&](const Tie& tie) { return tie.low == force.low; }))
    return count.parts()[force.index - force.below_low - 1];
  if (force.below_high != force.below_low + 1) return std::nullopt;
  return *std::find_if(count.parts().begin(), count.parts().end(), [&](const ChainPart& part) {
    return count.below(force.low, part) != count.below(force.high, part);
  });
}

/// The entries of forces between these bounds; nothing when their shapes need narrower ones.
std::optional<json> force_entries(const Chain<Rational>& chain, const std::vector<ForceEnclosure>& forces,
                                  const std::vector<Tie>& ties, const CertificateContents& contents) {
  const ExactCount count(chain);
  json entries = json::array();
  for (const ForceEnclosure& force : forces) {
    json entry = to_json(force, contents.digits);
    if (contents.shapes) {
      const auto part = buckling_part(count, force, ties);
      if (!part) return std::nullopt;
      const auto shape = enclose_shape(chain, *part, force.low, force.high, contents.digits);
      if (!shape) return std::nullopt;
      entry["shape"] = to_json(*shape);
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<Tie> ties_among(const Chain<Rational>& chain, const std::vector<ForceEnclosure>& forces) {
  std::vector<Tie> ties;
  for (const ForceEnclosure& force : forces) {
    if (!ties.empty() && ties.back().low == force.low) continue;
    if (auto tie = find_tie(chain, force)) ties.push_back(std::move(*tie));
  }
  return ties;
}

}  // namespace

json certificate(const std::string& name, const Chain<Rational>& chain, const CertificateContents& contents) {
  json result{
      {"chain", name}, {"lengths", exact_list(chain.length())}, {"stiffness", exact_list(chain.stiffness())}};
  for (int spare = contents.shapes ? 8 : 0;; spare += spare / 2 + 8) {
    const auto forces = enclose_critical_forces(chain, contents.lowest, contents.digits + spare);
    const std::vector<Tie> ties = ties_among(chain, forces);
    auto entries = force_entries(chain, forces, ties, contents);
    if (!entries) continue;
    result["forces"] = std::move(*entries);
    for (const Tie& tie : ties) result["ties"].push_back(to_json(tie));
    break;
  }
  if (contents.matrices) result["matrices"] = matrices_to_json(chain);
  return result;
}

json certificate_file(const Provenance& provenance, std::vector<json> certificates) {
  json file{{"format", "plumbline-certificates"},
            {"version", 1},
            {"licence", "CC0-1.0"},
            {"provenance",
             {{"command", provenance.command}, {"program", provenance.program}, {"seed", provenance.seed}}},
            {"certificates", std::move(certificates)},
            {"sha256", ""}};
  // The digest is that of the compact text with keys in order and an empty digest: no other choice of ours.
  file["sha256"] = sha256(file.dump(-1, ' ', true));
  return file;
}

}  // namespace plumbline
