#include "support/work/journal.hpp"
#include "tests/fuzz/target.hpp"

/// The results of a work that was cut off.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  return offer(bytes, size, [](const std::string& text) {
    plumbline::work::unfinished_results(
        text, R"({"format":"plumbline-unfinished/1","program":"p","work":"w"})", "f");
  });
}
