#pragma once
/// \file
/// The user's model of a joint with what a diagnosis of its logs found.

#include <filesystem>

#include "diagnose/exchange/model.hpp"
#include "diagnose/motion/diagnosis.hpp"

namespace plumbline::motion {

/// The model's file (key `model.file`) with the numbers of the drive in it, those of the cause that is named
/// first and those that were unknown; what is not touched stays byte by byte. Or, for an ending of .json,
/// parameters as BAM (better actuator models) has them. Every effect is told with what became of it.
/// \param path  of the file to be written; its ending says the format, which the model's file must have
/// \throws Error where there is no model of the format, no such joint, or none that can be told
exchange::Written corrected_joint(const Bench& bench, const Diagnosis& diagnosis,
                                  const std::filesystem::path& path);

}  // namespace plumbline::motion
