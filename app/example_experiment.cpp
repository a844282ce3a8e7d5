#include "app/example_experiment.hpp"

#include <map>
#include <string>

#include "app/example_files.hpp"
#include "diagnose/bench/read_experiment.hpp"

namespace plumbline::app {

namespace {

std::string file(const std::string& name, const std::string&) {
  std::map<std::string, std::string> files;
  for (const auto& [known, text] : example_files) files.emplace(known, text);
  return files.at(name);
}

}  // namespace

diagnose::Experiment example_experiment(const diagnose::NominalChain* model) {
  return diagnose::read_experiment("examples/experiment", file, model);
}

diagnose::Experiment example_bench(const diagnose::NominalChain* model) {
  return diagnose::read_plan("examples/experiment", file, model);
}

}  // namespace plumbline::app
