#include "files/json_file.hpp"

#include <plumbline/error.hpp>

namespace plumbline {

nlohmann::json parse_json(const std::string& text, const std::string& source) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw Error(source, error.what(), "JSON");
  }
}

}  // namespace plumbline
