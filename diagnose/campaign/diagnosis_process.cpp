#include "diagnose/campaign/diagnosis_process.hpp"

#include "support/files/child_process.hpp"
#include "support/files/experiment_files.hpp"
#include "support/files/printable.hpp"
#include "support/files/temporary_folder.hpp"

namespace plumbline::campaign {
namespace {

namespace fs = std::filesystem;

void copy_experiment(const fs::path& from, const fs::path& to) {
  fs::create_directory(to);
  for (const fs::path& file : files::experiment_files(from)) {
    fs::create_directories((to / file).parent_path());
    fs::copy_file(from / file, to / file, fs::copy_options::overwrite_existing);
  }
}

}  // namespace

Diagnosed run_diagnosis(const fs::path& executable, const fs::path& folder,
                        const std::vector<std::string>& words,
                        std::optional<std::chrono::duration<double>> patience, const fs::path& here) {
  std::vector<std::string> command{executable.string(), "diagnose", folder.string()};
  command.insert(command.end(), words.begin(), words.end());
  const auto begin = std::chrono::steady_clock::now();
  const files::Ended diagnosis = files::run_program(command, "", patience, here);
  Diagnosed result;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.failure = diagnosis.failure;
  const std::string complaint = files::printable(diagnosis.err.substr(0, diagnosis.err.find('\n')));
  if (!result.failure.empty() && !complaint.empty()) result.failure += ": " + complaint;
  return result;
}

Diagnosed diagnose_alone(const fs::path& executable, const fs::path& experiment, const fs::path& report,
                         std::chrono::duration<double> patience) {
  const files::TemporaryFolder chamber;
  Diagnosed result;
  try {
    copy_experiment(experiment, chamber / "experiment");
  } catch (const fs::filesystem_error& error) {
    result.failure = error.path1().string() + ": " + error.code().message();
    return result;
  }
  return run_diagnosis(executable, "experiment", {"--json", fs::absolute(report).string()}, patience,
                       chamber.path());
}

}  // namespace plumbline::campaign
