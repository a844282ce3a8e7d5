#pragma once
/// \file
/// The diagnosis of a whole folder, and its score.

#include <functional>

#include "diagnose/campaign/diagnoses.hpp"
#include "trial/sealed_folder.hpp"

namespace plumbline::trial {

/// Diagnoses every experiment into reports/NAME.json.
/// \returns the outcomes in the order of the names
std::vector<campaign::Diagnosed> diagnose_all(const SealedFolder& folder,
                                              const std::filesystem::path& reports,
                                              std::chrono::duration<double> patience, work::Journal* journal,
                                              const std::function<void()>& advance);

/// Opens every seal and scores.
/// \param catalogue  the effects that this diagnosis can name
std::vector<Case> unseal(const SealedFolder& folder, const std::filesystem::path& reports,
                         const std::vector<campaign::Diagnosed>& diagnosed, const Catalogue& catalogue);

}  // namespace plumbline::trial
