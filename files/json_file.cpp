#include "files/json_file.hpp"

#include <plumbline/base/error.hpp>

namespace plumbline::files {

nlohmann::json parse_json(const std::string& text, const std::string& source) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw Error(source, error.what(), "JSON");
  }
}

}  // namespace plumbline::files
