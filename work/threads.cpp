#include "work/threads.hpp"

#include <algorithm>
#include <thread>
#include <vector>

#include "work/turns.hpp"

namespace plumbline::work {

void share_among_threads(const Task& task, std::size_t count, const Exchange& exchange) {
  Turns turns(count, exchange);
  {
    const std::size_t processors = task.by_threads ? std::thread::hardware_concurrency() : 1;
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < std::min(processors, count); ++t)
      others.emplace_back([&] { turns.work_through(task); });
    turns.work_through(task);
  }
  turns.end();
}

}  // namespace plumbline::work
