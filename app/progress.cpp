#include "app/progress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "app/terminal.hpp"

namespace plumbline::app {

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(total), columns_(terminal_columns(2)) {
  if (columns_ > 0) shown_ = std::jthread([this](const std::stop_token& end) { show(end); });
}

Progress::~Progress() = default;

/// Redraws the line above the cursor.
void Progress::show(const std::stop_token& end) {
  std::mutex mutex;
  std::condition_variable_any wake;
  std::unique_lock lock(mutex);
  const auto pause = [&](std::chrono::milliseconds time) {
    return wake.wait_for(lock, end, time, [] { return false; }) || end.stop_requested();
  };
  if (pause(std::chrono::seconds(1))) return;
  fmt::print(stderr, "{}\n", line());
  while (!pause(std::chrono::milliseconds(200))) fmt::print(stderr, "\033[A\r\033[K{}\n", line());
  fmt::print(stderr, "\033[A\r\033[K");
  std::fflush(stderr);
}

/// Never wider than the terminal, where it would take two lines.
std::string Progress::line() const {
  std::string text = whole_line();
  if (text.size() >= columns_) text.resize(columns_ - 1);
  return text;
}

std::string Progress::whole_line() const {
  using Seconds = std::chrono::duration<double>;
  const double seconds = Seconds(std::chrono::steady_clock::now() - begin_).count();
  const std::size_t done = done_;
  if (total_ == 0) return fmt::format("{}: {:.0f} s", what_, seconds);
  const std::size_t width = std::clamp<std::size_t>(columns_ / 4, 10, 40);
  const std::size_t filled = std::min(width, width * done / total_);
  std::string text = fmt::format("{} [{}{}] {}/{}, {:.0f} s", what_, std::string(filled, '#'),
                                 std::string(width - filled, '.'), done, total_, seconds);
  if (done > 0 && done < total_)
    text +=
        fmt::format(" of about {:.0f}", seconds / static_cast<double>(done) * static_cast<double>(total_));
  return text;
}

}  // namespace plumbline::app
