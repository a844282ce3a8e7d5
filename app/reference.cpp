#include <fmt/format.h>

#include <memory>

#include "app/arguments.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "support/work/journal.hpp"
#include "verify/reference/work.hpp"

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;

struct ReferenceOptions {
  std::string out;
  bool compact = false;
  std::uint64_t seed = verify::reference_seed;
  std::size_t random = 0;

  [[nodiscard]] verify::ReferenceWish wish() const {
    return {compact ? verify::ReferenceSize::compact : verify::ReferenceSize::full, seed, random};
  }
  /// The command that reproduces the set.
  [[nodiscard]] std::string command() const {
    return fmt::format("plumbline reference{}{} --seed {} --out DIR", compact ? " --compact" : "",
                       random > 0 ? fmt::format(" --random {}", random) : "", seed);
  }
};

std::vector<std::string> compute(const ReferenceOptions& options, work::Journal& unfinished) {
  const work::WorkList list = verify::reference_work(options.wish());
  Progress progress("chains", list.items.size());
  return work::results(list, &unfinished, [&] { progress.advance(); });
}

void run(const ReferenceOptions& options, const CLI::App& verb) {
  files::require_folder(options.out);
  files::make_folder(options.out);
  work::Journal unfinished(fs::path(options.out) / work::unfinished_name, options.command());
  const verify::ReferenceValues values =
      verify::reference_values(options.wish(), compute(options, unfinished));
  const auto texts = verify::reference_files(
      values.entries, values.loaded, values.structures,
      {options.command(), "plumbline " PLUMBLINE_VERSION, std::to_string(options.seed)});
  Outputs outputs(verb, {});
  for (const verify::NamedText& text : texts)
    outputs.open("--out", fs::path(options.out) / text.name)->write(text.text);
  outputs.commit();
  unfinished.finish();
}

}  // namespace

void add_reference(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("reference", "Write the reference values for other implementations, certified");
  const auto options = std::make_shared<ReferenceOptions>();
  add_output(*verb, "--out", options->out, "Folder to write into; interrupted work continues there", "DIR")
      ->required();
  verb->add_flag("--compact", options->compact, "About a hundred chains instead of a few thousand");
  verb->add_option("--seed", options->seed, "Of the random chains")
      ->check(whole_number(0))
      ->capture_default_str();
  verb->add_option("--random", options->random, "So many chains of the family random")
      ->check(whole_number(1, 100000000))
      ->type_name("N");
  verb->footer("README.md in DIR says what the files hold.");
  verb->callback([options, verb] { run(*options, *verb); });
}

}  // namespace plumbline::app
