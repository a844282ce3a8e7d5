#include "app/tasks.hpp"

#include "app/secret_experiments.hpp"
#include "trial/diagnoses.hpp"

namespace plumbline::app {

std::vector<work::Task> tasks() {
  return {experiment_task, trial::diagnosis_task};
}

}  // namespace plumbline::app
