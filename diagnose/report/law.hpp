#pragma once
/// \file
/// What a report says of a torque law that is offered where nothing known fits.

#include <nlohmann/json.hpp>

#include "diagnose/report/charts.hpp"

namespace plumbline::diagnose {

/// The key `law` of the report.
nlohmann::ordered_json law_as_json(const OfferedLaw& offered);

/// "that closes" the gap, where it leaves a quarter at most of readings that it has not seen, or twice their
/// noise; "that narrows" it, where it leaves less than the nominal model does; else "fitted to" it.
std::string what_it_does(const OfferedLaw& offered);

/// "joints 1, 2".
std::string joint_words(const std::vector<std::size_t>& joints);

/// "joint_stop or nonlinear_spring, with hysteresis": the effects whose shape a law has; empty without any.
std::string resemblance_words(const LawPicture& picture);

/// The lines of the text report.
std::string law_as_text(const OfferedLaw& offered);

/// The law with the nominal spring and the paths of the runs over the deflection, and, where arms relax, the
/// torque over time.
std::vector<PageChart> law_charts(const Explained& explained);

}  // namespace plumbline::diagnose
