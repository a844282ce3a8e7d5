#pragma once
/// \file
/// Items that several take in turns.

#include <exception>
#include <mutex>
#include <optional>

#include "support/work/ranks.hpp"

namespace plumbline::work {

/// Items given out in their order, and what came of them. Any thread may call.
class Turns {
 public:
  Turns(std::size_t count, const Exchange& exchange) : left_(count), failed_(count), exchange_(exchange) {}

  struct Turn {
    std::size_t number;
    std::string item;
  };
  /// Nothing when all are given out, or one has failed.
  std::optional<Turn> next();
  /// Takes the result; where that throws, the item has failed.
  void done(std::size_t number, const std::string& result);
  void failed(std::size_t number, const std::exception_ptr& failure);
  /// Takes turns until there are none.
  void work_through(const Task& task);
  /// Throws what the first of the items that failed threw.
  void end() const;

 private:
  std::mutex exchanging_;
  std::size_t next_ = 0, left_, failed_;
  const Exchange& exchange_;
  std::exception_ptr failure_;
};

}  // namespace plumbline::work
