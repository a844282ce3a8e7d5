#pragma once
/// \file
/// The diagnosis of a whole folder, and its score.

#include <functional>

#include "trial/diagnosis_process.hpp"
#include "trial/sealed_folder.hpp"

namespace plumbline::trial {

/// What every diagnosis left behind, in the order of the names.
using AllDiagnosed = std::vector<Diagnosed>;

/// Diagnoses every experiment, two or more at once; the reports go to reports/NAME.json.
AllDiagnosed diagnose_all(const SealedFolder& folder, const std::filesystem::path& executable,
                          const std::filesystem::path& reports, std::chrono::duration<double> patience,
                          unsigned processes, const std::function<void()>& advance);

/// Opens every seal and compares. \param catalogue  what this diagnosis can name
std::vector<Case> unseal(const SealedFolder& folder, const std::filesystem::path& reports,
                         const AllDiagnosed& diagnosed, const Catalogue& catalogue);

}  // namespace plumbline::trial
