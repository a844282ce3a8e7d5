#pragma once
/// \file
/// The nominal model with what a diagnosis found, for every candidate that it leaves.

#include <nlohmann/json.hpp>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/exchange/format.hpp"
#include "diagnose/exchange/model.hpp"

namespace plumbline::exchange {

/// One candidate's model.
struct Corrected {
  std::string cause;  ///< "backlash-2": what tells its file from the others'; empty where it is the only one
  Model model;
};

/// One model where a cause was identified, or none is needed; one a candidate where several cannot be told
/// apart; the free torque law, if there is one, where the cause is or may be unknown.
/// \param source  the file that the nominal chain was read from, if any
std::vector<Corrected> corrected_models(const diagnose::Study& study, const diagnose::Diagnosis& diagnosis,
                                        const std::filesystem::path& source = {});

/// The model in a format. MJCF that the nominal chain was read from is edited in place, where it can be.
Written written(const Model& model, Format format);

}  // namespace plumbline::exchange
