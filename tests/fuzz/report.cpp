#include "diagnose/campaign/stated_report.hpp"
#include "tests/fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  return offer(bytes, size, [](const std::string& text) {
    plumbline::campaign::report_from(plumbline::files::parse_json(text, "f"), "f");
  });
}
