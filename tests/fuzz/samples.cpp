#include "diagnose/bench/read_samples.hpp"
#include "tests/fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  return offer(bytes, size, [](const std::string& text) {
    plumbline::diagnose::parse_samples(text, "f", plumbline::Control::end_point,
                                       plumbline::diagnose::standard_format(2));
  });
}
