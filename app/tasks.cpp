#include "app/tasks.hpp"

#include "app/secret_experiments.hpp"
#include "diagnose/campaign/diagnoses.hpp"
#include "verify/reference/work.hpp"
#include "verify/sampled/sampled.hpp"

namespace plumbline::app {

std::vector<work::Task> tasks() {
  return {experiment_task, campaign::diagnosis_task, verify::chains_task, verify::reference_task};
}

}  // namespace plumbline::app
