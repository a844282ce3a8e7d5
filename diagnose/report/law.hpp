#pragma once
/// \file
/// The torque law in reports.

#include <nlohmann/json.hpp>

#include "diagnose/report/charts.hpp"

namespace plumbline::diagnose {

/// The key `law` of the report.
nlohmann::ordered_json law_as_json(const OfferedLaw& offered);

/// "that closes" the gap (at most a quarter of the residual on held-out readings, or twice their noise),
/// "that narrows" it (less than the nominal model), or "fitted to" it.
std::string what_it_does(const OfferedLaw& offered);

/// "joints 1, 2".
std::string joint_words(const std::vector<std::size_t>& joints);

/// "joint_stop or nonlinear_spring, with hysteresis": effects of similar shape; empty without any.
std::string resemblance_words(const LawPicture& picture);

/// The lines of the terminal report.
std::string law_as_text(const OfferedLaw& offered);

/// The law with the nominal spring and the paths of the runs over the deflection; with Maxwell arms also the
/// torque over time.
std::vector<PageChart> law_charts(const Explained& explained);

}  // namespace plumbline::diagnose
