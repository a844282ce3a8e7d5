#pragma once
/// \file
/// The bench whose channels are those of the tables.

#include <string>
#include <vector>

#include "diagnose/draft/draft.hpp"

namespace plumbline::diagnose {

/// A joint alone has its own. Of a model that is a chain in a plane and an arm in space, the readings decide:
/// loads on the end point or along the chain are those of a chain, commands and poses those of an arm.
/// \throws Error where the model is neither
BenchKind bench_of(const DraftModel& model, const std::vector<RunSource>& sources,
                   const std::vector<std::string>& joints);

}  // namespace plumbline::diagnose
