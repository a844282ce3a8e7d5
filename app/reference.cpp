#include <fmt/format.h>

#include <memory>

#include "app/arguments.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "verify/reference/loaded.hpp"
#include "verify/reference/set.hpp"

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_links_with_path = 2;  ///< of random chains: certificates of paths are long

struct Options {
  fs::path out;
  bool compact = false;
  std::uint64_t seed = verify::reference_seed;
};

std::vector<verify::NamedText> compute(const Options& options) {
  const auto chains = verify::reference_chains(
      options.compact ? verify::ReferenceSize::compact : verify::ReferenceSize::full, options.seed);
  const auto cases = verify::loaded_cases(
      options.compact ? verify::ReferenceSize::compact : verify::ReferenceSize::full, options.seed);
  std::vector<verify::ReferenceEntry> entries;
  verify::LoadedEntries loaded;
  Progress progress("chains", chains.size() + cases.size());
  for (const verify::ReferenceChain& chain : chains) {
    entries.push_back(verify::reference_entry(chain));
    progress.advance();
  }
  for (const verify::LoadedCase& one : cases) {
    if (auto found = verify::equilibria_entry(one)) {
      loaded.equilibria.push_back(std::move(found->entry));
      loaded.certificates.push_back(std::move(found->certificate));
    }
    if (one.window > 0) {
      if (auto entry = verify::events_entry(one)) loaded.events.push_back(*std::move(entry));
      if (one.task.chain.size() <= most_links_with_path || !one.task.name.starts_with("loaded")) {
        if (auto entry = verify::path_entry(one)) loaded.paths.push_back(*std::move(entry));
      }
    }
    progress.advance();
  }
  const std::string command = fmt::format("plumbline reference{} --seed {} --out DIR",
                                          options.compact ? " --compact" : "", options.seed);
  return verify::reference_files(entries, loaded,
                                 {command, "plumbline " PLUMBLINE_VERSION, std::to_string(options.seed)});
}

void run(const Options& options) {
  files::require_folder(options.out);
  const auto texts = compute(options);
  files::make_folder(options.out);
  Outputs outputs({});
  for (const verify::NamedText& text : texts)
    outputs.open("--out", options.out / text.name)->write(text.text);
  outputs.commit();
}

}  // namespace

void add_reference(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("reference", "Write the reference values for other implementations, certified");
  const auto options = std::make_shared<Options>();
  verb->add_option("--out", options->out, "Directory to write into")->type_name("DIR")->required();
  verb->add_flag("--compact", options->compact, "About a hundred chains instead of a few thousand");
  verb->add_option("--seed", options->seed, "Of the random chains")
      ->check(whole_number(0))
      ->capture_default_str();
  verb->footer("README.md in DIR says what the files hold.");
  verb->callback([options] { run(*options); });
}

}  // namespace plumbline::app
