#pragma once
/// \file
/// The diagnosis of logs of a joint in motion, as a verb runs it.

#include <CLI/CLI.hpp>
#include <string>

namespace plumbline::app {

/// Whether the folder holds an experiment of motion.
bool is_motion(const std::string& folder);

/// Files of the report; empty for none.
struct MotionFiles {
  std::string json, html, corrected;  ///< the last: the model of the joint with what was found
};

/// \param next  whether the motion to be logged next is told where the cause is clear, too
void diagnose_motion(const std::string& folder, const MotionFiles& files, bool next, const CLI::App& verb);

/// What the planned motions of an experiment can show.
/// \param json  file for the plan as JSON; or empty
void plan_motion(const std::string& folder, const std::string& json, const CLI::App& verb);

/// Whether the folder holds logs of an arm's torques.
bool is_of_torques(const std::string& folder);

/// \param json  file for the report as JSON; or empty
void balance_torques(const std::string& folder, const std::string& json, const CLI::App& verb);

}  // namespace plumbline::app
