#include "app/example_experiment.hpp"

#include "app/example_files.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "files/temporary_folder.hpp"
#include "files/text_file.hpp"

namespace plumbline::app {

diagnose::Experiment example_experiment() {
  const files::TemporaryFolder folder;
  for (const auto& [name, text] : example_files) files::write_text(folder / name, text);
  return diagnose::read_experiment(folder.path());
}

}  // namespace plumbline::app
