#pragma once
/// \file
/// Experiments made for a blind trial: the folders and the seals are public, the labels stay in memory.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>

#include "support/work/work_list.hpp"
#include "trial/seal.hpp"

namespace plumbline::app {

struct SecretExperiments {
  std::map<std::string, trial::Envelope> envelopes;  ///< by the name of the experiment
  std::vector<double> nominal_errors;                ///< of the rigs without effect, in sigmas
};

/// The blind trial: the first draws from the catalogue, the second from a wider range (trial/README.md).
enum class BlindTrial { first, second };

/// The item for another process.
extern const work::Task experiment_task;

/// Writes the experiments trial-001, trial-002, … of this seed into the folder, and seals.json beside them.
/// \throws Error where the program was built without the rig
SecretExperiments make_experiments(BlindTrial which, std::size_t trials, std::uint64_t seed,
                                   const std::filesystem::path& folder, const std::function<void()>& advance);

/// Writes labels/NAME.json for every envelope: the seals are then open.
void publish(const SecretExperiments& secret, const std::filesystem::path& folder);

}  // namespace plumbline::app
