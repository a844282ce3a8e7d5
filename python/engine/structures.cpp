#include <nlohmann/json.hpp>

#include "app/chain_file.hpp"
#include "app/space_file.hpp"
#include "proofs/certificates/certificate.hpp"
#include "proofs/certificates/structure_certificate.hpp"
#include "proofs/exact/critical_torque.hpp"
#include "proofs/exact/straight_space.hpp"
#include "python/engine/engine.hpp"

namespace plumbline::python {
namespace {

constexpr const char* source = "chain";

Structure<Rational> straight_structure(const std::string& text) {
  Structure<Rational> structure = app::parse_structure(text, source).structure;
  for (const Rational& angle : structure.chain.rest()) {
    if (angle != 0)
      throw Error("rest", "an angle that is not zero", "zero: only the straight chain has factors");
  }
  return structure;
}

app::SpaceCase straight_in_space(const std::string& text) {
  app::SpaceCase space = app::parse_space_chain(text, source);
  if (!space.axial) throw Error("loads", "loads across the chain, which bend it", "loads along x");
  return space;
}

std::string certificate_in_space(const std::string& name, const std::string& text, std::size_t lowest,
                                 int digits, const std::string& command) {
  const app::SpaceCase space = straight_in_space(text);
  if (space.torque) throw Error("loads", "a torque", "forces: no certificate is made of a torque");
  const proofs::StraightSpace straight(space.chain, space.straight);
  return certificate_text(
      proofs::structure_certificates, command,
      proofs::structure_certificate(name, space.chain, space.straight, straight, lowest, digits));
}

Decimals factors_in_space(const std::string& text, std::size_t lowest, int digits) {
  const app::SpaceCase space = straight_in_space(text);
  if (space.torque)
    return {proofs::critical_torque(space.chain, space.straight, *space.torque, digits).value.decimal};
  Decimals all;
  for (const proofs::SpaceMode& mode :
       proofs::StraightSpace(space.chain, space.straight).in_decimals(lowest, digits))
    all.push_back(mode.force);
  return all;
}

Decimals critical_factors(const std::string& text, std::size_t lowest, int digits) {
  return unlocked([&] {
    if (app::is_space_chain(text, source)) return factors_in_space(text, lowest, digits);
    Decimals all;
    for (const proofs::CriticalMode& mode :
         proofs::StraightStructure(straight_structure(text)).in_decimals(lowest, digits, false))
      all.push_back(mode.force);
    return all;
  });
}

py::dict stability_loss(const std::string& text, int digits) {
  const proofs::StabilityLoss loss =
      unlocked([&] { return proofs::stability_loss(straight_motion(straight_structure(text)), digits); });
  py::dict all;
  all["kind"] = loss.kind == proofs::Motion::flutter ? "flutter" : "divergence";
  all["factor"] = loss.factor, all["first"] = loss.first;
  return all;
}

std::string certificate_of_structure(const std::string& name, const std::string& text, std::size_t lowest,
                                     int digits, const std::string& command) {
  return unlocked([&] {
    if (app::is_space_chain(text, source)) return certificate_in_space(name, text, lowest, digits, command);
    const Structure<Rational> structure = straight_structure(text);
    const nlohmann::json entry =
        structure.follower()
            ? proofs::structure_certificate(
                  name, structure, proofs::stability_loss(straight_motion(structure), digits), digits)
            : proofs::structure_certificate(name, structure, proofs::StraightStructure(structure), lowest,
                                            digits);
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
