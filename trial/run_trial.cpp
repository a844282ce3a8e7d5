#include "trial/run_trial.hpp"

#include <plumbline/base/parallel.hpp>

#include "files/json_file.hpp"
#include "files/text_file.hpp"

namespace plumbline::trial {
namespace {

Judgement judgement_of(const Label& label, const std::filesystem::path& report, const Diagnosed& diagnosed) {
  Judgement none;
  none.said = diagnosed.failure;
  if (!diagnosed.failure.empty()) return none;
  const std::string name = report.filename().string();
  try {
    return judge(label, report_from(files::parse_json(files::read_text(report), name), name));
  } catch (const std::exception& error) {  // no JSON, or not that of a report
    none.said = error.what();
    return none;
  }
}

}  // namespace

AllDiagnosed diagnose_all(const SealedFolder& folder, const std::filesystem::path& executable,
                          const std::filesystem::path& reports, std::chrono::duration<double> patience,
                          unsigned processes, const std::function<void()>& advance) {
  std::filesystem::create_directories(reports);
  const std::vector<std::string>& names = folder.names();
  AllDiagnosed all(names.size());
  in_parallel(names.size(), processes, [&](std::size_t i) {
    all[i] =
        diagnose_alone(executable, folder.experiment(names[i]), reports / (names[i] + ".json"), patience);
    advance();
  });
  return all;
}

std::vector<Case> unseal(const SealedFolder& folder, const std::filesystem::path& reports,
                         const AllDiagnosed& diagnosed, const Catalogue& catalogue) {
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
