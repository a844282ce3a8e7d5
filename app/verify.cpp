#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <plumbline/base/error.hpp>

#include "app/arguments.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "verify/claims/claims.hpp"
#include "verify/core/core_table.hpp"
#include "verify/figures/figures.hpp"
#include "verify/report/errata.hpp"
#include "verify/report/report.hpp"
#include "verify/sampled/sampled.hpp"

namespace plumbline::app {
namespace {

struct VerifyOptions {
  std::string folder, section, claim, json, html, errata, unfinished;
  int precision = 50;
  bool core = false;
  std::size_t chains = 0;
  std::uint64_t seed = 1;
};

bool with_colour() {
  return terminal_columns(1) > 0 && std::getenv("NO_COLOR") == nullptr;
}

/// What is read of a paper's folder; nothing where there is none.
std::vector<std::filesystem::path> files_of(const std::string& folder) {
  std::vector<std::filesystem::path> list;
  if (folder.empty() || !std::filesystem::is_directory(folder)) return list;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".toml") list.push_back(entry.path());
  std::sort(list.begin(), list.end());
  return list;
}

/// The paper of a folder, or the one that the program was made for.
const verify::Paper& paper_of(const VerifyOptions& options) {
  if (options.folder.empty()) return verify::checked_paper();
  static const verify::Paper given = verify::with_checks(verify::read_paper_folder(options.folder));
  return given;
}

/// The whole paper's, for the page; none where they cannot be drawn, and then why.
std::vector<verify::DrawnFigure> draw_figures(const std::vector<verify::Judged>& judged,
                                              std::string& problem) {
  std::vector<verify::DrawnFigure> drawn;
  Progress progress("figures", verify::figures().size());
  for (const verify::Figure& figure : verify::figures()) {
    try {
      drawn.push_back({figure.number, figure.title, verify::verdicts_about(figure, judged),
                       page::as_svg(figure.draw(), figure.columns)});
    } catch (const Error& error) {
      problem = error.what();
      return {};
    }
    progress.advance();
  }
  return drawn;
}

std::vector<verify::Judged> judge_random_chains(const VerifyOptions& options,
                                                std::optional<work::Journal>& unfinished) {
  Progress progress("random chains", options.chains);
  return verify::judge_sampled(
      verify::check_random_chains(options.chains, options.seed, unfinished ? &*unfinished : nullptr,
                                  [&](std::size_t more) { progress.advance(more); }),
      options.seed);
}

/// The table of the core alone.
void print_core(const VerifyOptions& options) {
  const std::size_t chains = options.chains > 0 ? options.chains : 100;
  Progress progress("random chains", chains);
  const verify::CoreTable table = verify::core_table(chains, options.seed, [&] { progress.advance(); });
  fmt::print("{}", verify::as_text(table));
  if (!verify::holds(table)) throw CLI::RuntimeError(1);
}

void run(const VerifyOptions& options, const CLI::App& verb) {
  if (options.core) return print_core(options);
  Outputs outputs(verb, files_of(options.folder));
  const std::string form = std::filesystem::path(options.errata).extension();
  if (!options.errata.empty() && form != ".md" && form != ".tex")
    throw Error("--errata", options.errata, "a file that ends in .md or .tex");
  files::OutputFile* const json = outputs.open("--json", options.json);
  files::OutputFile* const html = outputs.open("--html", options.html);
  files::OutputFile* const errata = outputs.open("--errata", options.errata);
  std::optional<work::Journal> unfinished;
  if (!options.unfinished.empty())
    unfinished.emplace(options.unfinished,
                       fmt::format("plumbline verify --chains {} --seed {}", options.chains, options.seed));
  const verify::Paper& paper = paper_of(options);
  const std::vector<verify::Claim> claims = verify::in_section(paper.claims, options.section);
  const bool one = !options.claim.empty();
  std::vector<verify::Claim> all = claims;
  if (one) all.insert(all.end(), paper.facts.begin(), paper.facts.end());
  const std::vector<verify::Claim> chosen = one ? verify::with_id(all, options.claim) : claims;
  std::vector<verify::Judged> judged;
  {
    Progress progress("claims", chosen.size());
    judged = verify::judge(chosen, options.precision, [&] { progress.advance(); });
  }
  if (options.chains > 0) {
    const std::vector<verify::Judged> properties = judge_random_chains(options, unfinished);
    judged.insert(judged.end(), properties.begin(), properties.end());
  }
  const page::Provenance& from = outputs.provenance();
  if (json) json->write(page::json_text({{"claims", as_json(judged)}}, from));
  if (html) {
    const bool whole = !one && options.section.empty() && options.folder.empty();
    std::string problem;
    const auto figures = whole ? draw_figures(judged, problem) : std::vector<verify::DrawnFigure>{};
    if (!problem.empty()) fmt::print(stderr, "plumbline: the page has no figures: {}\n", problem);
    html->write(page::on_page(verify::as_html(paper, judged, figures), from));
  }
  if (errata)
    errata->write(form == ".md" ? page::in_markdown(verify::errata_as_markdown(paper, judged), from)
                                : page::in_latex(verify::errata_as_latex(paper, judged), from));
  outputs.commit();
  if (unfinished) unfinished->finish();
  if (!json && !html && !errata)
    fmt::print("{}", one ? verify::as_detail(judged.front(), with_colour())
                         : verify::as_table(paper, judged, {with_colour(), terminal_columns(1)}));
  const std::vector<std::string> problems =
      errata ? verify::errata(paper, judged).problems() : std::vector<std::string>{};
  for (const std::string& problem : problems) fmt::print(stderr, "plumbline: not held: {}\n", problem);
  const bool open =
      std::any_of(judged.begin(), judged.end(), [](const verify::Judged& j) { return !j.judgement; });
  if (open || !problems.empty()) throw CLI::RuntimeError(1);
}

}  // namespace

void add_verify(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("verify", "Every claim of the paper, or of another, judged, with the evidence");
  const auto options = std::make_shared<VerifyOptions>();
  verb->add_option("paper", options->folder, "Another paper on chains: the folder that states its claims")
      ->type_name("PAPER");
  verb->add_flag(
      "--core", options->core,
      "What the core reproduces of straight chains, in double and in 50 digits, on 100 random chains or "
      "as many as --chains says");
  verb->add_option("--section", options->section, "Only the claims of one section, such as 4.1")
      ->type_name("S");
  verb->add_option("--claim", options->claim, "Everything about one claim")
      ->type_name("ID")
      ->excludes("--section");
  verb->add_option("--precision", options->precision, "Significant digits of the values")
      ->capture_default_str()
      ->check(whole_number(1, 50));
  verb->add_option("--chains", options->chains,
                   "Check what is proved of every chain on so many random ones as well")
      ->check(whole_number(0, 10000000000))
      ->type_name("N")
      ->excludes("--claim");
  add_output(*verb, "--unfinished", options->unfinished,
             "Keep in FILE what is done of --chains until all is: the same command, begun again after it was "
             "cut off, goes on there")
      ->needs("--chains");
  verb->add_option("--seed", options->seed, "Which random chains")
      ->check(whole_number(0))
      ->capture_default_str();
  add_printed_output(*verb, "--json", options->json,
                     "Write the claims as JSON (without FILE: to standard output)");
  add_output(*verb, "--html", options->html,
             "Write the claims as a page, of the whole paper with its figures redrawn");
  add_output(*verb, "--errata", options->errata,
             "Write what is to be corrected as a document to send, in Markdown or in LaTeX", "FILE.md|.tex");
  verb->footer(
      "A refuted claim of the paper is a finding, not a failure: the exit status is 1 only when a claim "
      "could not "
      "be judged, nothing holds what an erratum says, two number types disagree, or a random chain "
      "contradicts a "
      "theorem.");
  verb->callback([options, verb] { run(*options, *verb); });
}

}  // namespace plumbline::app
