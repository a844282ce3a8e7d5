#pragma once
/// \file
/// Progress for people who wait.

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>
#include <thread>

namespace plumbline::app {

/// Shows on standard error the fraction of work done and the time taken, if that is a terminal and after a
/// second, from its own thread. The line disappears at the end; after an interruption it stays. Thread-safe.
class Progress {
 public:
  /// \param what   a word or two for the work
  /// \param total  number of steps; 0 if unknown
  Progress(std::string what, std::size_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Reports finished steps.
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

/// \param work  called with a function that reports the fraction of work done
auto with_progress(const std::string& name, auto work) {
  constexpr std::size_t steps = 100;
  Progress progress(name, steps);
  std::size_t shown = 0;
  return work([&](double share) {
    for (; shown < static_cast<std::size_t>(share * steps); ++shown) progress.advance();
  });
}

}  // namespace plumbline::app
