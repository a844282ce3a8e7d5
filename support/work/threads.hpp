#pragma once
/// \file
/// The threads of one process, as many as it has processors.

#include "support/work/ranks.hpp"

namespace plumbline::work {

void share_among_threads(const Task& task, std::size_t count, const Exchange& exchange);

}  // namespace plumbline::work
