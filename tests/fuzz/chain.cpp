#include "app/chain_file.hpp"
#include "app/space_file.hpp"
#include "tests/fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  return offer(bytes, size, [](const std::string& text) {
    using namespace plumbline::app;
    if (is_space_chain(text, "f"))
      parse_space_chain(text, "f");
    else
      parse_structure(text, "f");
  });
}
