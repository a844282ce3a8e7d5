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
