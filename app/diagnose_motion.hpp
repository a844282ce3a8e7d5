#pragma once
/// \file
/// The diagnosis of logs of a joint in motion, as a verb runs it.

#include <CLI/CLI.hpp>
#include <string>

namespace plumbline::app {

/// Whether the folder holds an experiment of motion.
bool is_motion(const std::string& folder);

/// \param json       file for the report as JSON; or empty
/// \param corrected  file for the model of the joint with what was found; or empty
void diagnose_motion(const std::string& folder, const std::string& json, const std::string& corrected,
                     const CLI::App& verb);

}  // namespace plumbline::app
