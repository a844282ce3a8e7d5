#include "diagnose/bench/read_experiment.hpp"
#include "tests/fuzz/target.hpp"

/// experiment.toml, a line "----", and the samples, which are every run's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  return offer(bytes, size, [](const std::string& text) {
    const std::string cut = "\n----\n";
    const std::size_t at = std::min(text.find(cut), text.size());
    const std::string settings = text.substr(0, at),
                      samples = at == text.size() ? "" : text.substr(at + cut.size());
    plumbline::diagnose::read_experiment("f", [&](const std::string& name, const std::string&) {
      const std::string& content = name == "experiment.toml" ? settings : samples;
      plumbline::files::require_text(content, "f");
      return content;
    });
  });
}
