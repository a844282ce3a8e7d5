#include "diagnose/draft/drafted_run.hpp"
#include "tests/fuzz/target.hpp"

/// A table of readings as nobody has described it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  return offer(bytes, size, [](const std::string& text) {
    using namespace plumbline::diagnose;
    const DraftModel model{
        {{0.3, 0.2}, {2, 1.5}, {}, {0, 0}, {0.4, -0.9}, {}}, {"hip", "knee"}, {0.1, 0}, true};
    std::vector<Guess> guesses;
    for (const RunSource& source : run_sources({{"f.csv", text}}, model.joints, {}, guesses))
      drafted_run(source, model, {});
  });
}
