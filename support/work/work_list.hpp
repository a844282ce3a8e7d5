#pragma once
/// \file
/// Many like items of work and their results, whoever does them: threads of this process, or the processes
/// that mpirun started.

#include <functional>
#include <string>
#include <vector>

namespace plumbline::work {

class Journal;

/// What is done to an item. The result depends on the item alone, whatever process does it; both are UTF-8.
struct Task {
  const char* name;                                ///< by which another process knows it
  std::string (*result)(const std::string& item);  ///< what it throws ends the whole work
  bool by_threads = true;                          ///< false where a process can do one item at a time only
};

struct WorkList {
  const Task& task;
  std::vector<std::string> items;
  /// Whether what a journal holds of an item still stands; where not, the item is done again.
  std::function<bool(std::size_t item, const std::string& result)> stands =
      [](std::size_t, const std::string&) { return true; };
};

/// What is made of the result of an item: called once for each, in any order, never twice at once.
using Take = std::function<void(std::size_t item, const std::string& result)>;

/// Does every item that the journal does not hold, several at once, each as soon as somebody is free.
/// \param journal  nothing where nothing is to be kept of work that is cut off
void do_all(const WorkList& list, Journal* journal, const Take& take);

/// The same. \param advance  called after each item
/// \returns the results in the order of the items
std::vector<std::string> results(const WorkList& list, Journal* journal,
                                 const std::function<void()>& advance);

}  // namespace plumbline::work
