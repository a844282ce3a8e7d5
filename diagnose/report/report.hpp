#pragma once
/// \file
/// A diagnosis as JSON (format "gap-diagnosis/2"), as text and as an HTML page.

#include <nlohmann/json.hpp>

#include "diagnose/answers/diagnosis.hpp"

namespace plumbline::diagnose {

nlohmann::ordered_json as_json(const Diagnosis& diagnosis);

/// The text: the answer first, then the questions in order: gap, where, what, how far, what next.
std::string as_text(const Diagnosis& diagnosis);
/// The values of the best explanation where they are few, a line each; and the questions below the answer.
std::string values_as_text(const Diagnosis& diagnosis);
std::string questions_as_text(const Diagnosis& diagnosis);

/// The page, self-contained: the same answers with curves, residuals, shapes and the unexplained residual.
std::string as_html(const Study& study, const Diagnosis& diagnosis);

}  // namespace plumbline::diagnose
