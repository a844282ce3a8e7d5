#include "trial/run_trial.hpp"

#include "support/files/json_file.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::trial {
namespace {

Judgement judgement_of(const Label& label, const std::filesystem::path& report,
                       const campaign::Diagnosed& diagnosed) {
  Judgement none;
  none.said = diagnosed.failure;
  if (!diagnosed.failure.empty()) return none;
  const std::string name = report.filename().string();
  try {
    return judge(label, campaign::report_from(files::parse_json(files::read_text(report), name), name));
  } catch (const std::exception& error) {  // no JSON, or not that of a report
    none.said = error.what();
    return none;
  }
}

}  // namespace

std::vector<campaign::Diagnosed> diagnose_all(const SealedFolder& folder,
                                              const std::filesystem::path& reports,
                                              std::chrono::duration<double> patience, work::Journal* journal,
                                              const std::function<void()>& advance) {
  std::filesystem::create_directories(reports);
  std::vector<campaign::Assignment> assignments;
  for (const std::string& name : folder.names())
    assignments.push_back({folder.experiment(name), reports / (name + ".json"), {}, {}, patience});
  return campaign::diagnose_all(assignments, journal, advance);
}

std::vector<Case> unseal(const SealedFolder& folder, const std::filesystem::path& reports,
                         const std::vector<campaign::Diagnosed>& diagnosed, const Catalogue& catalogue) {
  std::vector<Case> cases;
  for (std::size_t i = 0; i < diagnosed.size(); ++i) {
    const std::string& name = folder.names()[i];
    Case one = folder.open(name);
    one.label = in_terms_of(catalogue, std::move(one.label));
    one.judgement = judgement_of(one.label, reports / (name + ".json"), diagnosed[i]);
    one.seconds = diagnosed[i].seconds;
    cases.push_back(std::move(one));
  }
  return cases;
}

}  // namespace plumbline::trial
