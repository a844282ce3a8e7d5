#include <plumbline/base/parallel.hpp>

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

using namespace plumbline;

TEST_CASE("each task is done once, whatever the number of threads") {
  for (const unsigned threads : {0U, 1U, 3U, 50U}) {
    std::vector<int> times(20, 0);
    in_parallel(times.size(), threads, [&](std::size_t i) { ++times[i]; });
    CHECK(times == std::vector<int>(20, 1));
  }
  in_parallel(0, 2, [](std::size_t) { FAIL("there is nothing to do"); });
}

TEST_CASE("of several failures the first in order comes out, and what has not begun is left") {
  for (const unsigned threads : {1U, 4U}) {
    std::atomic<int> done = 0;
    const auto work = [&](std::size_t i) {
      if (i >= 5) throw std::runtime_error(std::to_string(i));
      ++done;
    };
    CHECK_THROWS_WITH_AS(in_parallel(1000, threads, work), "5", std::runtime_error);
    CHECK(done == 5);
  }
}

TEST_CASE("of tasks that share the machine each does its own in one thread") {
  std::atomic<int> elsewhere = 0;
  const auto count_elsewhere = [&](std::thread::id own) {
    in_parallel(50, 4, [&](std::size_t) { elsewhere += std::this_thread::get_id() != own; });
  };
  in_parallel(8, 2, [&](std::size_t) { count_elsewhere(std::this_thread::get_id()); });
  CHECK(elsewhere == 0);

  // One task alone shares what it does, and so does whatever comes after several.
  const auto meet = [] {
    std::atomic<int> there = 0;
    in_parallel(2, 2, [&](std::size_t) {
      for (++there; there < 2;) std::this_thread::yield();
    });
  };
  in_parallel(1, 4, [&](std::size_t) { meet(); });
  meet();
}

TEST_CASE("OMP_NUM_THREADS takes threads away and gives none") {
  const unsigned cores = available_threads();
  const auto with = [](const char* text) {
    setenv("OMP_NUM_THREADS", text, 1);
    const unsigned found = available_threads();
    unsetenv("OMP_NUM_THREADS");
    return found;
  };
  CHECK(with("1") == 1);
  CHECK(with("1,4") == 1);
  for (const char* none : {"", "0", "-2", "many", "1000000", "99999999999999999999"})
    CHECK(with(none) == cores);
}
