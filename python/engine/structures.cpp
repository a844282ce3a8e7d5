#include <nlohmann/json.hpp>

#include "proofs/certificates/certificate.hpp"
#include "proofs/certificates/structure_certificate.hpp"
#include "proofs/exact/critical_torque.hpp"
#include "proofs/exact/straight_space.hpp"
#include "proofs/paths/structure_path.hpp"
#include "python/engine/engine.hpp"
#include "statement/chain_file.hpp"
#include "statement/stated.hpp"

namespace plumbline::python {
namespace {

constexpr const char* source = "chain";

/// A straight one; in space, one under forces or a torque.
statement::StatedChain straight_chain(const std::string& text) {
  statement::StatedChain chain = statement::parse_chain(text, source);
  if (const auto* plane = std::get_if<statement::PlaneChain>(&chain)) {
    for (const Rational& angle : plane->structure.chain.rest()) {
      if (angle != 0)
        throw Error("rest", "an angle that is not zero", "zero: only the straight chain has factors");
    }
  }
  return chain;
}

Structure<Rational> straight_structure(const std::string& text) {
  const auto chain = straight_chain(text);
  if (const auto* plane = std::get_if<statement::PlaneChain>(&chain)) return plane->structure;
  throw Error(source, "a chain in space", "one in the plane");
}

Decimals factors_of(const SpaceStructure<Rational>& structure, std::size_t lowest, int digits) {
  if (structure.torque) {
    const auto found = proofs::critical_torque(structure, digits);
    proofs::require_regular_line(structure);
    return {found.value.decimal};
  }
  Decimals all;
  for (const proofs::SpaceMode& mode : proofs::StraightSpace(structure).in_decimals(lowest, digits))
    all.push_back(mode.force);
  proofs::require_regular_line(structure);
  return all;
}

Decimals factors_of(const statement::PlaneChain& chain, std::size_t lowest, int digits) {
  Decimals all;
  for (const proofs::CriticalMode& mode :
       proofs::StraightStructure(chain.structure).in_decimals(lowest, digits, false))
    all.push_back(mode.force);
  return all;
}

Decimals critical_factors(const std::string& text, std::size_t lowest, int digits) {
  return unlocked([&] {
    return std::visit([&](const auto& chain) { return factors_of(chain, lowest, digits); },
                      straight_chain(text));
  });
}

py::dict stability_loss(const std::string& text, int digits) {
  const proofs::StabilityLoss loss =
      unlocked([&] { return proofs::stability_loss(straight_motion(straight_structure(text)), digits); });
  py::dict all;
  all["kind"] = name_of(loss.kind);
  all["factor"] = loss.factor, all["first"] = loss.first;
  return all;
}

nlohmann::json certificate_of(const std::string& name, const nlohmann::json& stated,
                              const SpaceStructure<Rational>& structure, std::size_t lowest, int digits) {
  if (structure.torque) throw Error("loads", "a torque", "forces: no certificate is made of a torque");
  const proofs::StraightSpace straight(structure);
  proofs::require_regular_line(structure);
  return proofs::structure_certificate(name, stated, straight, lowest, digits);
}

nlohmann::json certificate_of(const std::string& name, const nlohmann::json& stated,
                              const statement::PlaneChain& chain, std::size_t lowest, int digits) {
  const Structure<Rational>& structure = chain.structure;
  if (structure.follower())
    return proofs::structure_certificate(name, stated,
                                         proofs::stability_loss(straight_motion(structure), digits), digits);
  return proofs::structure_certificate(name, stated, proofs::StraightStructure(structure), lowest, digits);
}

std::string certificate_of_structure(const std::string& name, const std::string& text, std::size_t lowest,
                                     int digits, const std::string& command) {
  return unlocked([&] {
    const nlohmann::json entry = std::visit(
        [&](const auto& chain) {
          return certificate_of(name, statement::stated(text, source), chain, lowest, digits);
        },
        straight_chain(text));
    return certificate_text(proofs::structure_certificates, command, entry);
  });
}

}  // namespace

void add_structures(py::module_& module) {
  module.def("critical_factors", &critical_factors);
  module.def("stability_loss", &stability_loss);
  module.def("structure_certificate", &certificate_of_structure);
}

}  // namespace plumbline::python
