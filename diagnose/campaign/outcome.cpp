#include "diagnose/campaign/outcome.hpp"

#include <algorithm>

#include "diagnose/campaign/diagnoses.hpp"
#include "support/files/json_file.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::campaign {
namespace {

namespace fs = std::filesystem;

Outcome outcome(const std::string& name, const fs::path& report, const Diagnosed& diagnosed) {
  Outcome one{name, {}, diagnosed.failure, {}};
  if (!one.failure.empty()) return one;
  try {
    one.report = report_from(files::parse_json(files::read_text(report), name), name);
  } catch (const std::exception& error) {
    one.failure = error.what();
  }
  return one;
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
  std::vector<Assignment> assignments;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    Assignment one{folders[i], work.reports / (names[i] + ".json"), work.words, work.inputs};
    if (work.pages)
      one.words.insert(one.words.end(), {"--html", (work.reports / (names[i] + ".html")).string()});
    assignments.push_back(std::move(one));
  }
  const std::vector<Diagnosed> diagnosed = diagnose_all(assignments, work.journal, advance);
  std::vector<Outcome> all;
  for (std::size_t i = 0; i < folders.size(); ++i)
    all.push_back(outcome(names[i], assignments[i].report, diagnosed[i]));
  return all;
}

}  // namespace plumbline::campaign
