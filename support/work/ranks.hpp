#pragma once
/// \file
/// Who shares the work: the threads of this process, or the processes ("ranks") that mpirun started.

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "support/work/work_list.hpp"

namespace plumbline::work {

/// The processes that mpirun started with this one; it alone where none did, or where the program was built
/// without MPI. The first rank runs the command, the others do items for it and nothing else. One object a
/// process, from the beginning of main to its end.
class Ranks {
 public:
  Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  /// Lets the others go home.
  ~Ranks();

  [[nodiscard]] bool first() const;
  /// On every rank but the first: does items until there is no more work.
  /// \param tasks  all that there are
  void work(std::span<const Task> tasks) const;
};

/// How many ranks there are; 1 without mpirun.
int ranks();

/// Where items come from and results go: both called in one thread at a time, results in any order.
struct Exchange {
  std::function<std::string(std::size_t)> item;
  std::function<void(std::size_t, const std::string&)> take;
};

/// Does a task to items 0 … count - 1, each once, by whoever is free: ranks, an item at a time each, or
/// without them a thread a processor. Where one throws, none is begun any more, and what the first of them in
/// this order threw comes out.
void share(const Task& task, std::size_t count, const Exchange& exchange);

/// Whether mpirun, or the like, started this process, whose standard streams then are not the user's but pass
/// through it.
bool launched();

}  // namespace plumbline::work
