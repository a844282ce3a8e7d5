#pragma once
/// \file
/// Every kind of work that the verbs share among processes.

#include <vector>

#include "support/work/work_list.hpp"

namespace plumbline::app {

std::vector<work::Task> tasks();

}  // namespace plumbline::app
