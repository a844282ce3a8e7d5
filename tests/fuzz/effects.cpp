#include "diagnose/rig/user_effects/read_effects.hpp"
#include "tests/fuzz/target.hpp"

/// Effects that a user states.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  return offer(bytes, size, [](const std::string& text) { plumbline::diagnose::parse_effects(text, "f"); });
}
