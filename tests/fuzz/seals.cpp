#include "tests/fuzz/target.hpp"
#include "trial/seal.hpp"

/// Seals, or an envelope: both are tried.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  offer(bytes, size, [](const std::string& text) { plumbline::trial::parse_envelope(text, "f"); });
  return offer(bytes, size, [](const std::string& text) { plumbline::trial::parse_seals(text, "f"); });
}
