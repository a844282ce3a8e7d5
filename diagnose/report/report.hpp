#pragma once
/// \file
/// A diagnosis as machines read it (format "gap-diagnosis/2"), as a person reads it in the terminal, and as a
/// page.

#include <nlohmann/json.hpp>

#include "diagnose/answers/diagnosis.hpp"

namespace plumbline::diagnose {

nlohmann::ordered_json as_json(const Diagnosis& diagnosis);

/// Places in the ranking that reports list: the ten most probable, and what is named and stands behind them.
std::vector<std::size_t> listed_places(const Cause& cause);

/// The questions in order: is there a gap; where; what; how far; what next.
std::string as_text(const Diagnosis& diagnosis);

/// A page for people to look at, whole in one file: the same answers with the curves, the residuals, the
/// chain and what is missing drawn.
std::string as_html(const Study& study, const Diagnosis& diagnosis);

}  // namespace plumbline::diagnose
