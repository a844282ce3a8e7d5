#pragma once
/// \file
/// Many like tasks, shared among threads.

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace plumbline {

namespace detail {
/// Whether this thread does one of several tasks.
inline thread_local bool is_sharing = false;
}  // namespace detail

/// As many threads as the machine has cores, or as the environment variable OMP_NUM_THREADS allows.
inline unsigned available_threads() {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  const char* const text = std::getenv("OMP_NUM_THREADS");
  unsigned allowed = 0;
  if (text != nullptr) std::from_chars(text, text + std::strlen(text), allowed);
  return allowed > 0 ? std::min(cores, allowed) : cores;
}

/// Does work(0), …, work(count - 1), each once, in the caller's thread and up to threads - 1 others. Where
/// one throws, none is begun any more, and what the first of them in this order threw comes out. Of tasks
/// that share a machine each does its own in one thread.
template <class Work>
void in_parallel(std::size_t count, unsigned threads, const Work& work) {
  const bool several = !detail::is_sharing && threads > 1 && count > 1;
  std::atomic<std::size_t> next = 0;
  std::mutex failing;
  std::size_t failed = count;
  std::exception_ptr failure;
  const auto take_turns = [&] {
    const bool before = std::exchange(detail::is_sharing, detail::is_sharing || several);
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        next = count;
        const std::scoped_lock lock(failing);
        if (i < failed) failure = std::current_exception();
        failed = std::min(failed, i);
      }
    }
    detail::is_sharing = before;
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t t = 1; several && t < std::min<std::size_t>(threads, count); ++t)
      others.emplace_back(take_turns);
    take_turns();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace plumbline
