#include "app/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <utility>

namespace plumbline::app {

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(total), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::advance() {
  const std::scoped_lock lock(mutex_);
  ++done_;
  if (!terminal_ || Clock::now() < next_) return;
  next_ = Clock::now() + std::chrono::milliseconds(100);
  shown_ = true;
  draw();
}

void Progress::draw() const {
  constexpr std::size_t width = 40;
  const std::size_t filled = total_ == 0 ? width : std::min(width, width * done_ / total_);
  fmt::print(stderr, "\r\033[K{} [{}{}] {}/{}", what_, std::string(filled, '#'),
             std::string(width - filled, '.'), done_, total_);
  std::fflush(stderr);
}

}  // namespace plumbline::app
