#include "statement/chain_table.hpp"
#include "tests/fuzz/target.hpp"

using plumbline::Error;

/// The errors of rows are lines too.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  return offer(bytes, size, [&](const std::string& text) {
    for (const std::string& line : plumbline::statement::parse_chain_table(text, "f").errors)
      offer(bytes, size, [&](const std::string&) { throw Error(line); });
  });
}
