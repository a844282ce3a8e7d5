#include "verify/reference/set.hpp"

#include <fmt/format.h>

#include <plumbline/straight/buckling_mode.hpp>

#include "proofs/certificates/equilibria_certificate.hpp"
#include "proofs/certificates/path_certificate.hpp"
#include "proofs/certificates/structure_certificate.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exactly.hpp"
#include "proofs/exact/working_precision.hpp"
#include "support/files/sha256.hpp"
#include "verify/reference/loaded.hpp"
#include "verify/reference/structures.hpp"
#include "verify/reference/texts.hpp"

namespace plumbline::verify {
namespace {

using nlohmann::json;

/// Up to so many links the certificate of a chain has its matrices: exact determinants take longer and
/// longer.
constexpr std::size_t most_links_with_matrices = 8;

/// Energy factors (39) of the lowest modes from their joint angles, which have twice the digits.
std::vector<std::string> energy_factors(const Chain<Rational>& chain, std::size_t modes) {
  const proofs::WorkingPrecision precision(2 * reference_digits + 20);
  const auto rounded = from_rational<Mpfr>(chain);
  std::vector<std::string> factors;
  for (const auto& mode : critical_modes(rounded, modes)) {
    factors.push_back(proofs::to_decimal(proofs::exactly(energy_factor(rounded, mode.q)), reference_digits));
  }
  return factors;
}

std::string joined(const std::vector<Rational>& values) {
  std::vector<std::string> texts;
  for (const Rational& x : values) texts.push_back(proofs::to_exact(x));
  return fmt::format("{}", fmt::join(texts, ";"));
}

std::string chains_csv(const std::vector<ReferenceEntry>& entries) {
  std::string text = "chain,lengths,stiffness\n";
  for (const auto& e : entries)
    text += fmt::format("{},{},{}\n", e.name, joined(e.chain.length()), joined(e.chain.stiffness()));
  return text;
}

std::string forces_csv(const std::vector<ReferenceEntry>& entries) {
  std::string text = "chain,mode,force,energy_factor\n";
  for (const auto& e : entries) {
    for (std::size_t m = 0; m < e.modes.size(); ++m)
      text += fmt::format("{},{},{},{}\n", e.name, m + 1, e.modes[m].force, e.modes[m].energy_factor);
  }
  return text;
}

std::string shapes_csv(const std::vector<ReferenceEntry>& entries) {
  std::string text = "chain,mode,joint,angle\n";
  for (const auto& e : entries) {
    for (std::size_t m = 0; m < e.modes.size(); ++m) {
      const auto& angles = e.modes[m].angles;
      for (std::size_t i = 0; i < angles.size(); ++i)
        text += fmt::format("{},{},{},{}\n", e.name, m + 1, i + 1, angles[i]);
    }
  }
  return text;
}

json to_json(const ReferenceEntry& e) {
  json modes = json::array();
  for (std::size_t m = 0; m < e.modes.size(); ++m) {
    modes.push_back(
        {{"mode", m + 1}, {"force", e.modes[m].force}, {"energy_factor", e.modes[m].energy_factor}});
    if (!e.modes[m].angles.empty()) modes.back()["angles"] = e.modes[m].angles;
  }
  return {{"chain", e.name},
          {"lengths", e.certificate["lengths"]},
          {"stiffness", e.certificate["stiffness"]},
          {"modes", std::move(modes)}};
}

/// JSON text with the entries of one list on a line each.
std::string line_by_line(json file, const std::string& list) {
  std::vector<std::string> lines;
  for (const json& entry : file[list]) lines.push_back("  " + entry.dump());
  file[list] = json::array();
  std::string text = file.dump(1) + "\n";
  const std::string empty = fmt::format("\"{}\": []", list);
  return text.replace(text.find(empty), empty.size(),
                      fmt::format("\"{}\": [\n{}\n ]", list, fmt::join(lines, ",\n")));
}

/// A file of entries, each on a line of its own.
std::string json_file(const char* format, int digits, const char* list, const std::vector<json>& entries,
                      const proofs::Provenance& provenance) {
  return line_by_line({{"$schema", std::string(format) + ".schema.json"},
                       {"format", std::string("plumbline-") + format},
                       {"version", 1},
                       {"licence", "CC0-1.0"},
                       {"provenance", to_json(provenance)},
                       {"digits", digits},
                       {list, entries}},
                      list);
}

/// The Frictionless data package descriptor: what each file is, column by column, and its digest.
json data_package(const std::vector<NamedText>& files, const proofs::Provenance& provenance) {
  json package = json::parse(data_package_text);
  package["provenance"] = to_json(provenance);
  for (json& resource : package["resources"]) {
    const auto file = std::find_if(files.begin(), files.end(), [&](const NamedText& candidate) {
      return candidate.name == resource["path"];
    });
    resource["bytes"] = file->text.size();
    resource["hash"] = "sha256:" + files::sha256(file->text);
  }
  return package;
}

}  // namespace

ReferenceEntry reference_entry(const ReferenceChain& reference) {
  const auto modes = proofs::certify(reference.chain, reference.modes, reference.shapes, reference_digits);
  ReferenceEntry entry{
      reference.name, reference.chain, {}, proofs::certificate(reference.name, reference.chain, modes)};
  const auto factors = energy_factors(reference.chain, reference.modes);
  for (std::size_t m = 0; m < modes.forces.size(); ++m) {
    entry.modes.push_back({proofs::certified_force(modes, m + 1), factors[m],
                           m < modes.shapes.size() ? modes.shapes[m].q : std::vector<std::string>{}});
  }
  if (reference.chain.size() <= most_links_with_matrices)
    entry.certificate["matrices"] = proofs::matrix_certificate(reference.chain);
  return entry;
}

std::vector<NamedText> reference_files(const std::vector<ReferenceEntry>& entries,
                                       const LoadedEntries& loaded, const StructureEntries& structures,
                                       const proofs::Provenance& provenance) {
  std::vector<json> chains, certificates;
  for (const auto& e : entries) {
    chains.push_back(to_json(e));
    certificates.push_back(e.certificate);
  }
  const auto json_text = [&](const char* format, int digits, const char* list, const std::vector<json>& all) {
    return json_file(format, digits, list, all, provenance);
  };
  const auto certificate_text = [&](const char* format, std::vector<json> all) {
    return line_by_line(proofs::certificate_file(format, provenance, std::move(all)), "certificates");
  };
  std::vector<NamedText> files{
      {"chains.csv", chains_csv(entries)},
      {"forces.csv", forces_csv(entries)},
      {"shapes.csv", shapes_csv(entries)},
      {"reference.json", json_text("reference", reference_digits, "chains", chains)},
      {"reference.schema.json", reference_schema_text},
      {"equilibria.csv", equilibria_csv(loaded.equilibria)},
      {"equilibria.json", json_text("equilibria", reference_digits, "cases", loaded.equilibria)},
      {"equilibria.schema.json", equilibria_schema_text},
      {"events.csv", events_csv(loaded.events)},
      {"events.json", json_text("events", event_digits, "cases", loaded.events)},
      {"events.schema.json", events_schema_text},
      {"certificates.json", certificate_text(proofs::critical_certificates, std::move(certificates))},
      {"certificate.schema.json", certificate_schema_text},
      {"equilibria-certificates.json",
       certificate_text(proofs::equilibria_certificates, loaded.certificates)},
      {"equilibria-certificate.schema.json", equilibria_certificate_schema_text},
      {"path-certificates.json", certificate_text(proofs::path_certificates, loaded.paths)},
      {"path-certificate.schema.json", path_certificate_schema_text},
      {"structures.csv", structures_csv(structures.structures)},
      {"structures.json", json_text("structures", reference_digits, "structures", structures.structures)},
      {"structures.schema.json", structures_schema_text},
      {"structure-certificates.json",
       certificate_text(proofs::structure_certificates, structures.certificates)},
      {"structure-certificate.schema.json", structure_certificate_schema_text},
      {"README.md", reference_readme_text},
  };
  files.push_back({"datapackage.json", data_package(files, provenance).dump(2) + "\n"});
  return files;
}

}  // namespace plumbline::verify
