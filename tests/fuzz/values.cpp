#include "app/submitted_values.hpp"
#include "tests/fuzz/target.hpp"

using plumbline::Error;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const plumbline::app::Chains chains{
      {"a", plumbline::Chain<plumbline::Rational>({1, 1, 1}, {1, 1, 1})},
      {"b", plumbline::Chain<plumbline::Rational>({1, 2}, {0, 1})}};
  return offer(bytes, size, [&](const std::string& text) {
    for (const std::string& line : plumbline::app::parse_values(text, "f", chains).errors)
      offer(bytes, size, [&](const std::string&) { throw Error(line); });
  });
}
