#pragma once
/// \file
/// A sign of life for people who wait.

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>
#include <thread>

namespace plumbline::app {

/// Shows on standard error how much of the work is done and how long it has taken: only when that is a
/// terminal, and only after a second; from a thread of its own, so that it lives where a step takes long.
/// Gone when it is destroyed; where the process is interrupted, the line stays and the next begins below it.
/// Any thread may report.
class Progress {
 public:
  /// \param what   a word or two for what is being done
  /// \param total  how many steps there are; 0 where nobody knows
  Progress(std::string what, std::size_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// More steps are done.
  void advance(std::size_t steps = 1) { done_ += steps; }

 private:
  void show(const std::stop_token& end);
  [[nodiscard]] std::string line() const;
  [[nodiscard]] std::string whole_line() const;

  std::string what_;
  std::size_t total_, columns_;
  std::atomic<std::size_t> done_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::jthread shown_;
};

}  // namespace plumbline::app
