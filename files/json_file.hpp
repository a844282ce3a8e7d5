#pragma once
/// \file
/// JSON, with errors in our form.

#include <nlohmann/json.hpp>
#include <string>

namespace plumbline::files {

/// \throws Error that names the source
nlohmann::json parse_json(const std::string& text, const std::string& source);

}  // namespace plumbline::files
