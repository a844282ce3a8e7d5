#include "app/usage/usage.hpp"

#include <sstream>

namespace plumbline::app {

std::vector<const CLI::App*> verbs(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> flags(const CLI::Option& option) {
  std::vector<std::string> result;
  for (const std::string& name : option.get_snames()) result.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.push_back("--" + name);
  return result;
}

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

std::vector<std::string> choices(const CLI::Option& option) {
  const std::string type = option.get_type_name();  // such as TEXT:{stable,all}
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  std::vector<std::string> result;
  std::istringstream list(type.substr(open + 1, close - open - 1));
  for (std::string choice; std::getline(list, choice, ',');) result.push_back(choice);
  return result;
}

bool is_file(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.find("FILE") != std::string::npos || type.find(".csv") != std::string::npos;
}

bool is_folder(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type == "DIR" || type == "FOLDER";
}

}  // namespace plumbline::app
