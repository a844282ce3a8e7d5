/// \file
/// How many items a second the first rank gives out, and what is lost: items that sleep, so that many more
/// ranks than processors can be tried. Usage: [mpirun -n RANKS] bench-ranks MICROSECONDS ITEMS

#include <fmt/core.h>

#include <chrono>
#include <string>
#include <thread>

#include "support/work/ranks.hpp"

namespace {

using namespace plumbline;

std::string sleep(const std::string& item) {
  const auto time = std::chrono::microseconds(std::stol(item));
  if (time.count() > 0) std::this_thread::sleep_for(time);
  return item;
}

const work::Task task{"sleep", sleep};

}  // namespace

int main(int argc, char** argv) {
  const work::Ranks ranks;
  if (!ranks.first()) {
    ranks.work({&task, 1});
    return 0;
  }
  if (argc != 3) {
    fmt::print(stderr, "usage: [mpirun -n RANKS] bench-ranks MICROSECONDS ITEMS\n");
    return 2;
  }
  const std::string item = argv[1];
  const work::WorkList list{task, std::vector<std::string>(std::stoul(argv[2]), item)};
  const auto begin = std::chrono::steady_clock::now();
  static_cast<void>(work::results(list, nullptr, [] {}));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const std::size_t at_once =
      work::ranks() > 1 ? static_cast<std::size_t>(work::ranks()) : std::thread::hardware_concurrency();
  const double ideal =
      1e-6 * std::stod(item) * static_cast<double>(list.items.size()) / static_cast<double>(at_once);
  fmt::print("{} at once: {:.0f} items a second; {:.3f} s, {:.3f} s of it the items' own\n", at_once,
             static_cast<double>(list.items.size()) / seconds, seconds, ideal);
  return 0;
}
