#include "app/results_folder.hpp"

#include <plumbline/base/error.hpp>

#include "support/files/output_file.hpp"
#include "support/work/ranks.hpp"

namespace plumbline::app {

ResultsFolder::ResultsFolder(const std::string& option, const std::string& wanted, const std::string& command)
    : path_(wanted) {
  if (wanted.empty()) {
    if (work::ranks() > 1)
      throw Error(option, "none", "a folder that all ranks of mpirun see, to keep what is done");
    path_ = temporary_.emplace().path();
    return;
  }
  files::make_folder(path_);
  journal_.emplace(path_ / work::unfinished_name, command);
}

}  // namespace plumbline::app
