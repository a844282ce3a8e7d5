#include "support/work/threads.hpp"

#include <algorithm>
#include <plumbline/base/parallel.hpp>

#include "support/work/turns.hpp"

namespace plumbline::work {

void share_among_threads(const Task& task, std::size_t count, const Exchange& exchange) {
  Turns turns(count, exchange);
  const unsigned workers = task.by_threads ? available_threads() : 1;
  in_parallel(std::min<std::size_t>(workers, count), workers, [&](std::size_t) { turns.work_through(task); });
  turns.end();
}

}  // namespace plumbline::work
