#include "diagnose/bench/read_samples.hpp"
#include "tests/fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  return offer(bytes, size, [](const std::string& text) {
    using namespace plumbline::diagnose;
    const SampleFormat format = standard_format(2);
    read_samples({{"f", parse_sample_table(text, "f", format), format}}, plumbline::Control::end_point);
  });
}
