#include "app/example_experiment.hpp"

#include <map>
#include <string>

#include "app/example_files.hpp"
#include "diagnose/bench/read_experiment.hpp"

namespace plumbline::app {

diagnose::Experiment example_experiment(const diagnose::NominalChain* model) {
  std::map<std::string, std::string> files;
  for (const auto& [name, text] : example_files) files.emplace(name, text);
  return diagnose::read_experiment(
      "examples/experiment", [&](const std::string& name, const std::string&) { return files.at(name); },
      model);
}

}  // namespace plumbline::app
