#include "campaign/outcome.hpp"

#include <algorithm>
#include <plumbline/base/parallel.hpp>

#include "files/json_file.hpp"
#include "files/text_file.hpp"
#include "trial/diagnosis_process.hpp"

namespace plumbline::campaign {
namespace {

namespace fs = std::filesystem;

Outcome diagnose(const fs::path& folder, const std::string& name, const Work& work) {
  Outcome outcome{name, {}, "", {}};
  const fs::path report = work.reports / (name + ".json");
  std::vector<std::string> words = work.words;
  words.insert(words.end(), {"--json", report.string()});
  if (work.pages) words.insert(words.end(), {"--html", (work.reports / (name + ".html")).string()});
  outcome.failure = trial::run_diagnosis(work.executable, folder, words).failure;
  if (!outcome.failure.empty()) return outcome;
  try {
    outcome.report = trial::report_from(files::parse_json(files::read_text(report), name), name);
  } catch (const std::exception& error) {
    outcome.failure = error.what();
  }
  return outcome;
}

}  // namespace

std::vector<std::string> names_of(const std::vector<fs::path>& folders) {
  std::vector<std::string> names;
  std::vector<fs::path> around;
  for (const fs::path& folder : folders) {
    fs::path whole = fs::weakly_canonical(folder);
    if (!whole.has_filename()) whole = whole.parent_path();  // "folder/"
    names.push_back(whole.filename().string());
    around.push_back(whole.parent_path());
  }
  const auto twice = [&](const std::string& name) {
    return std::count(names.begin(), names.end(), name) > 1;
  };
  for (bool again = true; again;) {
    again = false;
    std::vector<std::string> longer = names;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!twice(names[i]) || !around[i].has_filename()) continue;
      longer[i] = around[i].filename().string() + "-" + names[i];
      around[i] = around[i].parent_path();
      again = true;
    }
    names = longer;
  }
  return names;
}

std::vector<Outcome> diagnose_all(const std::vector<fs::path>& folders, const Work& work,
                                  const std::function<void()>& advance) {
  const std::vector<std::string> names = names_of(folders);
  std::vector<Outcome> all(folders.size());
  in_parallel(folders.size(), work.processes, [&](std::size_t i) {
    all[i] = diagnose(folders[i], names[i], work);
    advance();
  });
  return all;
}

}  // namespace plumbline::campaign
