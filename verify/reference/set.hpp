#pragma once
/// \file
/// The reference values as files: CSV and JSON, their schemas and certificates, and what says how to read
/// them.

#include <nlohmann/json.hpp>

#include "proofs/certificates/certificate.hpp"
#include "verify/reference/chains.hpp"

namespace plumbline::verify {

/// Significant digits of every published value; all of them are right.
inline constexpr int reference_digits = 50;

struct ReferenceMode {
  std::string force;
  std::string energy_factor;        ///< (39), from the joint angles
  std::vector<std::string> angles;  ///< q_1 … q_n, the largest 1; empty where they are not published
};

struct ReferenceEntry {
  std::string name;
  Chain<Rational> chain;
  std::vector<ReferenceMode> modes;
  nlohmann::json certificate;
};

/// Computes and certifies what is published about a chain.
ReferenceEntry reference_entry(const ReferenceChain& chain);

struct NamedText {
  std::string name, text;
};

/// What is published about loaded chains: reference_loaded.hpp.
struct LoadedEntries {
  std::vector<nlohmann::json> equilibria, events;
  std::vector<nlohmann::json> certificates;  ///< of the equilibria
  std::vector<nlohmann::json> paths;         ///< certificates
};

/// What is published about chains with other ends and loads: structures.hpp.
struct StructureEntries {
  std::vector<nlohmann::json> structures, certificates;
};

/// All files of the set, README.md and datapackage.json among them.
std::vector<NamedText> reference_files(const std::vector<ReferenceEntry>& entries,
                                       const LoadedEntries& loaded, const StructureEntries& structures,
                                       const proofs::Provenance& provenance);

}  // namespace plumbline::verify
