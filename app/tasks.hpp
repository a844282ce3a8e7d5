#pragma once
/// \file
/// The kinds of work that verbs share among processes.

#include <vector>

#include "support/work/work_list.hpp"

namespace plumbline::app {

std::vector<work::Task> tasks();

}  // namespace plumbline::app
