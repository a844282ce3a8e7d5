#pragma once
/// \file
/// A progress bar for people who wait.

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace plumbline::app {

/// Shows on standard error how much of the work is done: only when that is a terminal, and only after a
/// second. Gone when it is destroyed. Any thread may report.
class Progress {
 public:
  /// \param what   a word or two for what is being done
  /// \param total  how many steps there are
  Progress(std::string what, std::size_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// One more step is done.
  void advance();

 private:
  using Clock = std::chrono::steady_clock;
  void draw() const;

  std::mutex mutex_;
  std::string what_;
  std::size_t total_, done_ = 0;
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
  bool terminal_, shown_ = false;
};

}  // namespace plumbline::app
