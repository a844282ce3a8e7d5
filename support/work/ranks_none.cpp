// Built without MPI: one process.
#include "support/work/ranks.hpp"
#include "support/work/threads.hpp"

namespace plumbline::work {

Ranks::Ranks() = default;
Ranks::~Ranks() = default;

bool Ranks::first() const {
  return true;
}

void Ranks::work(std::span<const Task>) const {}

int ranks() {
  return 1;
}

bool launched() {
  return false;
}

void share(const Task& task, std::size_t count, const Exchange& exchange) {
  share_among_threads(task, count, exchange);
}

}  // namespace plumbline::work
