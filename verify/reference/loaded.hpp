#pragma once
/// \file
/// The loaded chains of the reference values: all their equilibria under a given load, and the events on the
/// way when they are compressed.

#include <nlohmann/json.hpp>
#include <optional>

#include "proofs/census/census_task.hpp"
#include "verify/reference/chains.hpp"

namespace plumbline::verify {

/// Significant digits of events. They are located twice, with steps of different length, and agree to so
/// many.
inline constexpr int event_digits = 40;

struct LoadedCase {
  proofs::CensusTask task;
  Rational window;  ///< events up to this deflection, or force; 0 for none
};

/// The paper's chains, one that snaps, and random ones of two to five links; the compact ones are among the
/// full ones.
std::vector<LoadedCase> loaded_cases(ReferenceSize size, std::uint64_t seed);

struct CertifiedEntry {
  nlohmann::json entry;
  nlohmann::json certificate;  ///< in the format of proofs/certificates/equilibria-certificate-format.md
};

/// All equilibria under the given load, by energy, each number to the digits that interval arithmetic proves,
/// 50 at most; the list itself is proved complete. Nothing where that does not succeed.
std::optional<CertifiedEntry> equilibria_entry(const LoadedCase& loaded);

/// Folds, bifurcations and quasi-buckling points in order on the branch through the unloaded shape while the
/// end point, from where it is then, or the force on it, from nothing, goes along -x. With the end point
/// held, a passive base is turned so that the unloaded end point lies on the x axis. Nothing where the two
/// computations differ.
std::optional<nlohmann::json> events_entry(const LoadedCase& loaded);

/// A certificate of what the chain does while it is loaded slowly up to `window`, jumps included, in the
/// format of proofs/certificates/path-certificate-format.md. Nothing for a passive base, and where a part is
/// not proved.
std::optional<nlohmann::json> path_entry(const LoadedCase& loaded);

/// The entries as a table: a row for each equilibrium or event, the lists in it joined by semicolons.
std::string equilibria_csv(const std::vector<nlohmann::json>& entries);
std::string events_csv(const std::vector<nlohmann::json>& entries);

}  // namespace plumbline::verify
